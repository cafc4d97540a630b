// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_FAILURE_H_
#define JPRIM_SRC_SIMULATION_FAILURE_H_

#include <exception>
#include <string>

#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// Simbody solves for the multipliers by least squares and leaves out what it takes for dependent. Redundant
/// equations are met all the same; where masses differ too much, equations of the heavy ones are lost, and next to a
/// singular position those that nearly depend on others.
/// Requires Stage::Acceleration.
/// @param equations  those in use
/// @throws std::runtime_error naming the element whose equation the accelerations violate
void checkAccelerations(const Mechanism& mechanism, const std::vector<ConstraintEquation>& equations,
                        const SimTK::State& state, bool isKinematic);

/// True if equations nearly depend on each other. Levers of unequal length give values that are not much larger: good
/// to explain what has gone wrong, not to predict it. Requires Stage::Position.
bool isNearSingular(const Mechanism& mechanism, const SimTK::State& state);

constexpr const char* NoStepIsShortEnough =
    "the integrator does not meet its accuracy however short its steps are";

/// True of what is thrown where an integrator does not meet its accuracy however short its steps are, or constraints
/// are not met to their tolerance.
bool isStuck(const std::exception& exception);

/// Why a simulation ended at a State: the time, the equation with the largest error, a singular position if it
/// is one, and the reason; or the element that is the reason, if one is known to be.
std::string describeFailure(const Mechanism& mechanism, const SimTK::State& state,
                            const std::exception& exception);

}  // namespace jprim

#endif
