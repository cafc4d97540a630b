// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"
#include "simulation/break_watch.h"
#include "simulation/failure.h"
#include "simulation/integrators.h"
#include "simulation/motion_scale.h"
#include "simulation/quadrature.h"
#include "simulation/stall_watch.h"
#include "simulation/step_history.h"
#include "simulation/stepper.h"
#include "simulation/switch_watch.h"
#include "simulation/turning.h"

namespace jprim {

using SimTK::Integrator;
using SimTK::MultibodySystem;
using SimTK::Real;
using SimTK::State;

namespace {

class Integration final : public Stepper {
public:
    Integration(const Mechanism& mechanism, const State& initial, const SimulationOptions& options)
        : m_mechanism(mechanism),
          m_options(options),
          m_entry(findIntegrator(options.integrator)),
          m_scale(mechanism, initial),
          m_quadrature(mechanism.getSystem(), !m_entry.remembersSteps),
          m_breaks(BreakWatch::ofLoads(mechanism)),
          m_span(options.end * mechanism.getUnits().time - initial.getTime()),
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
        leaveBreaks(time);
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
        m_break = m_breaks.findAround(state.getTime(), m_span);
        m_quadrature.start(getState());
        lookAtMotion();
    }

    void takeStep(Real time) {
        const std::optional<TimeBreak> next = leaveBreaks(time);
        const Real now = getState().getTime();
        if (now >= time) return;
        const Real end =
            std::min({time, now + m_timeOfARadian, findEndInExcursion(), next ? next->before : time});
        try {
            if (isHardlyLater(end)) {
                skipTo(end);
            } else {
                adaptToMotion();
                takeOneStep(*m_integrator, end);
            }
        } catch (const std::exception& exception) {
            leaveNotFinite();
            if (!isStuck(exception) || !crossSingularPosition(time)) throw;
        }
        lookAtMotion();
        if (next && next->before <= getState().getTime()) cross(*next, time);
    }

    // CPodes may stop at a State without numbers.
    void leaveNotFinite() {
        State state = getState();
        if (std::isfinite(state.getY().norm())) return;
        m_history.goBack(state, state.getTime());
        restart(state);
    }

    // Crosses those where the State stands. Returns the next, if there is one not later than `time`.
    std::optional<TimeBreak> leaveBreaks(Real time) {
        Real from = getState().getTime();
        std::optional<TimeBreak> next = m_break;
        if (!next || from < next->before || next->behind <= from) next = m_breaks.findNext(from, time);
        while (next && next->before <= getState().getTime() && getState().getTime() < time) {
            cross(*next, time);
            from = std::max(getState().getTime(), next->behind);
            next = m_breaks.findNext(from, time);
        }
        return next;
    }

    // A step begins behind the break: all its stages are on one side. Only where accelerations jump is what CPodes
    // remembers of no more use, nor from rest the step and the motion that errors were held against. An output time may
    // be within the break.
    void cross(const TimeBreak& next, Real time) {
        const Real there = std::min(next.behind, time);
        BreakWatch::requireNoJump(m_mechanism, getState(), there);
        m_mechanism.getSystem().realize(getState(), SimTK::Stage::Acceleration);
        State behind = getState();
        behind.updTime() = there;
        m_mechanism.getSystem().realize(behind, SimTK::Stage::Acceleration);
        const bool isJump = BreakWatch::doRatesJump(getState(), behind, m_stateUnits.size());
        if (isJump || there < next.behind || !goesOnAtBreaks()) skipTo(there);
        m_break = next;
    }

    // From rest all of them remember what is of no use.
    bool goesOnAtBreaks() const { return m_entry.remembersSteps || m_isAtRest; }

    // Without integrating.
    void skipTo(Real time) {
        if (goesOnAtBreaks()) {
            State there = getState();
            there.updTime() = time;
            begin(there);
            return;
        }
        m_integrator->updAdvancedState().updTime() = time;
        m_integrator->reinitialize(SimTK::Stage::Time, false);
        m_mechanism.getSystem().realize(getState(), SimTK::Stage::Acceleration);
        m_quadrature.start(getState());
        lookAtMotion();
    }

    // By a few of the numbers that there are: CPodes refuses to.
    bool isHardlyLater(Real end) const {
        constexpr Real Few = 64;
        return end - getState().getTime() < Few * SimTK::Eps * std::max(std::abs(end), SimTK::Eps * m_span);
    }

    // What a step may have jumped over is gone through, from where it begins, by steps that do not.
    void lookBetween(const State& start, Real time) {
        constexpr int MostTrials = 20;
        for (int k = 0; k < MostTrials; ++k) {
            m_excursion = m_switches.check(getState(), m_entry.isBlindAtEnd);
            if (!m_excursion) return;
            begin(start);
            takeStep(time);
        }
        m_switches.start(getState());
    }

    Real findEndInExcursion() const {
        constexpr int Parts = 8;
        const Real now = getState().getTime();
        if (!m_excursion || now >= m_excursion->end) return SimTK::Infinity;
        if (now < m_excursion->begin && !isHardlyLater(m_excursion->begin)) return m_excursion->begin;
        return now + (m_excursion->end - m_excursion->begin) / Parts;
    }

    // CPodes stays at rest by long steps, if rounding errors do not keep it from them. What begins to move in such a
    // step was held against nothing, and is moved again.
    void stepFromRest(Real time) {
        constexpr Real Far = 10;
        const State start = getState();
        const MotionScale scale = m_scale;
        Real least = m_unit;
        for (takeStep(time); calcCommonUnit() < least / Far; takeStep(time)) {
            least = m_unit = calcCommonUnit();
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
        constexpr Real Ahead = 2;  // what moves a little more soon is worth no new beginning
        return m_isAtRest ? 1 : calcLargestUnit(Ahead);
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

    void takeOneStep(Integrator& integrator, Real end) const {
        advance(integrator, end);
        if (!m_entry.remembersSteps) project(m_mechanism, m_options, integrator);
    }

    State integrate(const State& from, Real end, Integrator& integrator) const {
        integrator.initialize(from);
        while (integrator.getTime() < end) takeOneStep(integrator, end);
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
    Real m_span;                       // of the run
    std::optional<TimeBreak> m_break;  // the last that was crossed, or where a beginning State stands
    SwitchWatch m_switches;
    StallWatch m_stall;
    std::optional<Excursion> m_excursion;  // the last that a step jumped over
    int m_numStepsBefore = 0;              // of integrators before this one
    int m_attempts = 0;                    // to get across the same singular position
    Real m_crossedUntil = -SimTK::Infinity;
};

}  // namespace

std::unique_ptr<Stepper> makeIntegration(const Mechanism& mechanism, const State& initial,
                                         const SimulationOptions& options) {
    return std::make_unique<Integration>(mechanism, initial, options);
}

}  // namespace jprim
