// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_STEPPER_H_
#define JPRIM_SRC_SIMULATION_STEPPER_H_

#include <memory>
#include <string>

#include "jprim/mechanism/mechanism.h"
#include "jprim/simulation/simulate.h"

namespace jprim {

/// Moves a State on in time.
class Stepper {
public:
    virtual ~Stepper() = default;
    virtual const SimTK::State& getState() const = 0;
    /// One step, which does not go beyond `time`. The State may stay at a time that the next step changes.
    virtual void step(SimTK::Real time) = 0;
    virtual int getNumSteps() const = 0;
};

/// @throws Error if there is no such integrator
void checkIntegratorName(const std::string& name);

/// Integrates the equations of motion.
std::unique_ptr<Stepper> makeIntegration(const Mechanism& mechanism, const SimTK::State& initial,
                                         const SimulationOptions& options);

/// Follows a mechanism without freedoms, whose constraints give positions, velocities and accelerations at
/// any time: no equation is integrated.
std::unique_ptr<Stepper> makeKinematics(const Mechanism& mechanism, const SimTK::State& initial,
                                        const SimulationOptions& options);

/// Goes from equilibrium to equilibrium; the first is the one near the initial State.
/// @throws Error if there is none
std::unique_ptr<Stepper> makeStatics(const Mechanism& mechanism, const SimTK::State& initial);

}  // namespace jprim

#endif
