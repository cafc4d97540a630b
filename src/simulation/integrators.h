// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_INTEGRATORS_H_
#define JPRIM_SRC_SIMULATION_INTEGRATORS_H_

#include <memory>
#include <string>

#include "jprim/mechanism/mechanism.h"
#include "jprim/simulation/simulate.h"

namespace jprim {

/// One of Simbody's integrators, and what is to be known of it.
struct IntegratorEntry {
    const char* name;
    std::unique_ptr<SimTK::Integrator> (*make)(const SimTK::MultibodySystem&);
    bool isRungeKutta = false;    ///< one that integrates all variables alike
    bool remembersSteps = false;  ///< a multistep method, which begins anew if a state is changed
    bool isBlindAtEnd = false;    ///< it does not ask what forces are at the end of a step
};

/// @throws Error if there is none
const IntegratorEntry& findIntegrator(const std::string& name);

/// @param unit  of the accuracy
std::unique_ptr<SimTK::Integrator> makeIntegrator(const Mechanism& mechanism,
                                                  const SimulationOptions& options,
                                                  const IntegratorEntry& entry, SimTK::Real unit = 1);

/// One step that does not go beyond `end`.
void advance(SimTK::Integrator& integrator, SimTK::Real end);

/// Near a singular position an error of velocities, divided by the distance, is one of accelerations. Integrators can be
/// told to project every step, but then they project their estimates of errors as well, and in trees of few freedoms take
/// steps that are too long.
void project(const Mechanism& mechanism, const SimulationOptions& options, SimTK::Integrator& integrator);

}  // namespace jprim

#endif
