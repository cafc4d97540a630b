// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MARKER_ANGLES_H_
#define JPRIM_MARKER_ANGLES_H_

#include "SimTKcommon.h"
#include "jprim/simbody_abi.h"

namespace jprim {

/// Adams' body-fixed 3-1-3 angles (psi, theta, phi) [rad]: R = Rz(psi) Rx(theta) Rz(phi).
SimTK::Rotation makeRotation313(const SimTK::Vec3& angles);

/// The 3-1-3 angles of a rotation: psi = atan2(R13, -R23), theta = acos(R33), phi = atan2(R31, R32); where
/// theta is 0 or pi only psi +- phi is defined, and phi is 0.
SimTK::Vec3 calcAngles313(const SimTK::Rotation& R);

}  // namespace jprim

#endif
