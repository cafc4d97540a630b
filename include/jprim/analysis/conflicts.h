// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_ANALYSIS_CONFLICTS_H_
#define JPRIM_ANALYSIS_CONFLICTS_H_

#include <string>
#include <vector>

#include "SimTKsimbody.h"
#include "jprim/analysis/constraint_equations.h"
#include "jprim/simbody_abi.h"

/// @file
/// Why a mechanism cannot be assembled.
namespace jprim {

/// Position equations that cannot be met together: for links too short to close a loop, those of all the
/// loop's joints. Each of them has a part in it; releasing any one lets the others be met, as far as the
/// neighbourhood tells.
struct Conflict {
    std::vector<int> equations;       ///< indices into ConflictReport::equations
    std::vector<SimTK::Real> errors;  ///< what is left of each [its own unit: length or rad]
};

/// How near the constraints can be met, starting from a State.
struct ConflictReport {
    std::vector<ConstraintEquation> equations;  ///< the holonomic ones in use
    std::vector<Conflict> conflicts;            ///< one for each group of elements that hang together
    SimTK::State state;                         ///< the best position found

    /// True if all position equations can be met after all.
    bool isAssembled() const { return conflicts.empty(); }
};

/// Goes downhill in the sum of squares of the scaled errors e of the position equations, to where no small
/// motion makes it less: G^T e = 0. There e, if it is not zero, is a state of self-stress: forces in
/// equilibrium that the equations in conflict exert on each other, and its nonzero entries say which they are.
/// Lengths are scaled by the mechanism's length, angles by 1 rad. A local search: from another State the
/// conflict may be another, or none. Requires Stage::Position.
/// @param names  what to call the constraints, see nameElements()
ConflictReport findConflicts(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state,
                             const ElementNames& names = {});

/// A primitive whose axes are to point the same way and are nearer to opposite.
struct FlippedAxes {
    std::string element;    ///< "JOINT/3 REVOLUTE"
    std::string axes;       ///< "z axes", or for ORIENTATION "axes"
    SimTK::Real angle = 0;  ///< from alike [rad], above pi/2
};

/// PARALLEL_AXES and ORIENTATION, also as parts of joints, that are turned by more than a right angle from
/// what they hold. Their errors grow up to half a turn, so assembly turns them back; but from near there it
/// may fail. Requires Stage::Position.
std::vector<FlippedAxes> findFlippedAxes(const SimTK::SimbodyMatterSubsystem& matter,
                                         const SimTK::State& state, const ElementNames& names = {});

}  // namespace jprim

#endif
