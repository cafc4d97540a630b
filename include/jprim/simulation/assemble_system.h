// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SIMULATION_ASSEMBLE_SYSTEM_H_
#define JPRIM_SIMULATION_ASSEMBLE_SYSTEM_H_

#include <vector>

#include "jprim/analysis/constraint_equations.h"
#include "jprim/marker/marker.h"

/// @file
/// Assembly of any Simbody system.
namespace jprim {

/// A body that is to stay close to a pose: weight/2 (|p - p0|^2/size^2 + 4 sin^2(theta/2)), p its origin in Ground
/// and theta the angle by which it is turned away.
struct PoseGoal {
    SimTK::MobilizedBodyIndex body;
    SimTK::Transform X_GB;   ///< the pose in Ground
    SimTK::Real size = 1;    ///< the shift that counts as much as a turn of 1 rad [length units]
    SimTK::Real weight = 1;  ///< without unit
};

/// A marker whose origin r is to come close to a place r0: weight/2 |r - r0|^2.
struct MarkerGoal {
    Marker marker;           ///< on a body or a node of a flexible body
    SimTK::Vec3 place;       ///< in Ground [length units]
    SimTK::Real weight = 1;  ///< [1/length units^2]
};

/// What an assembly aims at where the constraints leave it a choice.
struct AssemblyGoals {
    std::vector<PoseGoal> poses;
    std::vector<MarkerGoal> markers;
    /// Weight of the goal that each body without a PoseGoal has: to stay where it is. 0.001 mm of a marker against
    /// 1 m of its body for the default.
    SimTK::Real staying = 1e-6;
    SimTK::Real size = 1;  ///< of the bodies of that goal, see PoseGoal
    /// Bodies whose mobilizer keeps its coordinates.
    std::vector<SimTK::MobilizedBodyIndex> locked;
};

/// Finds positions that satisfy all position constraints in use, near those of `state`, and of these the ones
/// where the goals' sum is least: a local minimum. Constraints may be redundant and more than the coordinates.
/// Speeds stay as they are.
///
/// @param state  realized to Stage::Instance at least; not changed
/// @param names  what to call the constraints in messages, see nameElements()
/// @returns the State found, realized to Stage::Position; all position errors are 1e-9 at most
/// @throws Error naming the constraint that is violated most, if they cannot be met
SimTK::State assemble(const SimTK::MultibodySystem& system, const SimTK::State& state,
                      const AssemblyGoals& goals = {}, const ElementNames& names = {});

}  // namespace jprim

#endif
