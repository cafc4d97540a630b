// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "jprim/analysis/constraint_report.h"
#include "jprim/base/error.h"
#include "simulation/recorder.h"

namespace jprim {

using SimTK::Integrator;
using SimTK::MultibodySystem;
using SimTK::Real;
using SimTK::Stage;
using SimTK::State;

namespace {

struct IntegratorEntry {
    const char* name;
    std::unique_ptr<Integrator> (*make)(const MultibodySystem&);
};

template <class Type>
std::unique_ptr<Integrator> makeIntegrator(const MultibodySystem& system) {
    return std::make_unique<Type>(system);
}

const IntegratorEntry Integrators[] = {
    {"RungeKuttaMerson", makeIntegrator<SimTK::RungeKuttaMersonIntegrator>},
    {"RungeKutta3", makeIntegrator<SimTK::RungeKutta3Integrator>},
    {"Verlet", makeIntegrator<SimTK::VerletIntegrator>},
    {"SemiExplicitEuler2", makeIntegrator<SimTK::SemiExplicitEuler2Integrator>},
    {"CPodes", makeIntegrator<SimTK::CPodesIntegrator>}};

std::unique_ptr<Integrator> makeIntegrator(const MultibodySystem& system, const SimulationOptions& options) {
    for (const IntegratorEntry& entry : Integrators) {
        if (options.integrator != entry.name) continue;
        std::unique_ptr<Integrator> integrator = entry.make(system);
        integrator->setAccuracy(options.accuracy);
        integrator->setConstraintTolerance(options.accuracy / 10);
        integrator->setAllowInterpolation(false);
        return integrator;
    }
    throw Error("integrator " + options.integrator,
                fmt::format("is not known; use one of {}", fmt::join(getIntegratorNames(), ", ")));
}

void checkOptions(const SimulationOptions& options) {
    if (!(options.end > 0) || !std::isfinite(options.end))
        throw Error("end", fmt::format("{} is not a positive time", options.end));
    if (options.steps < 1) throw Error("steps", fmt::format("{} is not a positive number", options.steps));
    if (!(options.accuracy > 0 && options.accuracy < 1))
        throw Error("accuracy", fmt::format("{} is not between 0 and 1", options.accuracy));
}

/// Watches what the summary is about.
class Monitor {
public:
    Monitor(const Mechanism& mechanism, SimulationSummary& summary)
        : m_mechanism(mechanism), m_summary(summary) {}

    void observe(const State& state) {
        const Violation now = calcViolation(m_mechanism, state);
        Violation& worst = m_summary.worstViolation;
        if (std::max(now.length, now.angle) > std::max(worst.length, worst.angle))
            worst.element = now.element;
        worst.length = std::max(worst.length, now.length);
        worst.angle = std::max(worst.angle, now.angle);

        const Real kinetic = m_mechanism.calcKineticEnergy(state);
        const Real energy = kinetic + m_mechanism.getSystem().calcPotentialEnergy(state);
        if (m_first) {
            m_summary.energyAtStart = energy;
            m_least = m_most = kinetic;
            m_smallestScale = calcSmallestScale(state);
        }
        m_first = false;
        m_least = std::min(m_least, kinetic);
        m_most = std::max(m_most, kinetic);
        m_summary.energyScale = std::max(m_most - m_least, m_smallestScale);
        m_summary.energyAtEnd = energy;
        m_summary.largestEnergyChange =
            std::max(m_summary.largestEnergyChange, std::abs(energy - m_summary.energyAtStart));
    }

private:
    Real calcSmallestScale(const State& state) const {
        constexpr Real HardlyMoving = 1e-9;
        Real work = 0;
        for (const MechanismPart& part : m_mechanism.getParts())
            if (!part.ground)
                work += part.body.getBodyMass(state) * part.size * m_mechanism.getGravity().norm();
        return HardlyMoving * work;
    }

    const Mechanism& m_mechanism;
    SimulationSummary& m_summary;
    bool m_first = true;
    Real m_least = 0, m_most = 0, m_smallestScale = 0;
};

// Simbody solves for the multipliers by least squares and leaves out what it takes for dependent. Redundant
// equations are met all the same; where masses differ too much, equations of the heavy ones are lost.
void checkAccelerations(const Mechanism& mechanism, const State& state) {
    constexpr Real Lost = 1e-4;
    // What is there to be lost: accelerations, gravity, and the centripetal ones of a steady turn.
    const auto findLargest = [](const SimTK::Vector& v) { return v.size() > 0 ? v.normInf() : 0; };
    const Real accelerations = findLargest(state.getUDot()) + mechanism.getGravity().norm() +
                               SimTK::square(findLargest(state.getU()));
    if (!std::isfinite(accelerations)) throw std::runtime_error("accelerations are not finite");
    const SimTK::Vector& errors = state.getUDotErr();
    if (findLargest(errors) <= Lost * accelerations) return;
    int first = 0;
    while (std::abs(errors[first]) <= Lost * accelerations) ++first;
    throw std::runtime_error(
        fmt::format("the accelerations violate {}: it conflicts with other constraints, or masses and "
                    "inertias are too different to solve for",
                    mechanism.findEquations(state).at(size_t(first)).element));
}

void stepTo(Integrator& integrator, Real time) {
    while (integrator.getTime() < time) {
        const Integrator::SuccessfulStepStatus status = integrator.stepTo(time, time);
        if (status == Integrator::EndOfSimulation) return;
    }
}

// Simbody's messages run over several lines.
std::string joinLines(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

std::string describeFailure(const Mechanism& mechanism, const State& state, const std::string& reason) {
    const double time = state.getTime() / mechanism.getUnits().time;
    std::string element;
    if (state.getSystemStage() >= Stage::Position) element = calcViolation(mechanism, state).element;
    return fmt::format("at time {:.6g}: the simulation cannot go on{}: {}", time,
                       element.empty() ? "" : fmt::format("; the largest constraint error is at {}", element),
                       joinLines(reason));
}

}  // namespace

std::vector<std::string> getIntegratorNames() {
    std::vector<std::string> names;
    for (const IntegratorEntry& entry : Integrators) names.push_back(entry.name);
    return names;
}

SimulationOutcome simulate(const Mechanism& mechanism, const AssembledState& initial,
                           const SimulationOptions& options) {
    checkOptions(options);
    const MultibodySystem& system = mechanism.getSystem();
    const std::unique_ptr<Integrator> integrator = makeIntegrator(system, options);
    const auto started = std::chrono::steady_clock::now();

    SimulationOutcome outcome;
    const ConstraintReport report = analyzeConstraints(mechanism.getMatter(), initial.state);
    outcome.summary.degreesOfFreedom = report.getDegreesOfFreedom();
    outcome.summary.redundantEquations = report.getNumRedundant();
    Recorder recorder(mechanism);
    Monitor monitor(mechanism, outcome.summary);
    try {
        integrator->initialize(initial.state);
        for (int k = 0; k <= options.steps; ++k) {
            stepTo(*integrator, options.end * k / options.steps * mechanism.getUnits().time);
            const State& state = integrator->getState();
            system.realize(state, Stage::Acceleration);
            checkAccelerations(mechanism, state);
            recorder.record(state);
            monitor.observe(state);
            if (options.reportProgress) options.reportProgress(double(k) / options.steps);
        }
    } catch (const std::exception& exception) {
        outcome.failure = describeFailure(mechanism, integrator->getState(), exception.what());
    }
    outcome.results = std::move(recorder.updResults());
    outcome.summary.stepsTaken = integrator->getNumStepsTaken();
    outcome.summary.wallSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return outcome;
}

}  // namespace jprim
