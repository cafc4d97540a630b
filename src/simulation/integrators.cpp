// SPDX-License-Identifier: Apache-2.0
#include "simulation/integrators.h"

#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"
#include "simulation/projection.h"
#include "simulation/stepper.h"

namespace jprim {

using SimTK::Integrator;
using SimTK::MultibodySystem;
using SimTK::Real;

namespace {

template <class Type>
std::unique_ptr<Integrator> make(const MultibodySystem& system) {
    return std::make_unique<Type>(system);
}

const IntegratorEntry Integrators[] = {
    {"RungeKuttaMerson", make<SimTK::RungeKuttaMersonIntegrator>, true},
    {"RungeKutta3", make<SimTK::RungeKutta3Integrator>, true},
    {"Verlet", make<SimTK::VerletIntegrator>},
    {"SemiExplicitEuler2", make<SimTK::SemiExplicitEuler2Integrator>, false, false, true},
    {"CPodes", make<SimTK::CPodesIntegrator>, false, true}};

}  // namespace

const IntegratorEntry& findIntegrator(const std::string& name) {
    for (const IntegratorEntry& entry : Integrators)
        if (name == entry.name) return entry;
    throw Error("integrator " + name,
                fmt::format("is not known; use one of {}", join(getIntegratorNames(), ", ")));
}

std::unique_ptr<Integrator> makeIntegrator(const Mechanism& mechanism, const SimulationOptions& options,
                                           const IntegratorEntry& entry, Real unit) {
    std::unique_ptr<Integrator> integrator = entry.make(mechanism.getSystem());
    integrator->setAccuracy(unit * options.accuracy);
    integrator->setConstraintTolerance(options.getConstraintTolerance());
    if (std::isfinite(options.maximumStep))
        integrator->setMaximumStepSize(options.maximumStep * mechanism.getUnits().time);
    integrator->setProjectEveryStep(entry.remembersSteps);
    integrator->setAllowInterpolation(false);
    integrator->setReturnEveryInternalStep(true);
    return integrator;
}

void advance(Integrator& integrator, Real end) {
    auto status = integrator.stepTo(end, end);
    if (status == Integrator::StartOfContinuousInterval) status = integrator.stepTo(end, end);
    if (status == Integrator::EndOfSimulation) throw Error("integrator", "ended before its time");
}

void project(const Mechanism& mechanism, const SimulationOptions& options, Integrator& integrator) {
    if (integrator.getState().getNMultipliers() == 0) return;
    SimTK::State& state = integrator.updAdvancedState();
    state.updUWeights() = 1;
    projectAtLeastOnce(mechanism.getSystem(), state, options.getConstraintTolerance());
    integrator.reinitialize(SimTK::Stage::Position, false);
}

std::vector<std::string> getIntegratorNames() {
    std::vector<std::string> names;
    for (const IntegratorEntry& entry : Integrators) names.push_back(entry.name);
    return names;
}

void checkIntegratorName(const std::string& name) {
    findIntegrator(name);
}

}  // namespace jprim
