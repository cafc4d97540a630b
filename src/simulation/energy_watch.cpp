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

// The work of the parts' weights over their sizes.
Real calcWorkOfWeights(const Mechanism& mechanism, const State& state) {
    Real work = 0;
    for (const MechanismPart& part : mechanism.getParts())
        if (!part.ground) work += part.body.getBodyMass(state) * part.size * mechanism.getGravity().norm();
    return work;
}

// The kinetic energy at speeds that an integrator does not tell from rest: its accuracy is absolute where speeds are
// small. Some fifty accuracies are what runs at rest were found to have.
Real calcUnnoticedEnergy(const Mechanism& mechanism, const State& state, Real accuracy) {
    constexpr Real Accuracies = 100, Fastest = 0.01;
    const Real speed = std::min(Accuracies * accuracy, Fastest);
    Real mass = 0;
    for (const MechanismPart& part : mechanism.getParts())
        if (!part.ground) mass += part.body.getBodyMass(state);
    return mass * speed * speed / 2;
}

}  // namespace

void EnergyWatch::start(const State& state, Real energy) {
    constexpr Real HardlyMoving = 1e-9;
    m_isStarted = true;
    m_leastKinetic = m_mostKinetic = m_kinetic;
    m_summary.energyAtStart = energy;
    m_smallestScale = HardlyMoving * calcWorkOfWeights(m_mechanism, state);
    m_unnoticed = calcUnnoticedEnergy(m_mechanism, state, m_accuracy);
}

void EnergyWatch::observe(const State& state) {
    constexpr Real HardlyChanging = 1e-3, Tolerable = 1e-3;
    m_kinetic = m_mechanism.calcKineticEnergy(state);
    m_summary.energyAtEnd = m_kinetic + m_mechanism.getSystem().calcPotentialEnergy(state);
    if (!m_isStarted) start(state, m_summary.energyAtEnd);
    m_leastKinetic = std::min(m_leastKinetic, m_kinetic);
    m_mostKinetic = std::max(m_mostKinetic, m_kinetic);
    m_summary.energyScale =
        std::max({m_mostKinetic - m_leastKinetic, HardlyChanging * m_mostKinetic, m_smallestScale});
    m_summary.tolerableImbalance = std::max(Tolerable * m_summary.energyScale, m_unnoticed);
    m_summary.largestEnergyChange =
        std::max(m_summary.largestEnergyChange, std::abs(m_summary.energyAtEnd - m_summary.energyAtStart));
}

void EnergyWatch::checkBalance(const State& state) {
    constexpr Real OfRange = 1e-2, OfKinetic = 0.1, OfScale = 1e4;
    const Real balance = m_mechanism.calcEnergyBalance(state);
    if (!m_balanceAtStart) m_balanceAtStart = m_lastBalance = balance;
    m_summary.largestImbalance = std::max(m_summary.largestImbalance, std::abs(balance - *m_balanceAtStart));
    const Real jump = std::abs(balance - m_lastBalance);
    const Real tolerable = std::max(
        {OfRange * m_summary.energyScale, OfKinetic * m_lastKinetic, OfScale * m_smallestScale, m_unnoticed});
    if (jump > tolerable && isNearSingular(m_mechanism, state))
        throw std::runtime_error(fmt::format(
            "{:.2g} of the kinetic energy has come from nowhere or is lost within a step near a singular position, and with "
            "it the motion through that",
            jump / std::max({jump, m_kinetic, m_lastKinetic})));
    m_lastBalance = balance;
    m_lastKinetic = m_kinetic;
}

}  // namespace jprim
