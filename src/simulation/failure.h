// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_FAILURE_H_
#define JPRIM_SRC_SIMULATION_FAILURE_H_

#include <string>

#include "jprim/build/mechanism.h"

namespace jprim {

/// Simbody solves for the multipliers by least squares and leaves out what it takes for dependent. Redundant
/// equations are met all the same; where masses differ too much, equations of the heavy ones are lost.
/// Requires Stage::Acceleration.
/// @throws std::runtime_error naming the element whose equation the accelerations violate
void checkAccelerations(const Mechanism& mechanism, const SimTK::State& state);

/// Why a simulation ended at a State: the time, the equation with the largest error, a singular position if it
/// is one, and the reason.
std::string describeFailure(const Mechanism& mechanism, const SimTK::State& state, const std::string& reason);

}  // namespace jprim

#endif
