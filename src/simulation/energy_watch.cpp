// SPDX-License-Identifier: Apache-2.0
#include "simulation/energy_watch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/format.h"
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

// The work of the parts' weights and of forces, as they are, over the parts' sizes.
Real calcWorkOfLoads(const Mechanism& mechanism, const State& state) {
    Real work = 0, size = 0;
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        work += part.body.getBodyMass(state) * part.size * mechanism.getGravity().norm();
        size = std::max(size, part.size);
    }
    for (const LoadElement& element : mechanism.getLoadElements()) {
        if (element.isConstraint) continue;
        const SimTK::SpatialVec load = element.onI(state);
        work += load[0].norm() + size * load[1].norm();
    }
    return work;
}

}  // namespace

void EnergyWatch::start(const State& state, Real energy) {
    constexpr Real Rounding = 1e-10, Rest = 1e-9;  // a speed
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

void EnergyWatch::checkBalance(const State& state) {
    constexpr Real OfRange = 1e-2, OfKinetic = 0.1, OfScale = 1e5;
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
