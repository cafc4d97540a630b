// SPDX-License-Identifier: Apache-2.0
#include "mechanism/kinetic_energy.h"

#include <optional>

#include "linear_algebra/conversion.h"
#include "linear_algebra/eigenvalues.h"
#include "linear_algebra/equations.h"

namespace jprim {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using SimTK::Matrix;
using SimTK::State;

namespace {

// The given positions, or if they are near enough to fit the constraints those that do; nothing if there the constraints
// cannot be told.
std::optional<State> findPositions(const Mechanism& mechanism) {
    constexpr double Tolerance = 1e-6;
    const SimTK::MultibodySystem& system = mechanism.getSystem();
    std::optional<State> found;
    try {
        State state = mechanism.makeGivenState();
        system.realize(state, SimTK::Stage::Velocity);
        found = state;
        system.project(state, Tolerance);
        found = state;
    } catch (const std::exception&) {
        // What is wrong with the positions is for those to say who look for right ones.
    }
    if (found) system.realize(*found, SimTK::Stage::Velocity);
    return found;
}

// A basis of the motions that constraints allow, by columns.
MatrixXd calcAllowedMotions(const SimTK::SimbodyMatterSubsystem& matter, const State& state) {
    constexpr double Noise = 1e-9, Dependent = 1e-8;
    Matrix G;
    matter.calcG(state, G);
    const MatrixXd rows = toEigen(G);
    if (rows.size() == 0) return MatrixXd::Identity(state.getNU(), state.getNU());
    return calcKernel((rows.array().abs() > Noise).select(rows, 0), Dependent);
}

// The angular velocity of a body in its own axes in each of the motions Z.
MatrixXd calcTurns(const SimTK::MobilizedBody& body, const State& state, const MatrixXd& Z) {
    MatrixXd turns(3, Z.cols());
    for (Eigen::Index k = 0; k < Z.cols(); ++k) {
        SimTK::Vector_<SimTK::SpatialVec> V;
        const VectorXd u = Z.col(k);
        body.getMatterSubsystem().multiplyBySystemJacobian(state, toSimTK(u), V);
        const SimTK::Vec3 w = ~body.getBodyRotation(state) * V[body.getMobilizedBodyIndex()][0];
        turns.col(k) << w[0], w[1], w[2];
    }
    return turns;
}

// What is to be added to a tensor of inertia to make its negative moments zero.
Matrix3d calcNegativePart(const Matrix3d& inertia) {
    const PrincipalAxes principal = calcPrincipalAxes(inertia);
    const Eigen::Vector3d moments = (-principal.values).cwiseMax(0);
    return principal.axes * moments.asDiagonal() * principal.axes.transpose();
}

}  // namespace

std::vector<bool> findHarmful(const Mechanism& mechanism, const std::vector<NegativeInertia>& inertias) {
    constexpr double Nothing = 1e-6, Noise = 1e-9;  // of the energy with moments taken positive
    const SimTK::SimbodyMatterSubsystem& matter = mechanism.getMatter();
    std::vector<bool> harmful(inertias.size(), false);
    const std::optional<State> state = findPositions(mechanism);
    if (!state) return harmful;
    const MatrixXd Z = calcAllowedMotions(matter, *state);
    if (Z.cols() == 0) return harmful;

    Matrix M;
    matter.calcM(*state, M);
    const MatrixXd energy = Z.transpose() * toEigen(M) * Z;
    MatrixXd positive = energy;
    std::vector<MatrixXd> turns;
    for (const NegativeInertia& negative : inertias) {
        turns.push_back(calcTurns(negative.body, *state, Z));
        positive += 2 * turns.back().transpose() * calcNegativePart(toEigen(negative.inertia)) * turns.back();
    }
    const std::optional<Eigenvectors> solution = calcEigenvectors(energy, positive);
    if (!solution) return harmful;
    for (Eigen::Index k = 0; k < Z.cols() && solution->values[k] < Nothing; ++k)
        for (size_t i = 0; i < inertias.size(); ++i) {
            const Eigen::Vector3d w = turns[i] * solution->vectors.col(k);
            if (w.dot(toEigen(inertias[i].inertia) * w) < -Noise) harmful[i] = true;
        }
    return harmful;
}

}  // namespace jprim
