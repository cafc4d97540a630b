// SPDX-License-Identifier: Apache-2.0
#include "simulation/sensor_watch.h"

#include <algorithm>
#include <cmath>

#include "force/expression_measure_impl.h"
#include "marker/find_implementation.h"

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
    if (!sensor.acts() || m_states[k] != SensorState::Armed) return false;
    return isTrue(sensor, now[k]) || isPassed(sensor, before[k], now[k]);
}

bool SensorWatch::isAnyFiring(const Values& before, const Values& now) const {
    for (size_t k = 0; k < now.size(); ++k)
        if (isFiring(k, before, now)) return true;
    return false;
}

// What happened in a step: who has fired, and who is armed again.
const MechanismSensor* SensorWatch::update(std::unique_ptr<Stepper>& stepper, const Values& before,
                                           const Values& now) {
    const std::vector<MechanismSensor>& sensors = m_mechanism.getSensors();
    const MechanismSensor* firing = nullptr;
    std::vector<size_t> evaluating;
    for (size_t k = 0; k < sensors.size(); ++k) {
        if (isFiring(k, before, now)) {
            m_states[k] = SensorState::Fired;
            if (sensors[k].evaluate) evaluating.push_back(k);
            if (sensors[k].ends && (!firing || (sensors[k].halt && !firing->halt))) firing = &sensors[k];
        } else if (m_states[k] == SensorState::Fired && !isTrue(sensors[k], now[k])) {
            m_states[k] = SensorState::Armed;
        }
    }
    if (!evaluating.empty()) evaluate(evaluating, stepper);
    return firing;
}

// All of the same State; the motion goes on from it with what was noted.
void SensorWatch::evaluate(const std::vector<size_t>& sensors, std::unique_ptr<Stepper>& stepper) const {
    const State& there = stepper->getState();
    m_mechanism.getSystem().realize(there, SimTK::Stage::Acceleration);
    State noted = there;
    for (const size_t k : sensors)
        m_mechanism.setSensorValue(noted, k, m_mechanism.getSensors()[k].evaluate->calcValue(there));
    stepper = m_makeStepper(noted);
}

// The ends of the range of a sensor are switches like those of its function.
SwitchWatch::Source SensorWatch::makeSwitches() const {
    return [this](const State& state, std::vector<SwitchWatch::Switch>& switches) {
        for (size_t k = 0; k < m_states.size(); ++k) {
            const MechanismSensor& sensor = m_mechanism.getSensors()[k];
            const size_t first = switches.size();
            findImplementation<ExpressionMeasureImpl>(sensor.function)
                ->getExpression()
                .addSwitches(state, true, switches);
            const SwitchWatch::Switch result = switches.back();
            switches.back().value -= sensor.value - sensor.error;
            switches.push_back({result.value - sensor.value - sensor.error, result.rate, result.level});
            if (sensor.acts() && m_states[k] == SensorState::Armed) continue;
            for (size_t i = first; i < switches.size(); ++i)
                switches[i] = {1, 0, KinematicLevel::Acceleration};
        }
    };
}

// No step goes on over a moment at which time alone changes a sensor.
Real SensorWatch::findEnd(Real now, Real time) {
    std::optional<TimeBreak> next = m_breaks.findNext(now, time);
    if (next && next->before <= now) next = m_breaks.findNext(next->behind, time);
    return next && next->before > now ? std::min(next->before, time) : time;
}

// Where a sensor may have fired within a step alone, the step is taken again as far as that.
void SensorWatch::lookBetween(const State& start, std::unique_ptr<Stepper>& stepper) {
    m_mechanism.getSystem().realize(start, SimTK::Stage::Acceleration);
    m_switches.start(start);
    const std::optional<Excursion> excursion = m_switches.check(stepper->getState());
    if (!excursion) return;
    const Real inside = (excursion->begin + excursion->end) / 2;
    stepper = m_makeStepper(start);
    while (stepper->getState().getTime() < inside) stepper->step(inside);
}

// Bisection: nothing fires at `start`, something does where the stepper stands. A function that jumps may do so to
// its VALUE, so that being there is no sign of having found the moment.
const MechanismSensor* SensorWatch::step(std::unique_ptr<Stepper>& stepper, Real time) {
    constexpr int Halvings = 40;
    Values before = calcValues(stepper->getState());
    State start = stepper->getState();
    stepper->step(findEnd(start.getTime(), time));
    Values now = calcValues(stepper->getState());
    if (!isAnyFiring(before, now)) {
        lookBetween(start, stepper);
        now = calcValues(stepper->getState());
    }
    if (!isAnyFiring(before, now) || isAnyFiring(before, before)) return update(stepper, before, now);
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
    return update(stepper, before, now);
}

}  // namespace jprim
