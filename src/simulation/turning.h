// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_TURNING_H_
#define JPRIM_SRC_SIMULATION_TURNING_H_

#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// Of all parts. Requires Stage::Velocity.
SimTK::Real calcLargestAngularVelocity(const Mechanism& mechanism, const SimTK::State& state);

/// The time in which no part turns by more than a radian, at its present angular velocity w and acceleration a:
/// w t + a t^2/2 = 1. Joint coordinates may be exact in steps of whole turns, which would not be counted. Requires
/// Stage::Acceleration.
SimTK::Real calcTimeOfARadian(const Mechanism& mechanism, const SimTK::State& state);

}  // namespace jprim

#endif
