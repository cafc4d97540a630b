// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_NEGATIVE_MASSES_H_
#define JPRIM_SRC_MECHANISM_NEGATIVE_MASSES_H_

#include "SimTKsimbody.h"

namespace jprim {

/// Inertia that no body has, exactly, of bodies that Simbody accepts. It checks, whenever it looks at a body's inertia
/// in other axes, that no principal moment is negative or larger than the sum of the other two; adding c to all three
/// moments mends both. Four point masses of -m then take it away, welded to the body at the corners of a regular
/// tetrahedron around its mass centre:
///
///     p_k = a (1, 1, 1), a (1, -1, -1), a (-1, 1, -1), a (-1, -1, 1),   sum p_k = 0,
///     -m sum (p_k.p_k 1 - p_k ~p_k) = -8 m a^2 1 = -c 1
///
/// and the body weighs 4 m more. Neither mass, momentum, energy nor coordinates and equations know of it, and no
/// reaction between parts. m is small, so that next to nothing of the mass is a difference.
struct NegativeMasses {
    SimTK::Real added = 0;       ///< c, to every moment of inertia
    SimTK::Real each = 0;        ///< m
    SimTK::Real coordinate = 0;  ///< a
};

/// What makes `inertia`, about the mass centre, one that Simbody accepts; c is 0 if it does as it is.
SimTK::Real findMissingInertia(const SimTK::Mat33& inertia);
/// @param added  c, not negative
NegativeMasses makeNegativeMasses(SimTK::Real mass, SimTK::Real added);

/// What the body itself gets, with its origin at the mass centre. @throws SimTK::Exception if Simbody would not
/// accept it in some orientation
SimTK::MassProperties makeMassProperties(SimTK::Real mass, const SimTK::Mat33& inertia,
                                         const NegativeMasses& negative);
/// The rest: nothing if c is 0.
void weldNegativeMasses(SimTK::MobilizedBody& body, const NegativeMasses& negative);

}  // namespace jprim

#endif
