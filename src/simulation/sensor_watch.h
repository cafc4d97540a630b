// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_SENSOR_WATCH_H_
#define JPRIM_SRC_SIMULATION_SENSOR_WATCH_H_

#include <functional>
#include <memory>
#include <vector>

#include "simulation/stepper.h"

namespace jprim {

/// Looks at the sensors of a mechanism after every step, and where one fires finds the moment.
class SensorWatch {
public:
    using MakeStepper = std::function<std::unique_ptr<Stepper>(const SimTK::State&)>;

    /// @param makeStepper  one that goes on from a State, by which a step is taken again in parts
    SensorWatch(const Mechanism& mechanism, MakeStepper makeStepper)
        : m_mechanism(mechanism), m_makeStepper(std::move(makeStepper)) {}

    /// One step, which does not go beyond `time`. If a sensor fires in it, the stepper is replaced by one that
    /// stands where the first sensor has just become true: where its function has come within ERROR of VALUE, or
    /// right behind a jump. A sensor that was true before the step fires at the end of it.
    /// @returns the sensor that fires, or null
    const MechanismSensor* step(std::unique_ptr<Stepper>& stepper, SimTK::Real time) const;

private:
    using Values = std::vector<SimTK::Real>;  // of the sensors' functions, less VALUE

    Values calcValues(const SimTK::State& state) const;
    const MechanismSensor* findFiring(const Values& before, const Values& now) const;

    const Mechanism& m_mechanism;
    MakeStepper m_makeStepper;
};

}  // namespace jprim

#endif
