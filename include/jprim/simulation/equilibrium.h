// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SIMULATION_EQUILIBRIUM_H_
#define JPRIM_SIMULATION_EQUILIBRIUM_H_

#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// Finds a stable equilibrium near a State, at its time: nothing moves or is accelerated, and a
/// small push brings nothing out of place for good.
///
/// The mechanism is let down as if it moved through syrup, in steps that become those of Newton's method as
/// the forces come into balance. Any forces will do, also those without a potential; damping has none. Time
/// stands still: a MOTION keeps its present position.
///
/// @returns the State at rest, realized to Stage::Acceleration
/// @throws Error if there is none within reach, naming the part that moves most
SimTK::State findEquilibrium(const Mechanism& mechanism, const SimTK::State& start);

/// Accelerations below this fraction of those at the start count as none.
constexpr double EquilibriumTolerance = 1e-9;

}  // namespace jprim

#endif
