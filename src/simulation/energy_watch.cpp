// SPDX-License-Identifier: Apache-2.0
#include "simulation/energy_watch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/format.h"
#include "force/marker_force_impl.h"
#include "marker/find_implementation.h"
#include "simulation/failure.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;

namespace {

Real calcMass(const Mechanism& mechanism, const State& state) {
    Real mass = 0;
    for (const MechanismPart& part : mechanism.getParts())
        if (!part.ground) mass += part.body.getBodyMass(state);
    return mass;
}

// The work of the parts' weights over their heights and sizes, and of forces, as they are, over the sizes: what potential
// energies are the difference of.
Real calcWorkOfLoads(const Mechanism& mechanism, const State& state) {
    Real work = 0, size = 0;
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        work += part.body.getBodyMass(state) *
                (part.size * mechanism.getGravity().norm() +
                 std::abs(~mechanism.getGravity() * part.cm.findPoseInGround(state).p()));
        size = std::max(size, part.size);
    }
    for (const Element& element : mechanism.getElements()) {
        if (!element.isForce()) continue;
        const SimTK::SpatialVec load = element.onI(state);
        work += load[0].norm() + size * load[1].norm();
    }
    return work;
}

// The powers of what may put energy in or take it out, each counted as positive.
Real calcTurnover(const Mechanism& mechanism, const State& state) {
    Real turnover = 0;
    for (const Element& element : mechanism.getElements()) {
        if (element.isDisabled(state)) continue;
        if (const MarkerForce* force = element.getForce())
            turnover += std::abs(findImplementation<MarkerForceImpl>(*force)->calcPower(state));
        if (const GeneralConstraint* constraint = element.getGeneralConstraint())
            turnover += std::abs(constraint->calcPower(state));
    }
    return turnover;
}

}  // namespace

void EnergyWatch::start(const State& state, Real energy) {
    constexpr Real Rounding = 4e-13, Rest = 1e-9;  // a speed
    m_isStarted = true;
    m_leastKinetic = m_mostKinetic = m_kinetic;
    m_summary.energyAtStart = energy;
    m_smallestScale =
        Rounding * calcWorkOfLoads(m_mechanism, state) + Rest * Rest * calcMass(m_mechanism, state);
}

void EnergyWatch::observe(const State& state) {
    // Motions that are right to a thousandth have such errors of energy.
    constexpr Real HardlyChanging = 1e-3, OfRange = 5e-3, OfLargest = 1e-3;
    m_kinetic = m_mechanism.calcKineticEnergy(state);
    m_summary.energyAtEnd = m_kinetic + m_mechanism.getSystem().calcPotentialEnergy(state);
    if (!m_isStarted) start(state, m_summary.energyAtEnd);
    m_leastKinetic = std::min(m_leastKinetic, m_kinetic);
    m_mostKinetic = std::max(m_mostKinetic, m_kinetic);
    m_summary.energyScale =
        std::max({m_mostKinetic - m_leastKinetic, HardlyChanging * m_mostKinetic, m_smallestScale});
    m_summary.largestEnergyChange =
        std::max(m_summary.largestEnergyChange, std::abs(m_summary.energyAtEnd - m_summary.energyAtStart));
    m_summary.tolerableImbalance = std::max({OfRange * m_summary.energyScale, OfLargest * m_mostKinetic,
                                             OfRange * m_summary.largestEnergyChange});
}

// What is braked as much as it is driven moves no more energy than before, but its errors are those of both.
Real EnergyWatch::addTurnover(const State& state) {
    const Real power = calcTurnover(m_mechanism, state);
    if (m_balanceAtStart) m_turnover += (state.getTime() - m_lastTime) * (m_lastPower + power) / 2;
    m_lastTime = state.getTime();
    m_lastPower = power;
    return m_turnover;
}

void EnergyWatch::checkBalance(const State& state) {
    constexpr Real OfRange = 1e-2, OfKinetic = 0.1, OfScale = 2.5e7, OfTurnover = 1e-3;
    m_summary.tolerableImbalance = std::max(m_summary.tolerableImbalance, OfTurnover * addTurnover(state));
    const Real balance = m_mechanism.calcEnergyBalance(state);
    if (!m_balanceAtStart) m_balanceAtStart = m_lastBalance = balance;
    m_summary.largestImbalance = std::max(m_summary.largestImbalance, std::abs(balance - *m_balanceAtStart));
    const Real jump = std::abs(balance - m_lastBalance);
    const Real tolerable = std::max({OfRange * m_summary.energyScale, OfKinetic * m_lastKinetic,
                                     OfScale * m_smallestScale, m_summary.tolerableImbalance});
    if (jump > tolerable && isNearSingular(m_mechanism, state))
        throw std::runtime_error(fmt::format(
            "{:.2g} of the kinetic energy has come from nowhere or is lost within a step near a singular position, and with "
            "it the motion through that",
            jump / std::max({jump, m_kinetic, m_lastKinetic})));
    m_lastBalance = balance;
    m_lastKinetic = m_kinetic;
}

}  // namespace jprim
