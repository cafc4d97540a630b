// SPDX-License-Identifier: Apache-2.0
#include "simulation/switch_watch.h"

#include <algorithm>
#include <cmath>

#include "force/expression_measure_impl.h"
#include "force/marker_force_impl.h"
#include "marker/find_implementation.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;
using SimTK::Vector;

SwitchWatch::Source SwitchWatch::getLoads(const Mechanism& mechanism) {
    return [&mechanism](const State& state, std::vector<SwitchWatch::Switch>& switches) {
        for (const Element& element : mechanism.getElements())
            if (element.getForce() && !element.isDisabled(state))
                findImplementation<MarkerForceImpl>(*element.getForce())->addSwitches(state, switches);
        for (const MechanismState& control : mechanism.getStates())
            findImplementation<ExpressionMeasureImpl>(control.rate)
                ->getExpression()
                .addSwitches(state, false, switches);
    };
}

SwitchWatch::Moment SwitchWatch::makeMoment(const State& state) const {
    m_system.realize(state, SimTK::Stage::Acceleration);
    return {state.getTime(), Vector(state.getQ()), Vector(state.getQDot()), Vector(state.getZ()),
            Vector(state.getZDot())};
}

void SwitchWatch::start(const State& state) {
    m_last.clear();
    m_source(state, m_last);
    m_largest.assign(m_last.size(), 0);
    if (m_last.empty()) return;
    m_start = makeMoment(state);
    m_between = state;
}

SwitchWatch::Point SwitchWatch::findBetween(const Moment& end, size_t k, Real s) {
    const Real h = end.time - m_start.time, r = 1 - s;
    const auto interpolate = [&](const Vector& a, const Vector& aDot, const Vector& b, const Vector& bDot) {
        return Vector(r * r * (1 + 2 * s) * a + s * s * (1 + 2 * r) * b + h * s * r * (r * aDot - s * bDot));
    };
    m_between.updTime() = m_start.time + s * h;
    m_between.updQ() = interpolate(m_start.q, m_start.qDot, end.q, end.qDot);
    m_between.updZ() = interpolate(m_start.z, m_start.zDot, end.z, end.zDot);
    m_system.realize(m_between, SimTK::Stage::Position);
    const Vector qDot =
        6 * s * r / h * (end.q - m_start.q) + r * (1 - 3 * s) * m_start.qDot + s * (1 - 3 * r) * end.qDot;
    Vector u;
    m_system.getMatterSubsystem().multiplyByNInv(m_between, false, qDot, u);
    m_between.updU() = u;
    m_system.realize(m_between, SimTK::Stage::Velocity);
    std::vector<Switch> switches;
    m_source(m_between, switches);
    return {s, switches[k].value, switches[k].rate * h};
}

// Between a point from which the value goes towards zero and one to which it comes back, both on the same side. Its
// tangents there meet beyond zero, or a curve that bends to one side does not reach it.
std::optional<SwitchWatch::Point> SwitchWatch::findBeyond(const Moment& end, size_t k, Point from, Point to) {
    constexpr int MostTrials = 30;
    constexpr Real OfLargest = 1e-9, Nothing = 1e-12;
    const Real side = from.value > 0 ? 1 : -1, floor = Nothing + OfLargest * m_largest[k];
    const bool hasRate = m_last[k].level == KinematicLevel::Position;
    const Real margin = hasRate ? 0.05 : 1e-6;
    for (int trial = 0; trial < MostTrials; ++trial) {
        const Real width = to.s - from.s;
        const Real there = (to.value - from.value - to.rate * width) / (from.rate - to.rate);
        if (side * (from.value + from.rate * there) > -floor) return std::nullopt;
        const Point p = findBetween(end, k, from.s + std::clamp(there, margin * width, (1 - margin) * width));
        if (side * p.value < -floor) return p;
        if (!hasRate) return std::nullopt;
        (side * p.rate < 0 ? from : to) = p;
    }
    return std::nullopt;
}

// Behind the crossing between two parts of the step, by bisection.
Real SwitchWatch::findCrossing(const Moment& end, size_t k, Real before, Real behind) {
    constexpr int Halvings = 20;
    const bool isPositive = findBetween(end, k, behind).value > 0;
    for (int i = 0; i < Halvings; ++i) {
        const Real middle = (before + behind) / 2;
        ((findBetween(end, k, middle).value > 0) == isPositive ? behind : before) = middle;
    }
    return behind;
}

std::optional<Excursion> SwitchWatch::check(const State& state, bool withOneWay) {
    constexpr Real AtBegin = 2e-6, AtEnd = 0.999;
    if (isEmpty()) return std::nullopt;
    const Moment end = makeMoment(state);
    const Real h = end.time - m_start.time;
    if (!(h > 0)) return std::nullopt;
    m_now.clear();
    m_source(state, m_now);
    std::optional<Excursion> first;
    const auto keep = [&](Real begin, Real behind) {
        const Excursion found{m_start.time + begin * h, m_start.time + behind * h};
        if (!first || found.begin < first->begin) first = found;
    };
    for (size_t k = 0; k < m_now.size(); ++k) {
        const Switch &a = m_last[k], &b = m_now[k];
        m_largest[k] = std::max({m_largest[k], std::abs(a.value), std::abs(b.value)});
        if (a.level == KinematicLevel::Acceleration) continue;
        if (a.value * b.value > 0 && a.value * a.rate < 0 && b.value * b.rate > 0) {
            const auto beyond = findBeyond(end, k, {0, a.value, a.rate * h}, {1, b.value, b.rate * h});
            if (beyond) keep(findCrossing(end, k, 0, beyond->s), findCrossing(end, k, 1, beyond->s));
        } else if (withOneWay && a.level == KinematicLevel::Position && a.value * b.value < 0) {
            const Real there = findCrossing(end, k, 0, 1);
            if (AtBegin < there && there < AtEnd) keep(there, 1);
        }
    }
    if (first) return first;
    m_last = m_now;
    m_start = end;
    return first;
}

}  // namespace jprim
