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
    if (!m_isStarted) start(state, kinetic, energy);
    m_leastKinetic = std::min(m_leastKinetic, kinetic);
    m_mostKinetic = std::max(m_mostKinetic, kinetic);
    m_summary.energyScale =
        std::max({m_mostKinetic - m_leastKinetic, HardlyChanging * m_mostKinetic, m_smallestScale});
    m_summary.energyAtEnd = energy;
    m_summary.largestEnergyChange =
        std::max(m_summary.largestEnergyChange, std::abs(energy - m_summary.energyAtStart));
    if (isJump(energy) && isNearSingular(m_mechanism, state))
        throw std::runtime_error(fmt::format(
            "the energy of this conservative mechanism has changed by {:.2g} of its kinetic energy within a step near "
            "a singular position: its motion through that is lost",
            std::abs(energy - m_lastEnergy) / m_lastKinetic));
    m_lastKinetic = kinetic;
    m_lastEnergy = energy;
}

void EnergyWatch::start(const State& state, Real kinetic, Real energy) {
    m_isStarted = true;
    m_summary.energyAtStart = m_lastEnergy = energy;
    m_leastKinetic = m_mostKinetic = m_lastKinetic = kinetic;
    m_smallestScale = calcSmallestScale(m_mechanism, state);
}

bool EnergyWatch::isJump(Real energy) const {
    constexpr Real OfRange = 1e-2, OfKinetic = 0.1;
    return std::abs(energy - m_lastEnergy) >
               std::max(OfRange * m_summary.energyScale, OfKinetic * m_lastKinetic) &&
           m_mechanism.isConservative();
}

}  // namespace jprim
