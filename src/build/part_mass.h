// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BUILD_PART_MASS_H_
#define JPRIM_SRC_BUILD_PART_MASS_H_

#include <array>
#include <optional>
#include <string>

#include "SimTKcommon.h"

namespace jprim {

/// Mass and inertia of a part as a dataset states them, in the mechanism's units.
struct PartMass {
    SimTK::Real mass = 0;
    SimTK::Transform X_BC;                    ///< CM marker in the body frame
    SimTK::Transform X_BI;                    ///< inertia marker in the body frame
    std::optional<std::array<double, 6>> ip;  ///< about the inertia marker's origin
};

/// The tensor of inertia about the mass centre in the body's axes. IP's products are positive integrals
/// +Int(xy dm), so they enter with a minus; I_c = I_i - m (c.c 1 - c ~c) with c from the inertia marker to
/// the mass centre.
SimTK::Mat33 calcCentralInertia(const PartMass& part);

/// Why no body can have this mass and this inertia about its mass centre, or empty. The message gives moments
/// in units of `unit`.
std::string findMassProblem(SimTK::Real mass, const SimTK::Mat33& inertia, SimTK::Real unit);

/// Mass and inertia that Simbody can solve with, and what had to be put in place of nothing.
struct SolvableMass {
    SimTK::Real mass = 0;
    SimTK::Mat33 inertia;
    bool massReplaced = false;
    bool inertiaReplaced = false;
};

/// A massless part becomes a light one, spread over its size; a part with mass but a moment below
/// MasslessFraction of its largest gets that. Anything else stays as it is.
SolvableMass makeSolvable(SimTK::Real mass, const SimTK::Mat33& inertia, SimTK::Real size,
                          SimTK::Real lightestMass);

}  // namespace jprim

#endif
