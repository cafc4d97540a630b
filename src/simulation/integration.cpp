// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"
#include "simulation/break_watch.h"
#include "simulation/failure.h"
#include "simulation/integrators.h"
#include "simulation/motion_scale.h"
#include "simulation/projection.h"
#include "simulation/quadrature.h"
#include "simulation/stall_watch.h"
#include "simulation/step_history.h"
#include "simulation/stepper.h"
#include "simulation/switch_watch.h"

namespace jprim {

using SimTK::Integrator;
using SimTK::MultibodySystem;
using SimTK::Real;
using SimTK::State;

namespace {

Real calcLargestAngularVelocity(const Mechanism& mechanism, const State& state) {
    Real w = 0;
    for (const MechanismPart& part : mechanism.getParts())
        if (!part.ground) w = std::max(w, part.body.getBodyAngularVelocity(state).norm());
    return w;
}

class Integration final : public Stepper {
public:
    Integration(const Mechanism& mechanism, const State& initial, const SimulationOptions& options)
        : m_mechanism(mechanism),
          m_options(options),
          m_entry(findIntegrator(options.integrator)),
          m_scale(mechanism, initial),
          m_quadrature(mechanism.getSystem()),
          m_breaks(BreakWatch::ofLoads(mechanism)),
          m_switches(mechanism.getSystem(), SwitchWatch::getLoads(mechanism)),
          m_stall(mechanism) {
        begin(initial);
        m_switches.start(getState());
        m_unit = calcCommonUnit();
        if (m_entry.remembersSteps && m_unit < 1) restart(initial);
        m_history.add(initial);
    }

    const State& getState() const override { return m_integrator->getState(); }
    int getNumSteps() const override { return m_numStepsBefore + m_integrator->getNumStepsTaken(); }

    void step(Real time) override {
        std::optional<State> start;
        if (!m_switches.isEmpty()) start = getState();
        if (m_entry.remembersSteps && m_isAtRest)
            stepFromRest(time);
        else
            takeStep(time);
        if (start) lookBetween(*start, time);
        m_history.add(getState());
        m_stall.observe(getState(), time);
    }

private:
    void restart(const State& state) {
        std::unique_ptr<Integrator> integrator = makeIntegrator(m_mechanism, m_options, m_entry, m_unit);
        integrator->initialize(state);
        if (m_integrator) m_numStepsBefore += m_integrator->getNumStepsTaken();
        m_integrator = std::move(integrator);
    }

    void begin(const State& state) {
        restart(state);
        m_quadrature.start(getState());
        lookAtMotion();
    }

    void takeStep(Real time) {
        const std::optional<TimeBreak> next = findBreak(time);
        const Real end = std::min(
            {time, getState().getTime() + m_timeOfARadian, findEndInExcursion(), next ? next->before : time});
        try {
            adaptToMotion();
            advance(*m_integrator, end);
            project(*m_integrator);
        } catch (const std::exception& exception) {
            if (!isStuck(exception) || !crossSingularPosition(time)) throw;
        }
        lookAtMotion();
        if (next && next->before <= getState().getTime()) crossBreak(*next, time);
    }

    // The next place for a step to end. One where the State stands is crossed; at zero, behind which numbers are too close,
    // integrators do so themselves.
    std::optional<TimeBreak> findBreak(Real time) {
        std::optional<TimeBreak> next = m_breaks.findNext(getState().getTime(), time);
        if (!next || next->before > getState().getTime()) return next;
        const Real behind = next->behind;
        if (getState().getTime() != 0) crossBreak(*next, time);
        next = m_breaks.findNext(behind, time);
        return next && next->before > getState().getTime() ? next : std::nullopt;
    }

    // A step begins behind the break: all its stages are on one side. Only where accelerations jump is what CPodes
    // remembers of no more use, nor from rest the step and the motion that errors were held against.
    void crossBreak(const TimeBreak& next, Real time) {
        constexpr Real Jump = 1e-2;
        BreakWatch::requireNoJump(m_mechanism, getState(), next.behind);
        State behind = getState();
        behind.updTime() = std::min(next.behind, time);
        m_mechanism.getSystem().realize(behind, SimTK::Stage::Acceleration);
        if (!m_entry.remembersSteps && !m_isAtRest) {
            m_integrator->updAdvancedState().updTime() = behind.getTime();
            m_integrator->reinitialize(SimTK::Stage::Time, false);
            m_quadrature.start(behind);
            lookAtMotion();
            return;
        }
        m_mechanism.getSystem().realize(getState(), SimTK::Stage::Acceleration);
        const SimTK::Vector& before = getState().getUDot();
        const SimTK::Vector jump = behind.getUDot() - before;
        if ((jump.size() > 0 && jump.normInf() > Jump * before.normInf()) || doRatesJump(behind, Jump))
            begin(behind);
    }

    bool doRatesJump(const State& behind, Real part) const {
        for (int k = 0; k < m_stateUnits.size(); ++k) {
            const Real before = getState().getZDot()[k];
            if (std::abs(behind.getZDot()[k] - before) > part * std::abs(before)) return true;
        }
        return false;
    }

    // What a step may have jumped over is gone through, from where it begins, by steps that do not.
    void lookBetween(const State& start, Real time) {
        constexpr int MostTrials = 20;
        for (int k = 0; k < MostTrials; ++k) {
            m_excursion = m_switches.check(getState(), m_entry.isBlindAtEnd);
            if (!m_excursion) return;
            begin(start);
            takeStep(std::min(time, m_excursion->begin));
        }
        m_switches.start(getState());
    }

    Real findEndInExcursion() const {
        constexpr int Parts = 8;
        const Real now = getState().getTime();
        if (!m_excursion || now >= m_excursion->end) return SimTK::Infinity;
        if (now < m_excursion->begin) return m_excursion->begin;
        return now + (m_excursion->end - m_excursion->begin) / Parts;
    }

    // CPodes stays at rest by long steps, if rounding errors do not keep it from them. What begins to move in such a
    // step was held against nothing, and is moved again.
    void stepFromRest(Real time) {
        constexpr Real Far = 10;
        const State start = getState();
        const MotionScale scale = m_scale;
        for (takeStep(time); calcCommonUnit() < m_unit / Far; takeStep(time)) {
            m_unit = calcCommonUnit();
            m_scale = scale;
            begin(start);
        }
    }

    void lookAtMotion() {
        constexpr Real First = 0.01;  // as Simbody's own
        const State& state = getState();
        m_mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
        m_timeOfARadian = calcTimeOfARadian(m_mechanism, state);
        m_scale.observe(state);
        m_isMechanismAtRest = m_scale.isAtRest(state, First);
        m_isAtRest = m_isMechanismAtRest && m_scale.areStatesAtRest(state, First);
        const bool isFirst = m_integrator->getNumStepsTaken() == 0;
        const Real h = isFirst ? First : m_integrator->getPredictedNextStepSize();
        m_units = m_scale.calcUnits(state, std::min(h, m_timeOfARadian), m_options.accuracy);
        m_stateUnits = m_scale.calcStateUnits(state, std::min(h, m_timeOfARadian));
        if (!m_entry.isRungeKutta && state.getNZ() > m_stateUnits.size())
            m_quadrature.advance(m_integrator->updAdvancedState());
    }

    // Errors are held against the motion that there is. CPodes knows one accuracy only, and begins anew with another.
    void adaptToMotion() {
        if (!m_entry.remembersSteps) {
            State& state = m_integrator->updAdvancedState();
            state.updUWeights() = m_units.elementwiseInvert();
            for (int k = 0; k < m_stateUnits.size(); ++k)
                state.updZWeights()[k] = 1 / (StateTightness * m_stateUnits[k]);
        } else if (!m_isAtRest && calcLargestUnit(1) > m_unit) {
            m_unit = calcCommonUnit();
            restart(getState());
        }
    }

    // The unit of a state above 1 is 1: there an integrator holds errors against the state itself.
    Real calcLargestUnit(Real ahead) const {
        Real unit = m_isMechanismAtRest || m_units.size() == 0 ? 1 : std::min(1., ahead * m_units.normInf());
        for (int k = 0; k < m_stateUnits.size(); ++k)
            unit = std::min(unit, StateTightness * std::min(1., ahead * m_stateUnits[k]));
        return unit;
    }

    Real calcCommonUnit() const {
        constexpr Real Ahead = 6;  // what moves a little more soon is worth no new beginning
        return m_isAtRest ? 1 : calcLargestUnit(Ahead);
    }

    static void advance(Integrator& integrator, Real end) {
        auto status = integrator.stepTo(end, end);
        if (status == Integrator::StartOfContinuousInterval) status = integrator.stepTo(end, end);
        if (status == Integrator::EndOfSimulation) throw Error("integrator", "ended before its time");
    }

    // Near a singular position an error of velocities, divided by the distance, is one of accelerations. Integrators can
    // be told to project every step, but then they project their estimates of errors as well, and in trees of few
    // freedoms take steps that are too long.
    void project(Integrator& integrator) const {
        if (m_entry.remembersSteps || integrator.getState().getNMultipliers() == 0) return;
        State& state = integrator.updAdvancedState();
        state.updUWeights() = 1;
        projectAtLeastOnce(m_mechanism.getSystem(), state, m_options.getConstraintTolerance());
        integrator.reinitialize(SimTK::Stage::Position, false);
    }

    // Next to a singular position accelerations are nothing but rounding errors divided by the distance, and no step
    // is short enough. From a little before it one step of fixed length leads across, by stages that are not near.
    // False if the integrator is not stuck for that reason.
    bool crossSingularPosition(Real time) {
        constexpr Real Turn = 1e-3, Beyond = 1. / 3, Wider = 8;  // rad; of the way there
        constexpr int MostAttempts = 3;
        State state = getState();
        m_mechanism.getSystem().realize(state, SimTK::Stage::Velocity);
        const Real w = calcLargestAngularVelocity(m_mechanism, state), there = state.getTime();
        m_attempts = there <= m_crossedUntil ? m_attempts + 1 : 0;
        if (w == 0 || m_attempts == MostAttempts || !isNearSingular(m_mechanism, state)) return false;
        const Real before = Turn / w * std::pow(Wider, m_attempts);
        m_history.goBack(state, there - before);
        state = integrate(state, there - before, *makeIntegrator(m_mechanism, m_options, m_entry));
        m_crossedUntil = std::min(time, there + Beyond * before);
        const auto across = makeIntegrator(m_mechanism, m_options, findIntegrator("RungeKuttaMerson"));
        across->setProjectEveryStep(true);
        across->setFixedStepSize(m_crossedUntil - state.getTime());
        restart(integrate(state, m_crossedUntil, *across));
        m_quadrature.start(getState());
        return true;
    }

    State integrate(const State& from, Real end, Integrator& integrator) const {
        integrator.initialize(from);
        while (integrator.getTime() < end) {
            advance(integrator, end);
            project(integrator);
        }
        return integrator.getState();
    }

    static constexpr Real StateTightness = 0.25;  // errors of states that vibrate add up over periods

    const Mechanism& m_mechanism;
    const SimulationOptions& m_options;
    const IntegratorEntry& m_entry;
    std::unique_ptr<Integrator> m_integrator;
    MotionScale m_scale;
    SimTK::Vector m_units;       // of speeds
    SimTK::Vector m_stateUnits;  // of the states of control systems
    Real m_unit = 1;             // of the integrator's accuracy
    bool m_isAtRest = true, m_isMechanismAtRest = true;
    Real m_timeOfARadian = 0;
    Quadrature m_quadrature;
    StepHistory m_history;
    BreakWatch m_breaks;
    SwitchWatch m_switches;
    StallWatch m_stall;
    std::optional<Excursion> m_excursion;  // the last that a step jumped over
    int m_numStepsBefore = 0;              // of integrators before this one
    int m_attempts = 0;                    // to get across the same singular position
    Real m_crossedUntil = -SimTK::Infinity;
};

}  // namespace

Real calcTimeOfARadian(const Mechanism& mechanism, const State& state) {
    const Real w = calcLargestAngularVelocity(mechanism, state);
    Real a = 0;
    for (const MechanismPart& part : mechanism.getParts())
        if (!part.ground) a = std::max(a, part.body.getBodyAngularAcceleration(state).norm());
    const Real rate = w + std::sqrt(w * w + 2 * a);
    return rate > 0 ? 2 / rate : SimTK::Infinity;
}

std::unique_ptr<Stepper> makeIntegration(const Mechanism& mechanism, const State& initial,
                                         const SimulationOptions& options) {
    return std::make_unique<Integration>(mechanism, initial, options);
}

}  // namespace jprim
