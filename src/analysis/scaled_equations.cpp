// SPDX-License-Identifier: Apache-2.0
#include "analysis/scaled_equations.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using SimTK::SimbodyMatterSubsystem;
using SimTK::Stage;
using SimTK::State;

namespace {

// Rounding errors, of what they are beside; and an equation that a turn of 1 rad or a shift of 1 does not change.
constexpr double Rounding = 1e-12, Nothing = 1e-14;

// The size of one unit of each speed: the angular velocity that it is, or else the velocity.
struct Mobilities {
    VectorXd angular, linear;
};

Mobilities measureMobilities(const SimbodyMatterSubsystem& matter, const State& state) {
    Mobilities sizes{VectorXd::Zero(state.getNU()), VectorXd::Zero(state.getNU())};
    for (SimTK::MobilizedBodyIndex b(1); b < matter.getNumBodies(); ++b) {
        const SimTK::MobilizedBody& body = matter.getMobilizedBody(b);
        for (SimTK::MobilizerUIndex k(0); k < body.getNumU(state); ++k) {
            const SimTK::SpatialVec V = body.getHCol(state, k);
            const int j = int(body.getFirstUIndex(state)) + int(k);
            sizes.angular[j] = V[0].norm();
            sizes.linear[j] = sizes.angular[j] > 0 ? 0 : V[1].norm();
        }
    }
    return sizes;
}

// What a turn of 1 rad and a shift of 1 length unit of all bodies do to each equation.
struct RowSizes {
    VectorXd turn, shift;
};

// Taken from the load of the equation on bodies, which does not depend on how they hang in a tree; coordinates with
// loads of their own count as what they move. What rounding leaves of a shift does not count.
RowSizes measureRows(const SimbodyMatterSubsystem& matter, const State& state,
                     const std::vector<ConstraintEquation>& equations) {
    const Mobilities sizes = measureMobilities(matter, state);
    RowSizes rows{VectorXd::Zero(int(equations.size())), VectorXd::Zero(int(equations.size()))};
    SimTK::Vector multipliers(state.getNMultipliers(), SimTK::Real(0)), mobilityForces;
    SimTK::Vector_<SimTK::SpatialVec> bodyForces;
    for (int i = 0; i < rows.turn.size(); ++i) {
        const auto multiplier = equations[size_t(i)].multiplier;
        multipliers[multiplier] = 1;
        matter.calcConstraintForcesFromMultipliers(state, multipliers, bodyForces, mobilityForces);
        multipliers[multiplier] = 0;
        double turn = 0, shift = 0;
        for (SimTK::MobilizedBodyIndex b(1); b < matter.getNumBodies(); ++b) {
            turn += bodyForces[b][0].normSqr();
            shift += bodyForces[b][1].normSqr();
        }
        for (int j = 0; j < mobilityForces.size(); ++j) {
            if (sizes.angular[j] > 0) turn += SimTK::square(mobilityForces[j] / sizes.angular[j]);
            if (sizes.linear[j] > 0) shift += SimTK::square(mobilityForces[j] / sizes.linear[j]);
        }
        rows.turn[i] = std::sqrt(turn);
        rows.shift[i] = std::sqrt(shift) > Rounding * rows.turn[i] ? std::sqrt(shift) : 0;
    }
    return rows;
}

// The root mean square of all levers: what an equation says about a turn by what it says about a shift.
double calcLength(const RowSizes& rows) {
    double turns = 0, shifts = 0;
    for (int i = 0; i < rows.shift.size(); ++i) {
        if (rows.shift[i] == 0) continue;
        turns += rows.turn[i] * rows.turn[i];
        shifts += rows.shift[i] * rows.shift[i];
    }
    return turns > 0 ? std::sqrt(turns / shifts) : 1;
}

}  // namespace

ScaledEquations::ScaledEquations(const SimbodyMatterSubsystem& matter,
                                 std::vector<ConstraintEquation> equations, const State& state)
    : m_matter(matter), m_equations(std::move(equations)) {
    const MatrixXd G = calcUnscaledJacobian(state);
    const RowSizes rows = measureRows(matter, state, m_equations);
    const VectorXd sizes = (rows.shift.array() > 0).select(calcLength(rows) * rows.shift, rows.turn);
    // Rows and columns of nothing but rounding errors must not be made as long as the others.
    const auto invert = [](const VectorXd& lengths) -> VectorXd {
        const double noise = lengths.size() > 0 ? std::max(Nothing, Rounding * lengths.maxCoeff()) : 0;
        return lengths.unaryExpr([noise](double size) { return size > noise ? 1 / size : 1; });
    };
    m_rowScale = invert(sizes);
    m_columnScale = invert((m_rowScale.asDiagonal() * G).colwise().norm().transpose());
}

void ScaledEquations::realize(const State& state) const {
    m_matter.getSystem().realize(state, Stage::Velocity);
}

MatrixXd ScaledEquations::calcUnscaledJacobian(const State& state) const {
    realize(state);
    SimTK::Matrix G;
    m_matter.calcG(state, G);
    MatrixXd A(int(m_equations.size()), state.getNU());
    for (int i = 0; i < A.rows(); ++i)
        for (int j = 0; j < A.cols(); ++j) A(i, j) = G(m_equations[size_t(i)].multiplier, j);
    return A;
}

MatrixXd ScaledEquations::calcJacobian(const State& state) const {
    return m_rowScale.asDiagonal() * calcUnscaledJacobian(state) * m_columnScale.asDiagonal();
}

VectorXd ScaledEquations::calcErrors(const State& state) const {
    realize(state);
    VectorXd errors = VectorXd::Zero(int(m_equations.size()));
    for (int i = 0; i < errors.size(); ++i) {
        const ConstraintEquation& equation = m_equations[size_t(i)];
        if (equation.level == EquationLevel::Holonomic)
            errors[i] = m_rowScale[i] * state.getQErr()[equation.multiplier];
    }
    return errors;
}

State ScaledEquations::move(const State& state, const VectorXd& u) const {
    realize(state);
    SimTK::Vector change;
    m_matter.multiplyByN(state, false, SimTK::Vector(int(u.size()), u.data()), change);
    State moved = state;
    moved.updQ() += change;
    m_matter.getSystem().realize(moved, Stage::Time);
    m_matter.normalizeQuaternions(moved);
    return moved;
}

std::vector<ConstraintEquation> selectHolonomic(const std::vector<ConstraintEquation>& equations) {
    std::vector<ConstraintEquation> selected;
    std::copy_if(equations.begin(), equations.end(), std::back_inserter(selected),
                 [](const ConstraintEquation& e) { return e.level == EquationLevel::Holonomic; });
    return selected;
}

}  // namespace jprim
