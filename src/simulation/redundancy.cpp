// SPDX-License-Identifier: Apache-2.0
#include "simulation/redundancy.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/scaled_equations.h"
#include "base/format.h"
#include "linear_algebra/orthogonal.h"
#include "linear_algebra/rank.h"
#include "linear_algebra/singular_values.h"

namespace jprim {

using SimTK::Constraint;
using SimTK::Real;
using SimTK::State;

namespace {

// The last ones of an elimination that always takes next what is most independent of those before.
std::vector<int> selectWeakest(const Mechanism& mechanism, const State& state, const ConstraintReport& report,
                               size_t count) {
    const Eigen::MatrixXd A =
        ScaledEquations(mechanism.getMatter(), report.equations, state).calcJacobian(state);
    const Eigen::VectorXi order = orderByIndependence(A);
    std::vector<int> selected(order.end() - Eigen::Index(count), order.end());
    std::sort(selected.begin(), selected.end());
    return selected;
}

}  // namespace

std::vector<int> selectRedundant(const ConstraintReport& report, DropChoice choice) {
    std::vector<int> selected;
    for (const RedundantEquation& redundant : report.redundant)
        if (!redundant.onlyHere && (redundant.dependsOn.empty() || choice == DropChoice::Later))
            selected.push_back(redundant.equation);
    return selected;
}

DroppedEquations::DroppedEquations(const Mechanism& mechanism, State& state, DropChoice choice)
    : m_mechanism(mechanism) {
    const ConstraintReport report =
        analyzeConstraints(mechanism.getMatter(), state, mechanism.getElementNames());
    const std::vector<int> empty = selectRedundant(report, DropChoice::Empty);
    std::vector<int> selected =
        choice == DropChoice::Empty ? empty : selectRedundant(report, DropChoice::Later);
    if (choice == DropChoice::Weakest) selected = selectWeakest(mechanism, state, report, selected.size());
    for (const int k : selected) {
        const ConstraintEquation& equation = report.equations[size_t(k)];
        m_dropped.push_back({equation, std::count(empty.begin(), empty.end(), k) > 0, {mechanism, equation}});
        m_dropped.back().access.setScale(state, 0);
    }
    mechanism.getSystem().realize(state, SimTK::Stage::Position);
    allowContradictions(state);
    m_strength = calcStrength(state);
    if (m_dropped.size() < report.equations.size()) return;
    for (const Dropped& dropped : m_dropped) {
        const Constraint& constraint = mechanism.getMatter().getConstraint(dropped.equation.constraint);
        constraint.disable(state);
        m_disabled.push_back(constraint);
    }
}

// What is rounded in a dataset may contradict itself more in other positions.
void DroppedEquations::allowContradictions(const State& state) {
    constexpr Real Elsewhere = 100;
    for (const Dropped& dropped : m_dropped)
        if (dropped.equation.isDropped())
            keepWorst(m_allowed, dropped.equation, Elsewhere * dropped.access.calcError(state));
}

// The smallest singular value of the equations kept.
Real DroppedEquations::calcStrength(const State& state) const {
    std::vector<ConstraintEquation> kept = m_mechanism.findEquations(state);
    kept.erase(std::remove_if(kept.begin(), kept.end(), [](const auto& e) { return e.isDropped(); }),
               kept.end());
    if (kept.empty()) return 1;
    const Eigen::MatrixXd A = ScaledEquations(m_mechanism.getMatter(), kept, state).calcJacobian(state);
    return A.rows() > A.cols() ? 0 : calcSingularValues(A)[A.rows() - 1];
}

bool DroppedEquations::isWeak(const State& state) const {
    constexpr Real ByFar = 0.1;
    return !m_dropped.empty() && calcStrength(state) < ByFar * m_strength;
}

std::vector<std::string> DroppedEquations::getTexts() const {
    std::vector<std::string> texts;
    for (const Dropped& dropped : m_dropped) texts.push_back(dropped.equation.getText());
    return texts;
}

std::string DroppedEquations::describeViolation(const Dropped& dropped, Real error) const {
    const char* const PerTime[] = {"", "/s", "/s^2"};
    const Dimension dimension = dropped.equation.dimension;
    return fmt::format(
        "{}, which was dropped because {}, is violated by {:.3g} {}{}: {}", dropped.equation.getText(),
        dropped.isEmpty ? "no motion changed it" : "it followed from other equations",
        std::abs(error) / m_mechanism.getUnits().getDisplacement(dimension), getUnitName(dimension),
        PerTime[int(dropped.equation.level)],
        dropped.isEmpty ? "by itself it cannot hold what it says" : "it is in conflict with them now");
}

void DroppedEquations::check(const State& state, Real tolerance) const {
    for (const Dropped& dropped : m_dropped) {
        const Real error = dropped.access.calcError(state);
        const Real allowed =
            dropped.equation.dimension == Dimension::Length ? m_allowed.length : m_allowed.angle;
        if (std::abs(error) > std::max(tolerance, allowed))
            throw std::runtime_error(describeViolation(dropped, error));
    }
}

void DroppedEquations::restore(State& state) const {
    for (const Dropped& dropped : m_dropped)
        if (!dropped.equation.isDropped()) dropped.access.setScale(state, 1);
    for (const Constraint& constraint : m_disabled) constraint.enable(state);
}

}  // namespace jprim
