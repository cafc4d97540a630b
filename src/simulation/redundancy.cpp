// SPDX-License-Identifier: Apache-2.0
#include "simulation/redundancy.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace jprim {

using SimTK::Constraint;
using SimTK::Real;
using SimTK::State;

DroppedEquations::Dropped DroppedEquations::drop(const PairConstraint& constraint,
                                                 const ConstraintEquation& equation, State& state) {
    const int k = equation.number;
    constraint.dropEquation(state, k);
    return {equation, false, [constraint, k](const State& s) { return constraint.calcEquationError(s, k); },
            [constraint, k](State& s) { constraint.restoreEquation(s, k); }};
}

DroppedEquations::Dropped DroppedEquations::drop(const GeneralConstraint& constraint,
                                                 const ConstraintEquation& equation, State& state) {
    constraint.dropEquation(state);
    return {equation, false, [constraint](const State& s) { return constraint.calcEquationError(s); },
            [constraint](State& s) { constraint.restoreEquation(s); }};
}

DroppedEquations::Dropped DroppedEquations::drop(const Mechanism& mechanism,
                                                 const ConstraintEquation& equation, State& state) {
    const auto isIts = [&](const Constraint& c) { return c.getConstraintIndex() == equation.constraint; };
    for (const Connection& connection : mechanism.getConnections()) {
        if (!connection.joint || !isIts(connection.joint->getConstraint())) continue;
        if (const PairConstraint* pair = connection.joint->getPairConstraint())
            return drop(*pair, equation, state);
        return drop(*connection.joint->getGeneralConstraint(), equation, state);
    }
    for (const Equation& element : mechanism.getEquations())
        if (isIts(element.constraint)) return drop(element.constraint, equation, state);
    throw std::logic_error(equation.getText() + " is of no element");
}

DroppedEquations::DroppedEquations(const Mechanism& mechanism, State& state)
    : m_lengthUnit(mechanism.getUnits().length) {
    const ConstraintReport report =
        analyzeConstraints(mechanism.getMatter(), state, mechanism.getElementNames());
    for (const RedundantEquation& redundant : report.redundant) {
        if (redundant.onlyHere) continue;
        m_dropped.push_back(drop(mechanism, report.equations[size_t(redundant.equation)], state));
        m_dropped.back().isEmpty = redundant.dependsOn.empty();
    }
    if (m_dropped.size() < report.equations.size()) return;
    for (const Dropped& dropped : m_dropped) {
        const Constraint& constraint = mechanism.getMatter().getConstraint(dropped.equation.constraint);
        constraint.disable(state);
        m_disabled.push_back(constraint);
    }
}

std::vector<std::string> DroppedEquations::getTexts() const {
    std::vector<std::string> texts;
    for (const Dropped& dropped : m_dropped) texts.push_back(dropped.equation.getText());
    return texts;
}

std::string DroppedEquations::describeViolation(const Dropped& dropped, Real error) const {
    const char* const PerTime[] = {"", "/s", "/s^2"};
    const bool isLength = dropped.equation.isLength;
    return fmt::format(
        "{}, which was dropped because {}, is violated by {:.3g} {}{}: {}", dropped.equation.getText(),
        dropped.isEmpty ? "no motion changed it" : "it followed from other equations",
        isLength ? std::abs(error) / m_lengthUnit : std::abs(error), isLength ? "length units" : "rad",
        PerTime[int(dropped.equation.level)],
        dropped.isEmpty ? "by itself it cannot hold what it says" : "it is in conflict with them now");
}

void DroppedEquations::check(const State& state, Real tolerance) const {
    for (const Dropped& dropped : m_dropped) {
        const Real error = dropped.calcError(state);
        if (std::abs(error) > tolerance) throw std::runtime_error(describeViolation(dropped, error));
    }
}

void DroppedEquations::restore(State& state) const {
    for (const Dropped& dropped : m_dropped) dropped.restore(state);
    for (const Constraint& constraint : m_disabled) constraint.enable(state);
}

}  // namespace jprim
