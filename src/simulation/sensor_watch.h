// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_SENSOR_WATCH_H_
#define JPRIM_SRC_SIMULATION_SENSOR_WATCH_H_

#include <functional>
#include <memory>
#include <vector>

#include "jprim/simulation/simulate.h"
#include "simulation/break_watch.h"
#include "simulation/stepper.h"
#include "simulation/switch_watch.h"

namespace jprim {

/// Looks at the sensors of a mechanism after every step, and where one fires finds the moment.
class SensorWatch {
public:
    using MakeStepper = std::function<std::unique_ptr<Stepper>(const SimTK::State&)>;

    /// @param states       of the mechanism's sensors, kept up to date; must outlive the watch
    /// @param makeStepper  one that goes on from a State, by which a step is taken again in parts
    SensorWatch(const Mechanism& mechanism, std::vector<SensorState>& states, MakeStepper makeStepper)
        : m_mechanism(mechanism),
          m_states(states),
          m_makeStepper(std::move(makeStepper)),
          m_breaks(BreakWatch::ofSensors(mechanism)),
          m_switches(mechanism.getSystem(), makeSwitches()) {}

    /// One step, which does not go beyond `time`. If a sensor fires in it, the stepper is replaced by one that
    /// stands where the first sensor has just become true: where its function has come within ERROR of VALUE, or
    /// right behind a jump. One that is true within the step alone is not overlooked: see BreakWatch and SwitchWatch.
    /// An armed sensor that was true before the step fires at the end of it. All that are true where one fires have
    /// fired, and what they evaluate is in the State.
    /// @returns the sensor that ends the run, of several one with HALT if there is one; or null
    const MechanismSensor* step(std::unique_ptr<Stepper>& stepper, SimTK::Real time);

private:
    using Values = std::vector<SimTK::Real>;  // of the sensors' functions, less VALUE

    Values calcValues(const SimTK::State& state) const;
    bool isFiring(size_t sensor, const Values& before, const Values& now) const;
    bool isAnyFiring(const Values& before, const Values& now) const;
    SwitchWatch::Source makeSwitches() const;
    SimTK::Real findEnd(SimTK::Real now, SimTK::Real time);
    void lookBetween(const SimTK::State& start, std::unique_ptr<Stepper>& stepper);
    const MechanismSensor* update(std::unique_ptr<Stepper>& stepper, const Values& before, const Values& now);
    void evaluate(const std::vector<size_t>& sensors, std::unique_ptr<Stepper>& stepper) const;

    const Mechanism& m_mechanism;
    std::vector<SensorState>& m_states;
    MakeStepper m_makeStepper;
    BreakWatch m_breaks;
    SwitchWatch m_switches;
};

}  // namespace jprim

#endif
