// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_INITIAL_VELOCITIES_H_
#define JPRIM_SRC_SIMULATION_INITIAL_VELOCITIES_H_

#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// The generalized speeds of least size among those that satisfy the constraints and come nearest to the
/// velocities given in the dataset. Requires Stage::Position.
SimTK::Vector calcInitialVelocities(const Mechanism& mechanism, const SimTK::State& state);

}  // namespace jprim

#endif
