// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_ENERGY_WATCH_H_
#define JPRIM_SRC_SIMULATION_ENERGY_WATCH_H_

#include <optional>

#include "jprim/mechanism/mechanism.h"
#include "jprim/simulation/simulate.h"

namespace jprim {

/// Keeps account of the energy of a mechanism from step to step.
class EnergyWatch {
public:
    /// @param summary  where start, end and largest changes of the energy are written
    EnergyWatch(const Mechanism& mechanism, SimulationSummary& summary)
        : m_mechanism(mechanism), m_summary(summary) {}

    /// Requires Stage::Velocity, and at the start Stage::Dynamics.
    void observe(const SimTK::State& state);

    /// Of integrated motions, after observe(). Requires Stage::Acceleration.
    /// @throws std::runtime_error if the balance has changed since the last call, and has done so near a singular
    ///         position: the mechanism has been thrown off its motion
    void checkBalance(const SimTK::State& state);

private:
    void start(const SimTK::State& state, SimTK::Real energy);
    SimTK::Real addTurnover(const SimTK::State& state);

    const Mechanism& m_mechanism;
    SimulationSummary& m_summary;
    bool m_isStarted = false;
    std::optional<SimTK::Real> m_balanceAtStart;
    SimTK::Real m_kinetic = 0, m_lastBalance = 0, m_lastKinetic = 0;
    SimTK::Real m_leastKinetic = 0, m_mostKinetic = 0;
    SimTK::Real m_smallestScale = 0;
    SimTK::Real m_lastTime = 0, m_lastPower = 0, m_turnover = 0;
};

}  // namespace jprim

#endif
