// SPDX-License-Identifier: Apache-2.0
// Deviations from a motion q(t), u(t), with displacements dq = N dz in the frame N(q) of the mobilizers:
//
//     d(dz)/dt = du + W dz,    W dz = inverse of N ((dN along N dz) u - (dN along N u) dz)
//     d(du)/dt = change of the accelerations
//
// On the constraints, in scaled coordinates (dz = S dy), with orthonormal Z of displacements and V of speeds and U what
// displacements make of the speeds by the constraints:
//
//     dy = Z x1,    du = S (U x1 + V x2)
//     dx1/dt = ~Z ((U + W Z) x1 + V x2),    dx2/dt = ~V (change of the accelerations)/S
//
// Bases that are carried along across their own span only leave no further terms.
#include "jprim/simulation/linearize.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/format.h"
#include "jprim/analysis/constraint_report.h"
#include "jprim/base/error.h"
#include "linear_algebra/conversion.h"
#include "simulation/constraint_manifold.h"
#include "simulation/derivative.h"
#include "simulation/equation_access.h"
#include "simulation/redundancy.h"

namespace jprim {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using SimTK::Stage;
using SimTK::State;
using SimTK::Vector;

namespace {

// Columns of derivatives, each with its errors.
struct Derivatives {
    explicit Derivatives(Index rows) : values(rows, 0), errors(rows, 0) {}

    void add(const Derivative& column, double unit) {
        values.conservativeResize(Eigen::NoChange, values.cols() + 1);
        errors.conservativeResize(Eigen::NoChange, errors.cols() + 1);
        values.rightCols(1) = column.value / unit;
        errors.rightCols(1) = column.error / unit;
    }
    void addTransformed(const MatrixXd& T, const MatrixXd& moreValues, const MatrixXd& moreErrors) {
        values += T * moreValues;
        errors += T.cwiseAbs() * moreErrors;
    }

    MatrixXd values, errors;
};

class Linearization {
public:
    Linearization(const SimTK::MultibodySystem& system, const State& state, const ElementNames& names)
        : m_system(system),
          m_matter(system.getMatterSubsystem()),
          m_manifold(system, state),
          m_equations(findEquations(m_matter, m_manifold.getOrigin(), names)),
          m_origin(m_manifold.getOrigin()),
          m_scale(m_manifold.getScale()),
          m_Z(m_manifold.getDisplacements()),
          m_V(m_manifold.getSpeeds()),
          m_rates(m_origin.getNU() + m_origin.getNZ()),
          m_speedChanges(m_origin.getNU()) {}

    LinearModel run() {
        differentiateByDisplacements();
        differentiateBySpeeds();
        differentiateByZ();
        requireAllMet();
        return finish(findInfluential());
    }

private:
    Index getNumPositions() const { return m_Z.cols(); }
    Index getNumSpeeds() const { return m_V.cols(); }

    // Accelerations, scaled, and rates of z.
    VectorXd calcRates(const State& state) {
        m_system.realize(state, Stage::Acceleration);
        observe(state);
        VectorXd rates(m_scale.size() + state.getNZ());
        rates << toEigen(state.getUDot()).cwiseQuotient(m_scale), toEigen(state.getZDot());
        return rates;
    }

    void observe(const State& state) {
        if (state.getNU() > 0) m_fastest = std::max(m_fastest, state.getUDot().normInf());
        for (Index k = 0; k < m_violations.size(); ++k) {
            const double error = m_equations[size_t(k)].getError(state.getUDotErr());
            m_violations[k] = std::max(m_violations[k], std::abs(error));
        }
    }

    void requireAllMet() const {
        constexpr double Lost = 1e-6;
        Index worst = 0;
        if (m_violations.size() == 0 || m_violations.maxCoeff(&worst) <= Lost * m_fastest) return;
        throw Error(
            "linearize",
            fmt::format("accelerations nearby violate {}: masses and inertias are too different to solve for",
                        m_equations[size_t(worst)].element));
    }

    VectorXd getScaledSpeeds(const State& state) const {
        return toEigen(state.getU()).cwiseQuotient(m_scale);
    }

    VectorXd multiplyByN(const State& state, const VectorXd& z) const {
        Vector qDot;
        m_matter.multiplyByN(state, false, toSimTK(z), qDot);
        return toEigen(qDot);
    }

    // The rates, the speeds, and N u of the origin's u.
    VectorXd evaluate(const State& state) {
        const VectorXd rates = calcRates(state);
        VectorXd all(rates.size() + m_scale.size() + state.getNQ());
        all << rates, getScaledSpeeds(state), multiplyByN(state, toEigen(m_origin.getU()));
        return all;
    }

    void differentiateByDisplacements() {
        const VectorXd atOrigin = evaluate(m_origin);
        MatrixXd frameChanges(m_origin.getNQ(), getNumPositions());
        for (Index k = 0; k < getNumPositions(); ++k) {
            const Derivative column = differentiate(
                [&](double s) { return evaluate(m_manifold.displace(s * m_Z.col(k))); }, atOrigin);
            const Index numRates = m_rates.values.rows(), numSpeeds = m_scale.size();
            m_rates.add({column.value.head(numRates), column.error.head(numRates)}, 1);
            m_speedChanges.add(
                {column.value.segment(numRates, numSpeeds), column.error.segment(numRates, numSpeeds)}, 1);
            frameChanges.col(k) = column.value.tail(m_origin.getNQ());
        }
        m_kinematics = m_speedChanges.values;
        if (m_origin.getU().norm() > 0) m_kinematics += calcFrameTurning(frameChanges);
    }

    // W Z, scaled.
    MatrixXd calcFrameTurning(const MatrixXd& frameChanges) const {
        const VectorXd speeds = getScaledSpeeds(m_origin);
        const VectorXd along = multiplyByN(m_origin, toEigen(m_origin.getU()) / speeds.norm());
        const auto calcFrame = [&](double s) {
            State state = m_origin;
            state.updQ() += toSimTK(s * along);
            m_system.realize(state, Stage::Position);
            VectorXd all(m_origin.getNQ() * getNumPositions());
            for (Index k = 0; k < getNumPositions(); ++k)
                all.segment(k * m_origin.getNQ(), m_origin.getNQ()) =
                    multiplyByN(state, m_scale.cwiseProduct(m_Z.col(k)));
            return all;
        };
        const VectorXd carried = speeds.norm() * differentiate(calcFrame, calcFrame(0)).value;
        MatrixXd turning(m_scale.size(), getNumPositions());
        for (Index k = 0; k < getNumPositions(); ++k) {
            Vector u;
            const VectorXd difference =
                frameChanges.col(k) - carried.segment(k * m_origin.getNQ(), m_origin.getNQ());
            m_matter.multiplyByNInv(m_origin, false, toSimTK(difference), u);
            turning.col(k) = toEigen(u).cwiseQuotient(m_scale);
        }
        return turning;
    }

    // What a vibration of size 1 has, or the speed there is.
    double chooseSpeed() const {
        double speed = std::max(1., getScaledSpeeds(m_origin).norm());
        for (Index k = 0; k < getNumPositions(); ++k)
            speed = std::max(speed, std::sqrt(m_rates.values.col(k).head(m_scale.size()).norm()));
        return speed;
    }

    void differentiateBySpeeds() {
        const double speed = chooseSpeed();
        const VectorXd atOrigin = calcRates(m_origin);
        for (Index k = 0; k < getNumSpeeds(); ++k) {
            const auto f = [&](double s) {
                State state = m_origin;
                state.updU() += toSimTK(s * speed * m_scale.cwiseProduct(m_V.col(k)));
                return calcRates(state);
            };
            m_rates.add(differentiate(f, atOrigin), speed);
        }
    }

    void differentiateByZ() {
        const VectorXd atOrigin = calcRates(m_origin);
        for (int k = 0; k < m_origin.getNZ(); ++k) {
            const double unit = std::max(1., std::abs(m_origin.getZ()[k]));
            const auto f = [&](double s) {
                State state = m_origin;
                state.updZ()[k] += s * unit;
                return calcRates(state);
            };
            m_rates.add(differentiate(f, atOrigin), unit);
        }
    }

    // The z that change an acceleration, or the rate of one that does.
    std::vector<int> findInfluential() const {
        const Index first = getNumPositions() + getNumSpeeds(), n = m_scale.size();
        std::vector<bool> isFound(size_t(m_origin.getNZ()), false);
        const auto hasInfluence = [&](int k) {
            const VectorXd column = m_rates.values.col(first + k);
            if (!column.head(n).isZero(0)) return true;
            for (int other = 0; other < m_origin.getNZ(); ++other)
                if (isFound[size_t(other)] && column[n + other] != 0) return true;
            return false;
        };
        for (bool changed = true; changed;) {
            changed = false;
            for (int k = 0; k < m_origin.getNZ(); ++k)
                if (!isFound[size_t(k)] && hasInfluence(k)) changed = isFound[size_t(k)] = true;
        }
        std::vector<int> found;
        for (int k = 0; k < m_origin.getNZ(); ++k)
            if (isFound[size_t(k)]) found.push_back(k);
        return found;
    }

    LinearModel finish(const std::vector<int>& z) const {
        const Index p = getNumPositions(), s = getNumSpeeds(), n = p + s + Index(z.size());
        std::vector<Index> columns, zRows;
        for (Index k = 0; k < p + s; ++k) columns.push_back(k);
        for (const int k : z) {
            columns.push_back(p + s + k);
            zRows.push_back(m_scale.size() + k);
        }
        MatrixXd A = MatrixXd::Zero(n, n), errors = MatrixXd::Zero(n, n);
        A.topLeftCorner(p, p) = m_Z.transpose() * m_kinematics;
        A.block(0, p, p, s) = m_Z.transpose() * m_V;
        errors.topLeftCorner(p, p) = m_Z.transpose().cwiseAbs() * m_speedChanges.errors;
        const MatrixXd rates = m_rates.values(Eigen::all, columns),
                       wrong = m_rates.errors(Eigen::all, columns);
        A.middleRows(p, s) = m_V.transpose() * rates.topRows(m_scale.size());
        errors.middleRows(p, s) = m_V.transpose().cwiseAbs() * wrong.topRows(m_scale.size());
        A.bottomRows(Index(z.size())) = rates(zRows, Eigen::all);
        errors.bottomRows(Index(z.size())) = wrong(zRows, Eigen::all);
        MatrixXd displacements = MatrixXd::Zero(m_scale.size(), n), speeds = displacements;
        displacements.leftCols(p) = m_scale.asDiagonal() * m_Z;
        speeds.leftCols(p) = m_scale.asDiagonal() * m_speedChanges.values;
        speeds.middleCols(p, s) = m_scale.asDiagonal() * m_V;
        Vector zDot(int(z.size()));
        for (size_t k = 0; k < z.size(); ++k) zDot[int(k)] = m_origin.getZDot()[z[k]];
        return {m_origin,
                int(p),
                int(s),
                z,
                toSimTKMatrix(A),
                toSimTKMatrix(errors),
                toSimTKMatrix(displacements),
                toSimTKMatrix(speeds),
                m_origin.getUDot(),
                zDot};
    }

    const SimTK::MultibodySystem& m_system;
    const SimTK::SimbodyMatterSubsystem& m_matter;
    ConstraintManifold m_manifold;
    std::vector<ConstraintEquation> m_equations;
    VectorXd m_violations = VectorXd::Zero(Index(m_equations.size()));  // the largest there were
    double m_fastest = 0;                                               // acceleration
    const State& m_origin;
    const VectorXd& m_scale;
    const MatrixXd &m_Z, &m_V;
    Derivatives m_rates, m_speedChanges;
    MatrixXd m_kinematics;  // U + W Z
};

}  // namespace

LinearModel linearize(const SimTK::MultibodySystem& system, const State& state, const ElementNames& names) {
    return Linearization(system, state, names).run();
}

LinearModel linearize(const Mechanism& mechanism, const State& given) {
    const SimTK::MultibodySystem& system = mechanism.getSystem();
    State state = given;
    system.realize(state, Stage::Velocity);
    std::optional<DroppedEquations> dropped;
    if (countFreedoms(mechanism.getMatter(), state).hasOnlyEmptyHolonomic)
        dropped.emplace(mechanism, state, DropChoice::Empty);
    system.realize(state, Stage::Velocity);
    setEquationScales(mechanism, state);
    LinearModel model = linearize(system, state, mechanism.getElementNames());
    resetEquationScales(mechanism, model.state);
    if (dropped) dropped->restore(model.state);
    system.realize(model.state, Stage::Acceleration);
    return model;
}

}  // namespace jprim
