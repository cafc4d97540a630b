// SPDX-License-Identifier: Apache-2.0
#include "simulation/energy_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "simulation/failure.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;

namespace {

// The work of the parts' weights over their sizes, times what is hardly a motion.
Real calcSmallestScale(const Mechanism& mechanism, const State& state) {
    constexpr Real HardlyMoving = 1e-9;
    Real work = 0;
    for (const MechanismPart& part : mechanism.getParts())
        if (!part.ground) work += part.body.getBodyMass(state) * part.size * mechanism.getGravity().norm();
    return HardlyMoving * work;
}

}  // namespace

void EnergyWatch::observe(const State& state) {
    constexpr Real HardlyChanging = 1e-3;
    const Real kinetic = m_mechanism.calcKineticEnergy(state);
    const Real energy = kinetic + m_mechanism.getSystem().calcPotentialEnergy(state);
    if (!m_isStarted) {
        m_isStarted = true;
        m_summary.energyAtStart = energy;
        m_leastKinetic = m_mostKinetic = kinetic;
        m_smallestScale = calcSmallestScale(m_mechanism, state);
    }
    m_leastKinetic = std::min(m_leastKinetic, kinetic);
    m_mostKinetic = std::max(m_mostKinetic, kinetic);
    m_summary.energyScale =
        std::max({m_mostKinetic - m_leastKinetic, HardlyChanging * m_mostKinetic, m_smallestScale});
    m_summary.energyAtEnd = energy;
    m_summary.largestEnergyChange =
        std::max(m_summary.largestEnergyChange, std::abs(energy - m_summary.energyAtStart));
}

void EnergyWatch::checkBalance(const State& state) {
    constexpr Real OfRange = 1e-2, OfKinetic = 0.1;
    const Real balance = m_mechanism.calcEnergyBalance(state);
    if (!m_balanceAtStart) m_balanceAtStart = m_lastBalance = balance;
    const Real jump = std::abs(balance - m_lastBalance);
    const Real tolerable = std::max(OfRange * m_summary.energyScale, OfKinetic * m_lastKinetic);
    m_summary.largestImbalance = std::max(m_summary.largestImbalance, std::abs(balance - *m_balanceAtStart));
    if (jump > tolerable && isNearSingular(m_mechanism, state))
        throw std::runtime_error(fmt::format(
            "{:.2g} of the kinetic energy has come from nowhere or is lost within a step near a singular position, and with "
            "it the motion through that",
            jump / m_lastKinetic));
    m_lastBalance = balance;
    m_lastKinetic = m_mechanism.calcKineticEnergy(state);
}

}  // namespace jprim
