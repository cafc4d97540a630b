// SPDX-License-Identifier: Apache-2.0
#include "simulation/sensor_watch.h"

#include <cmath>

namespace jprim {

using SimTK::Real;
using SimTK::State;

namespace {

bool isTrue(const MechanismSensor& sensor, Real value) {
    switch (sensor.comparison) {
        case SensorComparison::GreaterOrEqual: return value >= -sensor.error;
        case SensorComparison::LessOrEqual: return value <= sensor.error;
        case SensorComparison::Equal: break;
    }
    return std::abs(value) <= sensor.error;
}

// An EQ that a step has jumped over was true in between.
bool isPassed(const MechanismSensor& sensor, Real before, Real now) {
    return sensor.comparison == SensorComparison::Equal && (before < 0) != (now < 0);
}

}  // namespace

SensorWatch::Values SensorWatch::calcValues(const State& state) const {
    m_mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
    Values values;
    for (const MechanismSensor& sensor : m_mechanism.getSensors())
        values.push_back(sensor.function.calcValue(state) - sensor.value);
    return values;
}

const MechanismSensor* SensorWatch::findFiring(const Values& before, const Values& now) const {
    const std::vector<MechanismSensor>& sensors = m_mechanism.getSensors();
    for (size_t k = 0; k < sensors.size(); ++k)
        if (isTrue(sensors[k], now[k]) || isPassed(sensors[k], before[k], now[k])) return &sensors[k];
    return nullptr;
}

// Bisection: nothing fires at `start`, something does where the stepper stands. A function that jumps may do so to
// its VALUE, so that being there is no sign of having found the moment.
const MechanismSensor* SensorWatch::step(std::unique_ptr<Stepper>& stepper, Real time) const {
    constexpr int Halvings = 40;
    Values before = calcValues(stepper->getState());
    State start = stepper->getState();
    stepper->step(time);
    const MechanismSensor* firing = findFiring(before, calcValues(stepper->getState()));
    if (!firing || findFiring(before, before)) return firing;
    for (int k = 0; k < Halvings; ++k) {
        const Real middle = (start.getTime() + stepper->getState().getTime()) / 2;
        std::unique_ptr<Stepper> trial = m_makeStepper(start);
        while (trial->getState().getTime() < middle) trial->step(middle);
        const Values there = calcValues(trial->getState());
        if (const MechanismSensor* earlier = findFiring(before, there)) {
            firing = earlier;
            stepper = std::move(trial);
        } else {
            before = there;
            start = trial->getState();
        }
    }
    return firing;
}

}  // namespace jprim
