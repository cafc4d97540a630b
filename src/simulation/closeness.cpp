// SPDX-License-Identifier: Apache-2.0
//     pose:    r = sqrt(w) [a sin theta, (p - p0)/s],    phi = w/2 (4 sin^2(theta/2) + |p - p0|^2/s^2)
//     marker:  r = sqrt(w) (x - x0)
// with a the axis in Ground about which the body is turned away by theta. The rate of phi is r . r' exactly, with
// r' = sqrt(w) [w, v/s] in place of the rate of a sin theta: by this metric all directions of a turn cost the same.
#include "simulation/closeness.h"

#include <algorithm>
#include <cmath>

#include "simulation/position_condition.h"

namespace jprim {

using Eigen::VectorXd;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;

namespace {

// The half-angle vector a sin(theta/2) of the turn from the goal's orientation.
SimTK::Quaternion findTurn(const Rotation& R, const Rotation& goal) {
    return (R * ~goal).convertRotationToQuaternion();
}

}  // namespace

Real Closeness::calcValue(const State& state) const {
    Real sum = 0;
    for (const PoseGoal& goal : m_poses) {
        const SimTK::Transform& X_GB = m_matter.getMobilizedBody(goal.body).getBodyTransform(state);
        const SimTK::Quaternion q = findTurn(X_GB.R(), goal.X_GB.R());
        const Real turned = 4 * Vec3(q[1], q[2], q[3]).normSqr();
        sum += goal.weight / 2 * (turned + ((X_GB.p() - goal.X_GB.p()) / goal.size).normSqr());
    }
    for (const MarkerGoal& goal : m_markers)
        sum += goal.weight / 2 * (goal.marker.findPoseInGround(state).p() - goal.place).normSqr();
    return sum;
}

VectorXd Closeness::calcResiduals(const State& state) const {
    VectorXd r(6 * m_poses.size() + 3 * m_markers.size());
    int row = 0;
    const auto add = [&](const Vec3& v) {
        for (int k = 0; k < 3; ++k) r[row++] = v[k];
    };
    for (const PoseGoal& goal : m_poses) {
        const SimTK::Transform& X_GB = m_matter.getMobilizedBody(goal.body).getBodyTransform(state);
        const SimTK::Quaternion q = findTurn(X_GB.R(), goal.X_GB.R());
        add(std::sqrt(goal.weight) * 2 * q[0] * Vec3(q[1], q[2], q[3]));
        add(std::sqrt(goal.weight) / goal.size * (X_GB.p() - goal.X_GB.p()));
    }
    for (const MarkerGoal& goal : m_markers)
        add(std::sqrt(goal.weight) * (goal.marker.findPoseInGround(state).p() - goal.place));
    return r;
}

Eigen::SparseMatrix<double> Closeness::calcJacobian(const State& state, const BodyJacobian& bodies) const {
    BodyJacobian::Triplets entries;
    int row = 0;
    for (const PoseGoal& goal : m_poses) {
        const double factor = std::sqrt(goal.weight);
        bodies.addBody(goal.body, factor, factor / goal.size, row, entries);
        row += 6;
    }
    for (const MarkerGoal& goal : m_markers)
        for (int k = 0; k < 3; ++k, ++row) {
            Directions directions(m_matter, state);
            Vec3 axis(0);
            axis[k] = 1;
            goal.marker.applyLoad(state, SpatialVec(Vec3(0), axis), directions.onBodies, directions.onSpeeds);
            bodies.addRow(directions.getNonzero(), std::sqrt(goal.weight), row, entries);
        }
    Eigen::SparseMatrix<double> jacobian(row, state.getNU());
    jacobian.setFromTriplets(entries.begin(), entries.end());
    return jacobian;
}

Real Closeness::calcLargestTurn(const State& state, const VectorXd& u) const {
    SimTK::Vector_<SpatialVec> V;
    m_matter.multiplyBySystemJacobian(state, SimTK::Vector(int(u.size()), u.data()), V);
    Real largest = 0;
    for (const PoseGoal& goal : m_poses) largest = std::max(largest, V[goal.body][0].norm());
    return largest;
}

Real Closeness::calcSize(const EquationLoads& loads) const {
    Real sum = 0;
    for (const auto& [body, F] : loads.onBodies) {
        const auto goal = m_goalOfBody.find(body);
        if (goal == m_goalOfBody.end()) continue;
        const auto& [weight, size] = goal->second;
        if (weight > 0) sum += (F[0].normSqr() + SimTK::square(size) * F[1].normSqr()) / weight;
    }
    return std::sqrt(sum);
}

}  // namespace jprim
