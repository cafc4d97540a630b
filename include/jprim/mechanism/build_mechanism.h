// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MECHANISM_BUILD_MECHANISM_H_
#define JPRIM_MECHANISM_BUILD_MECHANISM_H_

#include <optional>

#include "jprim/base/diagnostic.h"
#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// How a dataset's joints are solved. Motion and reactions are the same but for rounding.
enum class Formulation {
    Tree,  ///< by joint coordinates on a spanning tree; equations where loops close or no mobilizer fits
    Constraints  ///< all parts free, all joints equations, which can be switched off and on
};

struct BuildOptions {
    Formulation formulation = Formulation::Tree;
};

/// Makes a Simbody system of a dataset. Parts hang on each other by mobilizers that stand for their JOINTs and
/// JPRIMs; where a loop closes or no mobilizer fits, and in Formulation::Constraints everywhere, a JPRIM or
/// JOINT is a constraint. A loop that the tree keeps in a plane is closed without redundant equations: all
/// loads across the plane go through the tree. Everything is converted to the mechanism's units on the way.
///
/// Simbody cannot solve for a body without inertia. A part without mass gets MasslessFraction of the lightest
/// part's mass, spread over the part's size; a part with mass but a vanishing moment of inertia
/// MasslessFraction of its largest, or if all vanish of mass times size squared; each with a warning. Motion
/// and reactions of ordinary mechanisms change by about that fraction.
///
/// A part may have principal moments of inertia I1, I2, I3 that no body has, with I3 > I1 + I2: the motion is what
/// they say, with a warning. Its Simbody body then has c more in every moment and a little more mass, and four bodies
/// of negative mass welded to it take both away: momentum and energy are right, but Simbody's functions that add up the
/// inertia of several bodies (calcSystemMassPropertiesInGround()) refuse them. A negative moment is accepted with a
/// warning where every motion that the constraints allow has kinetic energy all the same.
///
/// Errors, at the statement: a marker's or part's axes that its points do not define; a MASS or IP that is no number
/// to calculate with, or a negative moment where it matters; I and J axes of a PARALLEL_AXES, ORIENTATION, REVOLUTE,
/// CYLINDRICAL, TRANSLATIONAL, PLANAR or FIXED more than 90 degrees apart; bars of a PERPENDICULAR, UNIVERSAL or HOOKE
/// that are parallel; a MODES_FILE that cannot be read, a NODE_ID that is not in it.
///
/// @param      dataset      as read without errors
/// @param[out] diagnostics  findings are appended in the order of the file, mistakes of all kinds together
/// @param      options      how to build it
/// @returns the mechanism, or nothing if an error was found
std::optional<Mechanism> buildMechanism(const Dataset& dataset, Diagnostics& diagnostics,
                                        const BuildOptions& options = {});

/// See buildMechanism().
constexpr double MasslessFraction = 1e-7;

}  // namespace jprim

#endif
