// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "jprim/base/error.h"
#include "simulation/stepper.h"

namespace jprim {

using SimTK::Integrator;
using SimTK::MultibodySystem;
using SimTK::Real;
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

const IntegratorEntry& findEntry(const std::string& name) {
    for (const IntegratorEntry& entry : Integrators)
        if (name == entry.name) return entry;
    throw Error("integrator " + name,
                fmt::format("is not known; use one of {}", fmt::join(getIntegratorNames(), ", ")));
}

class Integration : public Stepper {
public:
    Integration(const Mechanism& mechanism, std::unique_ptr<Integrator> integrator, const State& initial)
        : m_mechanism(mechanism), m_integrator(std::move(integrator)) {
        m_integrator->initialize(initial);
    }

    const State& getState() const override { return m_integrator->getState(); }
    int getNumSteps() const override { return m_integrator->getNumStepsTaken(); }
    void step(Real time) override {
        m_mechanism.getSystem().realize(getState(), SimTK::Stage::Acceleration);
        const Real end = std::min(time, getState().getTime() + calcTimeOfARadian(m_mechanism, getState()));
        if (m_integrator->stepTo(end, end) == Integrator::EndOfSimulation)
            throw Error("integrator", "ended before its time");
    }

private:
    const Mechanism& m_mechanism;
    std::unique_ptr<Integrator> m_integrator;
};

}  // namespace

Real calcTimeOfARadian(const Mechanism& mechanism, const State& state) {
    Real w = 0, a = 0;
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        w = std::max(w, part.body.getBodyAngularVelocity(state).norm());
        a = std::max(a, part.body.getBodyAngularAcceleration(state).norm());
    }
    const Real rate = w + std::sqrt(w * w + 2 * a);
    return rate > 0 ? 2 / rate : SimTK::Infinity;
}

std::vector<std::string> getIntegratorNames() {
    std::vector<std::string> names;
    for (const IntegratorEntry& entry : Integrators) names.push_back(entry.name);
    return names;
}

void checkIntegratorName(const std::string& name) {
    findEntry(name);
}

std::unique_ptr<Stepper> makeIntegration(const Mechanism& mechanism, const State& initial,
                                         const SimulationOptions& options) {
    const IntegratorEntry& entry = findEntry(options.integrator);
    std::unique_ptr<Integrator> integrator = entry.make(mechanism.getSystem());
    integrator->setAccuracy(options.accuracy);
    integrator->setConstraintTolerance(options.getConstraintTolerance());
    // Near a singular position an error of velocities, divided by the distance, is one of accelerations.
    integrator->setProjectEveryStep(true);
    if (std::isfinite(options.maximumStep))
        integrator->setMaximumStepSize(options.maximumStep * mechanism.getUnits().time);
    integrator->setAllowInterpolation(false);
    integrator->setReturnEveryInternalStep(true);
    return std::make_unique<Integration>(mechanism, std::move(integrator), initial);
}

}  // namespace jprim
