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
//
// States s of control systems with ds/dt = g go the same way, (1/h - dg/ds) ds = g + dg/dz dz, and are eliminated from the
// steps of the mechanism: their derivatives become zero as the forces come into balance.
#include "jprim/simulation/equilibrium.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"
#include "linear_algebra/conversion.h"
#include "linear_algebra/equations.h"
#include "linear_algebra/orthogonal.h"
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
        for (size_t k = 0; k < mechanism.getStates().size(); ++k)
            if (!mechanism.getStates()[k].staticHold) m_free.push_back(int(k));
        m_largestRates = VectorXd::Zero(Eigen::Index(m_free.size()));
        settle(m_state);
    }

    State run() {
        Real first = 0, last = 0, lastStates = 0;
        for (int k = 0; k < MostSteps; ++k) {
            linearize();
            const Real states = calcImbalanceOfStates();
            const VectorXd accelerations = solveSymmetric(m_M, m_r);
            const Real size = accelerations.size() > 0 ? accelerations.cwiseAbs().maxCoeff() : 0;
            if (k == 0) {
                first = size + m_mechanism.getGravity().norm();
                m_h = size > 0 ? LongestStep / size : 1;
            } else if (size > 0 || states > 0) {
                const Real fall = std::min(size > 0 ? last / size : SimTK::Infinity,
                                           states > 0 ? lastStates / states : SimTK::Infinity);
                m_h *= std::clamp(2 * fall, 0.3, 10.);
            }
            if (size <= EquilibriumTolerance * first && states <= EquilibriumTolerance) return m_state;
            last = size;
            lastStates = states;
            step();
        }
        throw Error("equilibrium", fmt::format("none was found from here; {}", describeMoving(last, first)));
    }

private:
    // At rest, on the constraints.
    void settle(State& state) const {
        m_mechanism.getSystem().realize(state, Stage::Velocity);
        m_mechanism.getSystem().project(state, ProjectionTolerance);
        state.updU() = 0;
        realize(state);
    }

    void realize(State& state) const {
        m_mechanism.getSystem().realize(state, m_free.empty() ? Stage::Dynamics : Stage::Acceleration);
    }

    VectorXd getRates(const State& state) const {
        VectorXd rates(Eigen::Index(m_free.size()));
        for (size_t k = 0; k < m_free.size(); ++k) rates[Eigen::Index(k)] = state.getZDot()[m_free[k]];
        return rates;
    }

    // The largest rate of a state, of all that its parts are as large as.
    Real calcImbalanceOfStates() {
        constexpr Real Small = 1e-3;
        Real worst = 0;
        m_worstState = 0;
        for (Eigen::Index k = 0; k < m_g.size(); ++k) {
            m_largestRates[k] = std::max(m_largestRates[k], std::abs(m_g[k]));
            Real parts = m_largestRates[k];
            for (Eigen::Index j = 0; j < m_g.size(); ++j)
                parts += std::abs(m_Gs(k, j)) * std::max(Small, std::abs(m_state.getZ()[m_free[size_t(j)]]));
            if (m_Gz.cols() > 0) parts += m_Gz.row(k).cwiseAbs().maxCoeff();
            if (parts == 0 || std::abs(m_g[k]) <= worst * parts) continue;
            worst = std::abs(m_g[k]) / parts;
            m_worstState = size_t(k);
        }
        return worst;
    }

    // Generalized applied forces at rest.
    VectorXd calcForces(const State& state) const {
        if (state.getNU() == 0) return VectorXd(0);
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
        m_g = getRates(m_state);
        m_Gz.resize(m_g.size(), m_Z.cols());
        m_M.resize(m_Z.cols(), m_Z.cols());
        m_K.resize(m_Z.cols(), m_Z.cols());
        MatrixXd turns(3 * Eigen::Index(m_mechanism.getParts().size()), m_Z.cols());
        for (Eigen::Index k = 0; k < m_Z.cols(); ++k) {
            Vector column;
            m_matter.multiplyByM(m_state, toSimTK(m_Z.col(k)), column);
            m_M.col(k) = m_Z.transpose() * toEigen(column);
            turns.col(k) = calcTurns(m_Z.col(k));
            State ahead = m_state, behind = m_state;
            move(Difference * m_Z.col(k), ahead);
            move(-Difference * m_Z.col(k), behind);
            const VectorXd change = calcBalance(ahead, lambda) - calcBalance(behind, lambda);
            m_K.col(k) = -m_Z.transpose() * change / (2 * Difference);
            m_Gz.col(k) = (getRates(ahead) - getRates(behind)) / (2 * Difference);
        }
        m_M += turns.transpose() * turns;
        linearizeStates(lambda);
    }

    void linearizeStates(const VectorXd& lambda) {
        m_Gs.resize(m_g.size(), m_g.size());
        m_Fs.resize(m_Z.cols(), m_g.size());
        for (Eigen::Index k = 0; k < m_g.size(); ++k) {
            const int z = m_free[size_t(k)];
            const Real difference = Difference * std::max(Real(1), std::abs(m_state.getZ()[z]));
            State ahead = m_state, behind = m_state;
            ahead.updZ()[z] += difference;
            behind.updZ()[z] -= difference;
            const VectorXd change = calcBalance(ahead, lambda) - calcBalance(behind, lambda);
            m_Fs.col(k) = m_Z.transpose() * change / (2 * difference);
            m_Gs.col(k) = (getRates(ahead) - getRates(behind)) / (2 * difference);
        }
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

    // f + ~G lambda nearby.
    VectorXd calcBalance(State& state, const VectorXd& lambda) const {
        realize(state);
        VectorXd balance = calcForces(state);
        if (lambda.size() == 0) return balance;
        Vector all(m_matter.getNMultipliers(state), Real(0)), constraintForces;
        all(0, int(lambda.size())) = toSimTK(lambda);
        m_matter.multiplyByGTranspose(state, all, constraintForces);
        return balance + toEigen(constraintForces);
    }

    void move(const VectorXd& displacement, State& state) const {
        if (displacement.size() == 0) return;
        Vector change;
        m_matter.multiplyByN(m_state, false, toSimTK(displacement), change);
        state.updQ() += change;
        state.updU() = 0;
    }

    void step() {
        constexpr int MostReductions = 100;
        std::optional<VectorXd> dz;
        for (int k = 0; k < MostReductions && !dz; ++k) {
            dz = m_free.empty() ? solveDefinite(m_M / m_h + (m_K + m_K.transpose()) / 2, m_r)
                                : solveWithStates();
            if (!dz) m_h /= 4;
        }
        if (!dz || !dz->allFinite()) throw Error("equilibrium", "the forces are not finite");
        VectorXd displacement = m_Z * *dz;
        const Real size = displacement.size() > 0 ? displacement.cwiseAbs().maxCoeff() : 0;
        const Real part = size > LongestStep ? LongestStep / size : 1;
        move(part * displacement, m_state);
        if (!m_free.empty()) moveStates(part * *dz);
        settle(m_state);
        m_state.autoUpdateDiscreteVariables();  // the way goes on for whole turns
    }

    // The steps of states are `follow`, and what steps of the mechanism add.
    std::optional<VectorXd> solveWithStates() {
        constexpr Real Threshold = 1e-14;
        const MatrixXd A = MatrixXd::Identity(m_g.size(), m_g.size()) / m_h - m_Gs;
        m_follow = solveLeastNorm(A, m_g, Threshold);
        m_followZ.resize(m_g.size(), m_Z.cols());
        for (Eigen::Index k = 0; k < m_Z.cols(); ++k)
            m_followZ.col(k) = solveLeastNorm(A, m_Gz.col(k), Threshold);
        if (m_Z.cols() == 0) return VectorXd(0);
        const MatrixXd S = m_M / m_h + m_K - m_Fs * m_followZ;
        const VectorXd r = m_r + m_Fs * m_follow;
        if (!isPositiveDefinite((S + S.transpose()) / 2)) return std::nullopt;
        return solveLeastNorm(S, r, Threshold);
    }

    void moveStates(const VectorXd& dz) {
        const VectorXd steps = m_follow + m_followZ * dz;
        for (size_t k = 0; k < m_free.size(); ++k) m_state.updZ()[m_free[k]] += steps[Eigen::Index(k)];
    }

    std::string describeMoving(Real last, Real first) {
        if (last <= EquilibriumTolerance * first && !m_free.empty())
            return fmt::format("{} goes on changing",
                               m_mechanism.getStates()[size_t(m_free[m_worstState])].name);
        return findMoving() + " still moves";
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

    std::vector<int> m_free;  // states that are not held
    VectorXd m_g, m_largestRates;
    MatrixXd m_Gz, m_Gs, m_Fs;
    VectorXd m_follow;
    MatrixXd m_followZ;
    size_t m_worstState = 0;
};

}  // namespace

State findEquilibrium(const Mechanism& mechanism, const State& start) {
    State state = EquilibriumSearch(mechanism, start).run();
    mechanism.getSystem().realize(state, Stage::Acceleration);
    return state;
}

}  // namespace jprim
