// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_BASE_KINEMATIC_LEVEL_H_
#define JPRIM_BASE_KINEMATIC_LEVEL_H_

namespace jprim {

/// Coordinates, their first or their second derivatives: the highest that a value depends on, those that an equation is
/// written for, or what a function prescribes.
enum class KinematicLevel { Position, Velocity, Acceleration };

}  // namespace jprim

#endif
