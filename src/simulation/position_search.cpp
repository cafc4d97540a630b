// SPDX-License-Identifier: Apache-2.0
// With e the scaled errors, A their Jacobian, H = ~J J the metric of closeness and S = A inv(H) ~A:
//
//     towards the equations   min |e + A u|^2 + mu ~u H u:        u = -inv(H) ~A inv(S + mu) e
//     along them              min ~g u + ~u H u/2,  A u = 0:      u = -inv(H) (g - ~A inv(S + 0) A inv(H) g)
//
// The first is Levenberg and Marquardt's step; mu falls with |e|, so that it is quadratic in the end. "+ 0" is just
// enough to factor S where equations depend on each other: what they have in common is consistent, and no part of
// the right side lies in the null space. All matrices are sparse; where all parts are free H is diagonal.
#include "simulation/position_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "analysis/error_minimum.h"
#include "linear_algebra/sparse_factor.h"

namespace jprim {

using Eigen::VectorXd;
using SimTK::Real;
using SimTK::Stage;
using SimTK::State;

namespace {

constexpr double SmallestDamping = 1e-12, LargestDamping = 1e6;
constexpr double LongestTurn = 0.5;  // [rad]
constexpr double Restored = 1e-12;   // errors of equations that are met, above rounding

SparseMatrix addToDiagonal(const SparseMatrix& M, double value) {
    SparseMatrix identity(M.rows(), M.cols());
    identity.setIdentity();
    return M + value * identity;
}

}  // namespace

/// A, inv(H) ~A and S at a State.
struct PositionSearch::Linearization {
    SparseMatrix A, J, invH_At, S;
    SparseFactor H, factorsOfS;

    void factorS(double damping = 0) {
        factorsOfS.compute(addToDiagonal(S, std::max(damping, SmallestDamping)));
    }
    Vector solveS(const Vector& b) const { return factorsOfS.solve(b); }
};

PositionSearch::PositionSearch(PositionProblem problem, const State& start) : m_problem(std::move(problem)) {
    m_isLocked.assign(size_t(start.getNU()), false);
    for (const SimTK::MobilizedBodyIndex b : m_problem.locked) {
        const SimTK::MobilizedBody& body = m_problem.matter.getMobilizedBody(b);
        for (int k = 0; k < body.getNumU(start); ++k)
            m_isLocked[size_t(body.getFirstUIndex(start) + k)] = true;
    }
    chooseScales(start);
}

//--------------------------------------------------------------------------------- errors and their rows
// Of the equations, then of the conditions.
std::vector<EquationLoads> PositionSearch::calcRows(const State& state) const {
    realize(state);
    std::vector<EquationLoads> rows = calcEquationLoads(m_problem.matter, state, m_problem.equations);
    for (const auto& condition : m_problem.conditions) {
        const int count = condition->calcErrors(state).size();
        for (int i = 0; i < count; ++i) {
            Directions directions(m_problem.matter, state);
            condition->addDirections(state, i, directions);
            rows.push_back(directions.getNonzero());
        }
    }
    return rows;
}

// An equation that moves nothing keeps its own unit.
void PositionSearch::chooseScales(const State& start) {
    constexpr double Nothing = 1e-12;
    for (const EquationLoads& row : calcRows(start)) {
        const double size = m_problem.closeness.calcSize(row);
        m_scales.push_back(size > Nothing ? 1 / size : 1);
    }
    size_t row = 0;
    for (; row < m_problem.equations.size(); ++row) m_scales[row] *= m_problem.emphasisOfEquations;
    for (size_t c = 0; c < m_problem.emphasisOfConditions.size(); ++c)
        for (int i = m_problem.conditions[c]->calcErrors(start).size(); i > 0; --i)
            m_scales[row++] *= m_problem.emphasisOfConditions[c];
}

VectorXd PositionSearch::calcErrors(const State& state) const {
    m_problem.matter.getSystem().realize(state, Stage::Position);
    VectorXd errors(m_scales.size());
    int row = 0;
    for (const ConstraintEquation& equation : m_problem.equations)
        errors[row++] = state.getQErr()[equation.multiplier];
    for (const auto& condition : m_problem.conditions) {
        const SimTK::Vector some = condition->calcErrors(state);
        for (int i = 0; i < some.size(); ++i) errors[row++] = some[i];
    }
    return errors.cwiseProduct(Eigen::Map<const VectorXd>(m_scales.data(), errors.size()));
}

bool PositionSearch::isMet(const State& state) const {
    const VectorXd scaled = calcErrors(state);
    for (int i = 0; i < scaled.size(); ++i)
        if (!(std::abs(scaled[i]) <= m_problem.tolerance * m_scales[size_t(i)])) return false;
    return true;
}

double PositionSearch::calcWorst(const State& state) const {
    return calcLargest(calcErrors(state));
}

SparseMatrix PositionSearch::calcJacobian(const State& state, const BodyJacobian& bodies) const {
    BodyJacobian::Triplets entries;
    int number = 0;
    for (const EquationLoads& row : calcRows(state)) {
        bodies.addRow(row, m_scales[size_t(number)], number, entries);
        ++number;
    }
    SparseMatrix A(Eigen::Index(m_scales.size()), state.getNU());
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
}

// Speeds that the goals do not feel, such as those of modes, cost what they do to the equations.
void PositionSearch::linearize(const State& state, Linearization& l) const {
    constexpr double Unfelt = 1e-12;
    realize(state);
    const BodyJacobian bodies(m_problem.matter, state);
    const auto isFree = [this](Eigen::Index, Eigen::Index column, double) {
        return !m_isLocked[size_t(column)];
    };
    l.A = calcJacobian(state, bodies);
    l.J = m_problem.closeness.calcJacobian(state, bodies);
    l.A.prune(isFree);
    l.J.prune(isFree);
    SparseMatrix H = l.J.transpose() * l.J;
    const VectorXd diagonal = H.diagonal();
    const double felt = Unfelt * calcLargest(diagonal);
    BodyJacobian::Triplets added;
    for (int j = 0; j < int(H.cols()); ++j) {
        if (diagonal[j] > felt) continue;
        const double effect = l.A.col(j).squaredNorm();
        added.emplace_back(j, j, effect > 0 ? effect : 1);
    }
    SparseMatrix unfelt(H.rows(), H.cols());
    unfelt.setFromTriplets(added.begin(), added.end());
    H += unfelt;
    l.H.compute(H);
    const SparseMatrix At = l.A.transpose();
    l.invH_At = l.H.solve(At);
    l.S = l.A * l.invH_At;
}

//---------------------------------------------------------------------------------------------- moving
void PositionSearch::realize(const State& state) const {
    m_problem.matter.getSystem().realize(state, Stage::Velocity);
}

State PositionSearch::move(const State& state, const VectorXd& u) const {
    const double turn = m_problem.closeness.calcLargestTurn(state, u);
    const VectorXd step = turn > LongestTurn ? VectorXd(LongestTurn / turn * u) : u;
    SimTK::Vector change;
    m_problem.matter.multiplyByN(state, false, SimTK::Vector(int(step.size()), step.data()), change);
    State moved = state;
    moved.updQ() += change;
    m_problem.matter.getSystem().realize(moved, Stage::Time);
    m_problem.matter.normalizeQuaternions(moved);
    return moved;
}

// One step down; false if there is none. The damping is what the next step should start from.
bool PositionSearch::descend(State& state, VectorXd& errors, double& damping) const {
    constexpr double Stationary = 1e-10, Factor = 10;
    Linearization l;
    linearize(state, l);
    const double size = errors.norm(), least = calcLeastDamping(size);
    if (errors.dot(l.S * errors) <= Stationary * Stationary * size * size) return false;
    for (; damping < LargestDamping; damping *= Factor) {
        l.factorS(std::max(damping * size, least));
        const VectorXd u = -(l.invH_At * l.solveS(errors));
        if (!u.allFinite()) continue;
        const State trial = move(state, u);
        const VectorXd now = calcErrors(trial);
        if (!(now.norm() < size)) continue;
        state = trial;
        errors = now;
        damping /= Factor;
        return true;
    }
    return false;
}

void PositionSearch::descendFully(State& state, int mostSteps, double damping) const {
    VectorXd errors = calcErrors(state);
    for (int k = 0; k < mostSteps && calcLargest(errors) > Restored; ++k)
        if (!descend(state, errors, damping)) break;
}

bool PositionSearch::meetEquations(State& state) const {
    constexpr int MostSteps = 300;
    constexpr double FirstDamping = 1e-3, Lower = 0.999;
    // Of what is left at a position that is stationary by symmetry; less is left only where one next to it will do.
    constexpr double Unlikely = 1e-4, Slight = 0.01;
    realize(state);
    descendFully(state, MostSteps, FirstDamping);
    std::mt19937 generator;
    for (const double nudge : {Slight, 0.1, 0.1, 0.3, 0.3}) {
        if (isMet(state)) return true;
        if (nudge > Slight && calcWorst(state) < Unlikely) break;
        VectorXd u(state.getNU());
        for (int j = 0; j < u.size(); ++j)
            u[j] = m_isLocked[size_t(j)] ? 0 : std::normal_distribution<double>(0, nudge)(generator);
        realize(state);
        State nudged = move(state, u);
        descendFully(nudged, MostSteps, FirstDamping);
        if (calcErrors(nudged).norm() < Lower * calcErrors(state).norm()) state = nudged;
    }
    return isMet(state);
}

//--------------------------------------------------------------------------------- along the equations
// Back onto the equations from nearby, first by the Jacobian that is there already.
void PositionSearch::restore(const Linearization& l, State& state) const {
    constexpr int MostCheapSteps = 8, MostSteps = 12;
    constexpr double Less = 0.3, FirstDamping = 1e-6;
    VectorXd errors = calcErrors(state);
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < MostCheapSteps && calcLargest(errors) > Restored; ++k) {
        if (!(errors.norm() < Less * before)) break;
        before = errors.norm();
        realize(state);
        state = move(state, -(l.invH_At * l.solveS(errors)));
        errors = calcErrors(state);
    }
    descendFully(state, MostSteps, FirstDamping);
}

// Tries the whole step first, back onto the equations each time.
bool PositionSearch::advance(const Linearization& l, const VectorXd& u, double decrease, State& state) const {
    constexpr double Enough = 1e-4, Shortest = 1e-4;
    const Real value = m_problem.closeness.calcValue(state);
    for (double part = 1; part > Shortest; part /= 2) {
        State trial = move(state, part * u);
        restore(l, trial);
        if (!isMet(trial)) continue;
        if (!(m_problem.closeness.calcValue(trial) < value - Enough * part * decrease)) continue;
        state = trial;
        return true;
    }
    return false;
}

void PositionSearch::approachGoals(State& state) const {
    constexpr int MostSteps = 100;
    constexpr double Converged = 1e-13;  // of phi: positions to 1e-6 sizes of a part and better
    for (int k = 0; k < MostSteps; ++k) {
        Linearization l;
        linearize(state, l);
        l.factorS();
        const VectorXd g = l.J.transpose() * m_problem.closeness.calcResiduals(state);
        VectorXd u = -l.H.solve(g);
        for (int again = 0; again < 2; ++again) u -= l.invH_At * l.solveS(l.A * u);
        const double decrease = -g.dot(u);
        if (decrease <= Converged * m_problem.closeness.calcValue(state)) return;
        if (!advance(l, u, decrease, state)) return;
    }
}

}  // namespace jprim
