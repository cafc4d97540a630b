// SPDX-License-Identifier: Apache-2.0
#include "jprim/marker/angles.h"

#include <cmath>

namespace jprim {

using SimTK::Real;
using SimTK::Rotation;
using SimTK::Vec3;

Rotation makeRotation313(const Vec3& angles) {
    return Rotation(SimTK::BodyRotationSequence, angles[0], SimTK::ZAxis, angles[1], SimTK::XAxis, angles[2],
                    SimTK::ZAxis);
}

Vec3 calcAngles313(const Rotation& R) {
    const Real sine = std::hypot(R[0][2], R[1][2]);
    const Real theta = std::atan2(sine, R[2][2]);
    if (sine < SimTK::SignificantReal) return {std::atan2(R[1][0], R[0][0]), theta, 0};
    return {std::atan2(R[0][2], -R[1][2]), theta, std::atan2(R[2][0], R[2][1])};
}

}  // namespace jprim
