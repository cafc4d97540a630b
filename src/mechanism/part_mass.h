// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_PART_MASS_H_
#define JPRIM_SRC_MECHANISM_PART_MASS_H_

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

/// The principal moments of a tensor of inertia in ascending order.
SimTK::Vec3 calcPrincipalMoments(const SimTK::Mat33& inertia);

/// By how much the largest of three ascending principal moments exceeds the sum of the others. Of no body it is
/// positive; differences that are rounding errors are taken for zero.
SimTK::Real calcTriangleExcess(const SimTK::Vec3& moments);

/// True if the smallest of three ascending principal moments is negative by more than the digits of a dataset explain.
bool hasNegativeMoment(const SimTK::Vec3& moments);

/// Why this mass and this inertia about the mass centre are no numbers to calculate with, or empty.
std::string findMassProblem(SimTK::Real mass, const SimTK::Mat33& inertia);

/// Mass and inertia that can be solved with, and what had to be put in place of nothing.
struct SolvableMass {
    SimTK::Real mass = 0;
    SimTK::Mat33 inertia;
    bool massReplaced = false;
    bool inertiaReplaced = false;
};

/// A massless part becomes a light one, spread over its size; of a part with mass a principal moment that vanishes
/// beside the largest becomes MasslessFraction of that. Anything else stays as it is, negative moments too.
SolvableMass makeSolvable(SimTK::Real mass, const SimTK::Mat33& inertia, SimTK::Real size,
                          SimTK::Real lightestMass);

}  // namespace jprim

#endif
