// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_FIND_POSITIONS_H_
#define JPRIM_SRC_SIMULATION_FIND_POSITIONS_H_

#include <vector>

#include "jprim/simulation/assemble.h"

namespace jprim {

/// What an assembly aims at: poses of the parts' bodies, in their order, and whether what the dataset holds is held.
struct AssemblyAim {
    std::vector<SimTK::Transform> poses;  ///< X_GB
    bool holdGiven = true;
    SimTK::Real tolerance = AssemblyTolerance;
};

/// What was given and is not met.
struct FoundPositions {
    std::vector<MissedCoordinate> yielded;    ///< EXACT coordinates
    std::vector<ConstraintEquation> leftOut;  ///< see AssembledState
};

/// Finds positions that satisfy the constraints and what is given, closest to the poses aimed at. Modes stay as they
/// are if that can be met.
/// @param state  where to begin, and the result
/// @throws AssemblyError with what is missed
FoundPositions findPositions(const Mechanism& mechanism, const AssemblyAim& aim, SimTK::State& state);

}  // namespace jprim

#endif
