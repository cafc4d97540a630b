// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_RANDOM_PART_H_
#define JPRIM_TESTS_SUPPORT_RANDOM_PART_H_

#include <cmath>
#include <random>

#include "SimTKcommon.h"

namespace jprim::testing {

/// Draws what makes up a part; the same for the same seed.
class RandomPart {
    using Real = SimTK::Real;
    using Vec3 = SimTK::Vec3;

public:
    explicit RandomPart(unsigned seed) : m_random(seed) {}

    Real draw(Real from, Real to) { return std::uniform_real_distribution<Real>(from, to)(m_random); }
    Real drawOverDecades(Real from, Real to) { return std::pow(10, draw(std::log10(from), std::log10(to))); }
    Vec3 drawVec3() { return {draw(-1, 1), draw(-1, 1), draw(-1, 1)}; }
    SimTK::Rotation drawRotation() { return SimTK::Rotation(draw(-3, 3), drawVec3()); }
    SimTK::Transform drawTransform() { return SimTK::Transform(drawRotation(), drawVec3()); }
    /// Principal moments that are positive, but seldom those of a body.
    Vec3 drawMoments() {
        return {drawOverDecades(0.01, 10), drawOverDecades(0.01, 10), drawOverDecades(0.01, 10)};
    }

private:
    std::mt19937 m_random;
};

/// The tensor of inertia in axes B with the principal axes C.
inline SimTK::Mat33 makeInertia(const SimTK::Vec3& moments, const SimTK::Rotation& R_BC) {
    const SimTK::Mat33 R(R_BC);
    return R * SimTK::Mat33(moments[0], 0, 0, 0, moments[1], 0, 0, 0, moments[2]) * ~R;
}

}  // namespace jprim::testing

#endif
