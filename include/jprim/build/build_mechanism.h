// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_BUILD_BUILD_MECHANISM_H_
#define JPRIM_BUILD_BUILD_MECHANISM_H_

#include <optional>

#include "jprim/base/diagnostic.h"
#include "jprim/build/mechanism.h"

namespace jprim {

/// Makes a Simbody system of a dataset: every part a free body, rigid or flexible, every JPRIM and JOINT a set
/// of primitives.
/// Everything is converted to the mechanism's units on the way.
///
/// Simbody cannot solve for a body without inertia. A part without mass gets MasslessFraction of the lightest
/// part's mass, spread over the part's size; a part with mass but a vanishing moment of inertia
/// MasslessFraction of its largest, or if all vanish of mass times size squared; each with a warning. Motion
/// and reactions of ordinary mechanisms change by about that fraction.
///
/// Errors, at the statement: a marker's or part's axes that its points do not define; a MASS or IP that no
/// body can have; I and J axes of a PARALLEL_AXES, ORIENTATION, REVOLUTE, CYLINDRICAL, TRANSLATIONAL, PLANAR
/// or FIXED more than 90 degrees apart; bars of a PERPENDICULAR, UNIVERSAL or HOOKE that are parallel; a
/// MODES_FILE that cannot be read, a NODE_ID that is not in it.
///
/// @param      dataset      as read without errors
/// @param[out] diagnostics  findings are appended
/// @returns the mechanism, or nothing if an error was found
std::optional<Mechanism> buildMechanism(const Dataset& dataset, Diagnostics& diagnostics);

/// See buildMechanism().
constexpr double MasslessFraction = 1e-7;

}  // namespace jprim

#endif
