// SPDX-License-Identifier: Apache-2.0
// Pseudo-transient continuation: implicit steps of the overdamped motion M dq/ds = f, along the constraints.
// With Z the directions that constraints leave free, f the applied forces at rest and lambda the multipliers
// that balance them best,
//
//     r = ~Z f,    K = -d(~Z (f + ~G lambda))/dz,    (~Z M Z / h + K) dz = r
//
// Time is no matter, so M is that of parts with the inertia of their mass at the distance of their size besides their
// own: what hardly resists a turn, as a rod one about itself, then neither rushes ahead nor keeps moving by rounding
// errors. For small h it goes downhill like the motion itself, for large h it is Newton's method. h grows as r falls;
// where the matrix is not positive definite, h is too large to go downhill and is made smaller.
#include "jprim/simulation/equilibrium.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"
#include "linear_algebra/conversion.h"
#include "linear_algebra/equations.h"
#include "linear_algebra/ranked_rows.h"
#include "simulation/constraint_jacobian.h"
#include "simulation/projection.h"

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using SimTK::Real;
using SimTK::Stage;
using SimTK::State;
using SimTK::Vector;

namespace {

constexpr int MostSteps = 1000;
constexpr Real LongestStep = 0.2;  // of a coordinate: length units, radians
constexpr Real Difference = 1e-6;  // for K

class EquilibriumSearch {
public:
    EquilibriumSearch(const Mechanism& mechanism, const State& start)
        : m_mechanism(mechanism), m_matter(mechanism.getMatter()), m_state(start) {
        settle(m_state);
    }

    State run() {
        Real first = 0, last = 0;
        for (int k = 0; k < MostSteps; ++k) {
            linearize();
            const VectorXd accelerations = solveSymmetric(m_M, m_r);
            const Real size = accelerations.size() > 0 ? accelerations.cwiseAbs().maxCoeff() : 0;
            if (k == 0) {
                first = size + m_mechanism.getGravity().norm();
                m_h = size > 0 ? LongestStep / size : 1;
            } else if (size > 0) {
                m_h *= std::clamp(2 * last / size, 0.3, 10.);
            }
            if (size <= EquilibriumTolerance * first) return m_state;
            last = size;
            step();
        }
        throw Error("equilibrium", fmt::format("none was found from here; {} still moves", findMoving()));
    }

private:
    // At rest, on the constraints.
    void settle(State& state) const {
        m_mechanism.getSystem().realize(state, Stage::Velocity);
        m_mechanism.getSystem().project(state, ProjectionTolerance);
        state.updU() = 0;
        m_mechanism.getSystem().realize(state, Stage::Dynamics);
    }

    // Generalized applied forces at rest.
    VectorXd calcForces(const State& state) const {
        Vector residual;
        m_matter.calcResidualForceIgnoringConstraints(
            state, m_mechanism.getSystem().getMobilityForces(state, Stage::Dynamics),
            m_mechanism.getSystem().getRigidBodyForces(state, Stage::Dynamics), Vector(), residual);
        return -toEigen(residual);
    }

    void linearize() {
        const VectorXd f = calcForces(m_state);
        const SpeedEquations equations(m_mechanism, m_state);
        const RankedRows rows(equations.getG());
        m_Z = rows.calcNullSpace();
        m_r = m_Z.transpose() * f;
        const VectorXd lambda = equations.unscale(-rows.solveTransposed(f));
        m_M.resize(m_Z.cols(), m_Z.cols());
        m_K.resize(m_Z.cols(), m_Z.cols());
        MatrixXd turns(3 * Eigen::Index(m_mechanism.getParts().size()), m_Z.cols());
        for (Eigen::Index k = 0; k < m_Z.cols(); ++k) {
            Vector column;
            m_matter.multiplyByM(m_state, toSimTK(m_Z.col(k)), column);
            m_M.col(k) = m_Z.transpose() * toEigen(column);
            turns.col(k) = calcTurns(m_Z.col(k));
            const VectorXd change =
                calcBalance(Difference * m_Z.col(k), lambda) - calcBalance(-Difference * m_Z.col(k), lambda);
            m_K.col(k) = -m_Z.transpose() * change / (2 * Difference);
        }
        m_M += turns.transpose() * turns;
    }

    // The angular velocities of all parts at speeds u, times the root of the inertia they are given in the search.
    VectorXd calcTurns(const VectorXd& u) const {
        SimTK::Vector_<SimTK::SpatialVec> motions;
        m_matter.multiplyBySystemJacobian(m_state, toSimTK(u), motions);
        VectorXd turns = VectorXd::Zero(3 * Eigen::Index(m_mechanism.getParts().size()));
        Eigen::Index row = 0;
        for (const MechanismPart& part : m_mechanism.getParts()) {
            const Real weight = part.ground ? 0 : part.size * std::sqrt(part.body.getBodyMass(m_state));
            const SimTK::Vec3 turn = weight * motions[part.body.getMobilizedBodyIndex()][0];
            for (int k = 0; k < 3; ++k) turns[row++] = turn[k];
        }
        return turns;
    }

    // f + ~G lambda at a position nearby.
    VectorXd calcBalance(const VectorXd& displacement, const VectorXd& lambda) const {
        State state = m_state;
        move(displacement, state);
        m_mechanism.getSystem().realize(state, Stage::Dynamics);
        VectorXd balance = calcForces(state);
        if (lambda.size() == 0) return balance;
        Vector all(m_matter.getNMultipliers(state), Real(0)), constraintForces;
        all(0, int(lambda.size())) = toSimTK(lambda);
        m_matter.multiplyByGTranspose(state, all, constraintForces);
        return balance + toEigen(constraintForces);
    }

    void move(const VectorXd& displacement, State& state) const {
        Vector change;
        m_matter.multiplyByN(m_state, false, toSimTK(displacement), change);
        state.updQ() += change;
        state.updU() = 0;
    }

    void step() {
        constexpr int MostReductions = 100;
        std::optional<VectorXd> dz;
        for (int k = 0; k < MostReductions && !dz; ++k) {
            dz = solveDefinite(m_M / m_h + (m_K + m_K.transpose()) / 2, m_r);
            if (!dz) m_h /= 4;
        }
        if (!dz || !dz->allFinite()) throw Error("equilibrium", "the forces are not finite");
        VectorXd displacement = m_Z * *dz;
        const Real size = displacement.cwiseAbs().maxCoeff();
        if (size > LongestStep) displacement *= LongestStep / size;
        move(displacement, m_state);
        settle(m_state);
        m_state.autoUpdateDiscreteVariables();  // the way goes on for whole turns
    }

    // The part that is accelerated most.
    std::string findMoving() {
        m_mechanism.getSystem().realize(m_state, Stage::Acceleration);
        std::string name = "it";
        Real most = 0;
        for (const MechanismPart& part : m_mechanism.getParts()) {
            const SimTK::SpatialVec A = part.body.getBodyAcceleration(m_state);
            const Real size = A[1].norm() + part.size * A[0].norm();
            if (size <= most) continue;
            most = size;
            name = part.name;
        }
        return name;
    }

    const Mechanism& m_mechanism;
    const SimTK::SimbodyMatterSubsystem& m_matter;
    State m_state;
    MatrixXd m_Z, m_M, m_K;
    VectorXd m_r;
    Real m_h = 1;
};

}  // namespace

State findEquilibrium(const Mechanism& mechanism, const State& start) {
    State state = EquilibriumSearch(mechanism, start).run();
    mechanism.getSystem().realize(state, Stage::Acceleration);
    return state;
}

}  // namespace jprim
