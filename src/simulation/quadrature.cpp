// SPDX-License-Identifier: Apache-2.0
#include "simulation/quadrature.h"

#include <algorithm>
#include <cmath>

namespace jprim {

using SimTK::Real;
using SimTK::State;
using SimTK::Vector;

Quadrature::Moment Quadrature::makeMoment(const State& state) {
    return {state.getTime(),      Vector(state.getQ()),   Vector(state.getQDot()), Vector(state.getQDotDot()),
            Vector(state.getZ()), Vector(state.getZDot())};
}

void Quadrature::start(const State& state) {
    m_start = makeMoment(state);
    m_between = state;
}

// How far coordinates go. What their rates at both ends say of that is of fourth order in the step; a method of low order, and
// CPodes in the first steps behind a jump, know their rates far better than where that has led them.
Vector Quadrature::calcWay(const Moment& end) const {
    constexpr Real Resolved = 2e-3;  // of what they go; more is no matter of order
    const Real h = end.time - m_start.time;
    Vector way = end.q - m_start.q;
    const Vector ofRates = h / 2 * (m_start.qDot + end.qDot) + h * h / 12 * (m_start.qDotDot - end.qDotDot);
    for (int i = 0; i < way.size(); ++i) {
        const Real fastest = std::max(std::abs(m_start.qDot[i]), std::abs(end.qDot[i]));
        if (m_isOfLowOrder || std::abs(way[i] - ofRates[i]) > Resolved * h * fastest) way[i] = ofRates[i];
    }
    return way;
}

// Hermite's polynomials for values, rates and second derivatives at both ends; of states, which have no second ones, for
// values and rates.
Real Quadrature::calcRateBetween(const Moment& end, Real s) {
    const Moment& start = m_start;
    const Real h = end.time - start.time, r = 1 - s, s2 = s * s, r2 = r * r;
    const Real value = s2 * s * (10 - 15 * s + 6 * s2);
    const Real slope = 30 * s2 * r2;
    m_between.updTime() = start.time + s * h;
    m_between.updQ() = start.q + value * m_way +
                       h * (s * r2 * r * (1 + 3 * s) * start.qDot - r * s2 * s * (1 + 3 * r) * end.qDot) +
                       h * h / 2 * (s2 * r2 * r * start.qDotDot + r2 * s2 * s * end.qDotDot);
    m_between.updZ() =
        r2 * (1 + 2 * s) * start.z + s2 * (1 + 2 * r) * end.z + h * s * r * (r * start.zDot - s * end.zDot);
    m_system.realize(m_between, SimTK::Stage::Position);
    const Vector qDot = slope / h * m_way + r2 * (1 - 3 * s) * (1 + 5 * s) * start.qDot +
                        s2 * (1 - 3 * r) * (1 + 5 * r) * end.qDot +
                        h / 2 * s * r * (r * (2 - 5 * s) * start.qDotDot - s * (2 - 5 * r) * end.qDotDot);
    Vector u;
    m_system.getMatterSubsystem().multiplyByNInv(m_between, false, qDot, u);
    m_between.updU() = u;
    m_system.realize(m_between, SimTK::Stage::Acceleration);
    const Real rate = m_between.getZDot()[m_between.getNZ() - 1];
    m_between.autoUpdateDiscreteVariables();
    return rate;
}

// The rule's two inner points alone are a rule of second order, and their difference shows where rates are not smooth.
Real Quadrature::calcIntegral(const Moment& end, Real a, Real rateA, Real b, Real rateB, int halvings) {
    constexpr Real OfTurnover = 1e-3;
    const Real inner = (1 - 1 / std::sqrt(5.)) / 2, twelfth = (b - a) * (end.time - m_start.time) / 12;
    const Real inside = calcRateBetween(end, a + inner * (b - a)) + calcRateBetween(end, b - inner * (b - a));
    const Real integral = twelfth * (rateA + 5 * inside + rateB);
    const Real doubt = twelfth * std::abs(rateA - inside + rateB);
    if (halvings == 0 || doubt <= OfTurnover * (m_turnover + std::abs(integral))) return integral;
    const Real middle = (a + b) / 2;
    const Real rate = calcRateBetween(end, middle);
    return calcIntegral(end, a, rateA, middle, rate, halvings - 1) +
           calcIntegral(end, middle, rate, b, rateB, halvings - 1);
}

void Quadrature::advance(State& state) {
    constexpr int MostHalvings = 5;
    const Moment end = makeMoment(state);
    if (end.time <= m_start.time) return;
    m_way = calcWay(end);
    const Real integral = calcIntegral(end, 0, m_start.getPower(), 1, end.getPower(), MostHalvings);
    m_turnover += std::abs(integral);
    const int work = state.getNZ() - 1;
    state.updZ()[work] = m_start.z[work] + integral;
    m_start = end;
    m_start.z = state.getZ();
}

}  // namespace jprim
