// SPDX-License-Identifier: Apache-2.0
#include "simulation/break_watch.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "force/expression_measure_impl.h"
#include "force/marker_force_impl.h"
#include "general/general_constraint_impl.h"
#include "jprim/base/error.h"
#include "marker/find_implementation.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;

BreakWatch BreakWatch::ofLoads(const Mechanism& mechanism) {
    BreakWatch watch;
    for (const Element& element : mechanism.getElements()) {
        if (const MarkerForce* force = element.getForce())
            for (const MarkerExpression* expression :
                 findImplementation<MarkerForceImpl>(*force)->getExpressions())
                watch.add(*expression);
        if (!element.getGeneralConstraint()) continue;
        const auto* constraint = findImplementation<GeneralConstraintImpl>(*element.getGeneralConstraint());
        watch.add(constraint->getCoordinate());
        if (constraint->getFunction()) watch.add(*constraint->getFunction());
    }
    for (const MechanismState& state : mechanism.getStates())
        watch.add(findImplementation<ExpressionMeasureImpl>(state.rate)->getExpression().get());
    return watch;
}

BreakWatch BreakWatch::ofSensors(const Mechanism& mechanism) {
    BreakWatch watch;
    for (const MechanismSensor& sensor : mechanism.getSensors())
        if (sensor.acts())
            watch.add(findImplementation<ExpressionMeasureImpl>(sensor.function)->getExpression().get());
    return watch;
}

void BreakWatch::add(const MarkerExpression& expression) {
    TimeBreaks breaks(expression.program, expression.units.time);
    if (!breaks.isEmpty()) m_functions.emplace_back(std::move(breaks));
}

// A function that breaks without end, such as one whose branches are decided by rounding errors, is left to the
// integrator.
std::optional<TimeBreak> BreakWatch::findNext(Real after, Real until) {
    constexpr int Most = 100000;
    std::optional<TimeBreak> first;
    for (Function& function : m_functions) {
        const bool isKnown =
            function.searchedFrom <= after &&
            (function.next ? after < function.next->behind : until <= function.searchedUntil);
        if (!isKnown && function.count < Most) {
            function.next = function.breaks.findFirst(after, until);
            function.searchedFrom = after;
            function.searchedUntil = until;
            if (function.next) ++function.count;
        }
        const std::optional<TimeBreak>& next = function.next;
        if (!next || next->behind <= after || next->before > until) continue;
        if (!first || next->before < first->before) first = next;
    }
    return first;
}

std::optional<TimeBreak> BreakWatch::findAround(Real time, Real span) {
    constexpr int Numbers = 21, OfSpan = -60;
    const Real spacing = std::nextafter(time, SimTK::Infinity) - time;
    const Real margin = std::ldexp(std::max(spacing, std::ldexp(span, OfSpan)), Numbers);
    std::optional<TimeBreak> around;
    for (Function& function : m_functions) {
        const std::optional<TimeBreak> found = function.breaks.findFirst(time - margin, time + margin);
        if (!found || time < found->before || found->behind <= time) continue;
        if (!around) around = found;
        around->before = std::min(around->before, found->before);
        around->behind = std::max(around->behind, found->behind);
    }
    return around;
}

void BreakWatch::requireNoJump(const Mechanism& mechanism, const State& before, Real behind,
                               KinematicLevel highest) {
    constexpr Real Rounding = 1e-9, Margin = 10, Later = 64;
    if (before.getNMultipliers() == 0) return;
    State state = before;
    mechanism.getSystem().realize(state, SimTK::Stage::Velocity);
    const SimTK::Vector positions = state.getQErr(), velocities = state.getUErr();
    const Real far = 1 + (state.getNQ() > 0 ? state.getQ().normInf() : 0),
               fast = 1 + (state.getNU() > 0 ? state.getU().normInf() : 0);
    state.updTime() = behind;
    mechanism.getSystem().realize(state, SimTK::Stage::Velocity);
    const SimTK::Vector jumps = state.getQErr() - positions, rates = state.getUErr() - velocities;
    // What is steep but has no kink changes as much in the same time a little later too.
    const auto calcRates = [&](Real spans) {
        state.updTime() = behind + spans * (behind - before.getTime());
        mechanism.getSystem().realize(state, SimTK::Stage::Velocity);
        return SimTK::Vector(state.getUErr());
    };
    const SimTK::Vector changes = (calcRates(2 * Later) - calcRates(Later)) / Later;
    for (const ConstraintEquation& equation : mechanism.findEquations(state)) {
        if (equation.level == KinematicLevel::Acceleration) continue;
        const bool isOfPositions = equation.level == KinematicLevel::Position;
        const bool isJump = isOfPositions && std::abs(equation.getError(jumps)) > Rounding * far;
        if (!isJump && highest == KinematicLevel::Position) continue;
        const Real steep = Margin * std::abs(equation.getError(changes));
        if (!isJump && std::abs(equation.getError(rates)) <= Rounding * fast + steep) continue;
        throw Error(equation.element,
                    fmt::format("its function jumps in {}, which nothing that has a mass can follow; use a "
                                "function without a {}, such as STEP",
                                isJump ? "position" : "velocity", isJump ? "jump" : "kink"));
    }
}

bool BreakWatch::doRatesJump(const State& before, const State& behind, int numStates) {
    constexpr Real Jump = 1e-2;
    const SimTK::Vector jump = behind.getUDot() - before.getUDot();
    if (jump.size() > 0 && jump.normInf() > Jump * before.getUDot().normInf()) return true;
    for (int k = 0; k < numStates; ++k) {
        const Real rate = before.getZDot()[k];
        if (std::abs(behind.getZDot()[k] - rate) > Jump * std::abs(rate)) return true;
    }
    return false;
}

}  // namespace jprim
