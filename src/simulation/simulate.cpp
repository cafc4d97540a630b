// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/simulate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include "base/format.h"
#include "jprim/analysis/constraint_report.h"
#include "jprim/base/error.h"
#include "simulation/energy_watch.h"
#include "simulation/equation_access.h"
#include "simulation/failure.h"
#include "simulation/output_times.h"
#include "simulation/reaction_watch.h"
#include "simulation/recorder.h"
#include "simulation/redundancy.h"
#include "simulation/sensor_watch.h"
#include "simulation/stepper.h"
#include "simulation/violation.h"

namespace jprim {

using SimTK::Real;
using SimTK::Stage;
using SimTK::State;

namespace {

void checkOptions(const SimulationOptions& options, double start) {
    if (options.steps == 0) return;
    if (!(options.end > start) || !std::isfinite(options.end))
        throw Error("end", fmt::format("{} is not a time after the start at {}", options.end, start));
    checkIntegratorName(options.integrator);
    if (options.steps < 1) throw Error("steps", fmt::format("{} is not a positive number", options.steps));
    if (!(options.accuracy > 0 && options.accuracy < 1))
        throw Error("accuracy", fmt::format("{} is not between 0 and 1", options.accuracy));
    if (!(options.getConstraintTolerance() > 0 && options.getConstraintTolerance() < 1))
        throw Error("constraint tolerance",
                    fmt::format("{} is not between 0 and 1", options.getConstraintTolerance()));
    if (!(options.maximumStep > 0))
        throw Error("maximum step", fmt::format("{} is not a positive time", options.maximumStep));
}

bool isHolonomic(const Mechanism& mechanism, const State& state) {
    const auto equations = mechanism.findEquations(state);
    return std::all_of(equations.begin(), equations.end(),
                       [](const auto& e) { return e.level == KinematicLevel::Position; });
}

bool isKinematic(const Mechanism& mechanism, const State& state, int freedoms, SimulationKind kind) {
    const auto& states = mechanism.getStates();
    if (kind == SimulationKind::Kinematics && !states.empty())
        throw Error("kinematics",
                    fmt::format("nothing is integrated there, as the state of {} has to be; run "
                                "dynamics instead",
                                states.front().name));
    const bool isPossible = freedoms == 0 && states.empty() && isHolonomic(mechanism, state);
    if (kind == SimulationKind::Kinematics && !isPossible)
        throw Error(
            "kinematics",
            fmt::format("needs a mechanism without freedoms and without MOTIONs or GCONs of velocities; "
                        "this one has {} degrees of freedom; run dynamics instead",
                        freedoms));
    return isPossible && (kind == SimulationKind::Automatic || kind == SimulationKind::Kinematics);
}

/// One simulation: the loop over output times and what happens at each.
class Simulation {
public:
    Simulation(const Mechanism& mechanism, const SimulationOptions& options, ResultSink& sink)
        : m_mechanism(mechanism),
          m_options(options),
          m_recorder(mechanism, sink),
          m_energy(mechanism, m_outcome.summary),
          m_reactions(mechanism),
          m_watch(mechanism, m_outcome.sensors,
                  [this](const State& state) { return makeStepperFrom(state); }) {}

    SimulationOutcome run(const State& initial) {
        const double second = m_mechanism.getUnits().time, start = initial.getTime() / second;
        checkOptions(m_options, start);
        const OutputTimes times(m_options, start);
        m_outcome.sensors = m_options.sensors;
        m_outcome.sensors.resize(m_mechanism.getSensors().size(), SensorState::Armed);
        const auto started = std::chrono::steady_clock::now();
        State prepared = initial;
        prepare(prepared);
        m_stepper = makeStepperFrom(prepared);
        try {
            for (int k = 0; k <= times.getNumSteps() && !m_firing; ++k) {
                if (k > 0) stepTo(times.getTime(k) * second);
                record();
                if (m_options.reportProgress)
                    m_options.reportProgress(k == 0 ? 0 : double(k) / times.getNumSteps());
            }
        } catch (const std::exception& exception) {
            m_outcome.failure = describeFailure(m_mechanism, m_stepper->getState(), exception);
        }
        m_outcome.summary.notFinite = m_recorder.getNotFinite();
        m_outcome.finalState = m_stepper->getState();
        resetEquationScales(m_mechanism, m_outcome.finalState);
        if (m_dropped) m_dropped->restore(m_outcome.finalState);
        m_outcome.summary.stepsTaken = m_numSteps + (m_firing ? 1 : 0);
        m_outcome.summary.wallSeconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
        return std::move(m_outcome);
    }

private:
    void prepare(State& state) {
        m_mechanism.getSystem().realize(state, Stage::Velocity);
        const ConstraintCount count = countFreedoms(m_mechanism.getMatter(), state);
        SimulationSummary& summary = m_outcome.summary;
        summary.degreesOfFreedom = count.getDegreesOfFreedom();
        summary.redundantEquations = count.getNumRedundant();
        summary.isKinematic = isKinematic(m_mechanism, state, summary.degreesOfFreedom, m_options.kind);
        if (m_options.redundancy == Redundancy::Drop)
            drop(DropChoice::Later, state);
        else if (count.hasOnlyEmptyHolonomic || isWithout(state))
            drop(DropChoice::Empty, state);
        if (m_dropped) summary.droppedEquations = m_dropped->getTexts();
        scale(state);
    }

    // Assembly has left out what the dataset's numbers contradict.
    bool isWithout(const State& state) const {
        const auto equations = m_mechanism.findEquations(state);
        return std::any_of(equations.begin(), equations.end(), [](const auto& e) { return e.isDropped(); });
    }

    void scale(State& state) {
        setEquationScales(m_mechanism, state);
        m_mechanism.getSystem().realize(state, Stage::Velocity);
        m_equations = m_mechanism.findEquations(state);
    }

    void drop(DropChoice choice, State& state) {
        m_dropped.emplace(m_mechanism, state, choice);
        m_mechanism.getSystem().realize(state, Stage::Velocity);
    }

    // What is kept may become dependent where all equations together are not, as those of a Bennett linkage do.
    void keepDroppedApart() {
        if (m_options.redundancy != Redundancy::Drop || !m_dropped->isWeak(m_stepper->getState())) return;
        State state = m_stepper->getState();
        const std::vector<std::string> before = m_dropped->getTexts();
        m_dropped->restore(state);
        m_mechanism.getSystem().realize(state, Stage::Velocity);
        drop(DropChoice::Weakest, state);
        if (m_dropped->getTexts() == before) return;
        m_outcome.summary.droppedAnew.push_back(
            {state.getTime() / m_mechanism.getUnits().time, m_dropped->getTexts()});
        scale(state);
        m_numStepsBefore += m_stepper->getNumSteps();
        m_stepper = makeStepperFrom(state);
    }

    std::unique_ptr<Stepper> makeStepperFrom(const State& state) const {
        if (m_options.kind == SimulationKind::Statics) return makeStatics(m_mechanism, state);
        if (m_outcome.summary.isKinematic) return makeKinematics(m_mechanism, state, m_options);
        return makeIntegration(m_mechanism, state, m_options);
    }

    void stepTo(Real time) {
        while (!m_firing && m_stepper->getState().getTime() < time) {
            if (m_mechanism.getSensors().empty())
                m_stepper->step(time);
            else
                m_firing = m_watch.step(m_stepper, time);
            if (!m_firing) m_numSteps = m_numStepsBefore + m_stepper->getNumSteps();
            keepDroppedApart();
            if (m_stepper->getState().getTime() < time) watchEnergy();
        }
        if (!m_firing) return;
        m_outcome.summary.endedBy = m_firing->id.getText();
        m_outcome.summary.isHalted = m_firing->halt;
    }

    // Statics and kinematics keep no balance.
    void watchEnergy() {
        const State& state = m_stepper->getState();
        m_mechanism.getSystem().realize(state, Stage::Velocity);
        m_energy.observe(state);
        const bool isIntegrated = m_options.kind != SimulationKind::Statics && !m_outcome.summary.isKinematic;
        if (!isIntegrated) return;
        m_mechanism.getSystem().realize(state, Stage::Acceleration);
        m_energy.checkBalance(state);
    }

    void record() {
        const State& state = m_stepper->getState();
        m_mechanism.getSystem().realize(state, Stage::Acceleration);
        watchEnergy();
        if (m_outcome.summary.isKinematic)
            m_equations = m_mechanism.findEquations(state);  // their scales change
        const Violation violation = calcViolation(m_equations, state);
        checkPositions(state, violation);
        checkAccelerations(m_mechanism, m_equations, state, m_outcome.summary.isKinematic);
        m_reactions.check(state);
        m_recorder.record(state, violation);
        keepWorst(m_outcome.summary.worstViolation, violation);
    }

    // Integrators hold errors to their tolerance; a larger one is a conflict or an axis that has flipped.
    void checkPositions(const State& state, const Violation& violation) const {
        constexpr Real Least = 1e-6, Margin = 1000;
        const Real tolerance = std::max(Least, Margin * m_options.getConstraintTolerance());
        if (m_dropped) m_dropped->check(state, tolerance);
        if (std::max(violation.length, violation.angle) > tolerance)
            throw std::runtime_error("a constraint is violated");
    }

    const Mechanism& m_mechanism;
    const SimulationOptions& m_options;
    std::optional<DroppedEquations> m_dropped;
    std::vector<ConstraintEquation> m_equations;  // in use
    SimulationOutcome m_outcome;
    Recorder m_recorder;
    EnergyWatch m_energy;
    ReactionWatch m_reactions;
    SensorWatch m_watch;
    std::unique_ptr<Stepper> m_stepper;
    int m_numSteps = 0;        // before the one that a sensor ended
    int m_numStepsBefore = 0;  // of steppers before this one
    const MechanismSensor* m_firing = nullptr;
};

}  // namespace

SimulationOutcome simulate(const Mechanism& mechanism, const AssembledState& initial,
                           const SimulationOptions& options, ResultSink& sink) {
    return Simulation(mechanism, options, sink).run(initial.state);
}

SimulationOutcome simulate(const Mechanism& mechanism, const AssembledState& initial,
                           const SimulationOptions& options) {
    Results results;
    ResultMemory memory(results);
    SimulationOutcome outcome = simulate(mechanism, initial, options, memory);
    outcome.results = std::move(results);
    return outcome;
}

}  // namespace jprim
