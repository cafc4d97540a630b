// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_PROJECTION_H_
#define JPRIM_SRC_SIMULATION_PROJECTION_H_

#include "SimTKsimbody.h"

namespace jprim {

/// Of positions that are kept; well below AssemblyTolerance.
constexpr SimTK::Real ProjectionTolerance = 1e-11;

/// Brings positions, then velocities of a State onto the constraints, by one step of Newton's method at least: a State
/// that is within the tolerance comes to rounding. Leaves it at Stage::Velocity.
/// @throws std::exception if the constraints are not met to within the tolerance
inline void projectAtLeastOnce(const SimTK::MultibodySystem& system, SimTK::State& state,
                               SimTK::Real tolerance) {
    SimTK::ProjectOptions options(tolerance);
    options.setOption(SimTK::ProjectOptions::ForceProjection);
    SimTK::ProjectResults results;
    SimTK::Vector noErrors;
    system.realize(state, SimTK::Stage::Position);
    system.projectQ(state, noErrors, options, results);
    system.realize(state, SimTK::Stage::Velocity);
    system.projectU(state, noErrors, options, results);
}

}  // namespace jprim

#endif
