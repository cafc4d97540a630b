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

bool SensorWatch::isFiring(size_t k, const Values& before, const Values& now) const {
    const MechanismSensor& sensor = m_mechanism.getSensors()[k];
    if (!sensor.ends || m_states[k] != SensorState::Armed) return false;
    return isTrue(sensor, now[k]) || isPassed(sensor, before[k], now[k]);
}

bool SensorWatch::isAnyFiring(const Values& before, const Values& now) const {
    for (size_t k = 0; k < now.size(); ++k)
        if (isFiring(k, before, now)) return true;
    return false;
}

// What happened in a step: who has fired, and who is armed again.
const MechanismSensor* SensorWatch::update(const Values& before, const Values& now) {
    const std::vector<MechanismSensor>& sensors = m_mechanism.getSensors();
    const MechanismSensor* firing = nullptr;
    for (size_t k = 0; k < sensors.size(); ++k) {
        if (isFiring(k, before, now)) {
            m_states[k] = SensorState::Fired;
            if (!firing || (sensors[k].halt && !firing->halt)) firing = &sensors[k];
        } else if (m_states[k] == SensorState::Fired && !isTrue(sensors[k], now[k])) {
            m_states[k] = SensorState::Armed;
        }
    }
    return firing;
}

// Bisection: nothing fires at `start`, something does where the stepper stands. A function that jumps may do so to
// its VALUE, so that being there is no sign of having found the moment.
const MechanismSensor* SensorWatch::step(std::unique_ptr<Stepper>& stepper, Real time) {
    constexpr int Halvings = 40;
    Values before = calcValues(stepper->getState());
    State start = stepper->getState();
    stepper->step(time);
    Values now = calcValues(stepper->getState());
    if (!isAnyFiring(before, now) || isAnyFiring(before, before)) return update(before, now);
    for (int k = 0; k < Halvings; ++k) {
        const Real middle = (start.getTime() + stepper->getState().getTime()) / 2;
        std::unique_ptr<Stepper> trial = m_makeStepper(start);
        while (trial->getState().getTime() < middle) trial->step(middle);
        const Values there = calcValues(trial->getState());
        if (isAnyFiring(before, there)) {
            now = there;
            stepper = std::move(trial);
        } else {
            before = there;
            start = trial->getState();
        }
    }
    return update(before, now);
}

}  // namespace jprim
