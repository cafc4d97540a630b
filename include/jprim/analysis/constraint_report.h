// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_ANALYSIS_CONSTRAINT_REPORT_H_
#define JPRIM_ANALYSIS_CONSTRAINT_REPORT_H_

#include <vector>

#include "SimTKsimbody.h"
#include "jprim/analysis/constraint_equations.h"
#include "jprim/simbody_abi.h"

/// @file
/// How much the constraints of a system leave free, which of them say nothing new, and whether that is due to
/// the position. Questions to any Simbody system; nothing is changed or removed.
///
/// Freedoms are counted by the rank of G, the Jacobian of all equations in use with respect to the speeds u:
/// position, speed and acceleration equations alike. G is first scaled by the mechanism's length, and each column by
/// what its speed does to the bodies that the equations hold, before these powers are added up: that takes out all
/// units, and equations that a tree of joints leaves nothing to do are as small as they are. Among the singular values
/// of the result, the rank is where the ratio of one to the next is largest, with 1 above the first; there is no
/// tolerance to choose. (Values above 10^-4 always count, those below 10^-14 are zero, and one that stands alone counts
/// above 10^-7.) Mobilities with prescribed motion count as free.
///
/// A State that satisfies its position equations to within 10^-3, but not to rounding, is first brought there
/// (a copy of it), so that a loose assembly does not make dependent equations look independent.
///
/// Where the numbers of a model are rounded, equations that were meant to say the same contradict each other. If no more
/// than 10^-4 is left of them where they are met best [rad, or sizes of the mechanism], singular values up to a thousand
/// times that, and 10^-3, count as zero.
namespace jprim {

/// Freedoms at one State.
struct ConstraintCount {
    int numMobilities = 0;  ///< generalized speeds
    int numEquations = 0;   ///< in use
    int rank = 0;           ///< independent ones among them

    /// The singular values on both sides of the decision: of those that count the smallest, of those that do
    /// not the largest. A wide gap is a sure decision; 0 if there are none.
    SimTK::Real smallestKept = 0;
    SimTK::Real largestDropped = 0;

    /// There are holonomic equations, and no motion changes any of them here. Solvers for corrections of positions then
    /// have nothing to solve for.
    bool hasOnlyEmptyHolonomic = false;

    /// Grübler's count: what would be free if all equations were independent. May be negative.
    int getGrueblerCount() const { return numMobilities - numEquations; }
    int getDegreesOfFreedom() const { return numMobilities - rank; }
    int getNumRedundant() const { return numEquations - rank; }
};

/// An equation that follows from others.
struct RedundantEquation {
    int equation = 0;            ///< index into ConstraintReport::equations
    std::vector<int> dependsOn;  ///< the equations it follows from; without any one of them it does not
    bool onlyHere = false;       ///< independent in the positions nearby
};

/// The diagnosis of a State.
struct ConstraintReport : ConstraintCount {
    /// All equations in use, in the order of the elements.
    std::vector<ConstraintEquation> equations;

    /// The dependent ones; of equations that say the same the later are named. Those that depend everywhere
    /// come first, then those that are onlyHere.
    std::vector<RedundantEquation> redundant;

    /// Degrees of freedom of nearly all admissible positions close by; equal to getDegreesOfFreedom() unless
    /// the position is singular. Lower where directions in which the mechanism seems free lead nowhere, as in
    /// a straightened pair of links between fixed ends.
    int freedomsNearby = 0;

    /// True if equations depend on each other here that do not nearby: a dead centre or a branching, where
    /// the motion is not determined. Redundancy proper stays wherever the mechanism moves.
    bool isSingularPosition() const { return freedomsNearby != getDegreesOfFreedom(); }
};

/// Counts and no more: what a simulation asks at its start. Requires Stage::Position.
ConstraintCount countFreedoms(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state);

/// The full diagnosis. Besides the State itself it looks at positions nearby, some hundredths of the
/// mechanism's size away along a free direction and back on the constraints. Which direction is chosen at
/// random, but the same for each call. Cost is cubic in the number of equations that hang together: well under
/// a second for 500. Requires Stage::Position.
/// @param names  what to call the constraints, see nameElements()
ConstraintReport analyzeConstraints(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state,
                                    const ElementNames& names = {});

}  // namespace jprim

#endif
