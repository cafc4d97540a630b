// SPDX-License-Identifier: Apache-2.0
#include "mechanism/negative_masses.h"

#include <algorithm>
#include <cmath>

#include "mechanism/part_mass.h"

namespace jprim {

using SimTK::Body;
using SimTK::MassProperties;
using SimTK::Mat33;
using SimTK::MobilizedBody;
using SimTK::Real;
using SimTK::Transform;
using SimTK::Vec3;

Real findMissingInertia(const Mat33& inertia) {
    constexpr Real Margin =
        1. / 16;  // of the largest moment, so that rounding cannot break what has been mended
    const Vec3 moments = calcPrincipalMoments(inertia);
    const Real missing = std::max(calcTriangleExcess(moments), -moments[0]);
    return missing > 0 ? missing + Margin * std::max(moments[2], -moments[0]) : 0;
}

NegativeMasses makeNegativeMasses(Real mass, Real added) {
    if (added == 0) return {};
    const Real each = 0x1p-20 * mass;
    return {added, each, std::sqrt(added / (8 * each))};
}

MassProperties makeMassProperties(Real mass, const Mat33& inertia, const NegativeMasses& negative) {
    const Mat33 I = inertia + Mat33(negative.added);
    MassProperties properties(mass + 4 * negative.each, Vec3(0),
                              SimTK::Inertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)));
    // Simbody checks where it makes nodes of bodies and turns them; here there is a statement to name.
    properties.calcCentralInertia();
    properties.getUnitInertia().reexpress(SimTK::Rotation(1, Vec3(1, 2, 3)));
    return properties;
}

void weldNegativeMasses(MobilizedBody& body, const NegativeMasses& negative) {
    if (negative.added == 0) return;
    const Body::Rigid point(MassProperties(-negative.each, Vec3(0), SimTK::UnitInertia(0)));
    for (const Vec3& corner : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)})
        MobilizedBody::Weld(body, Transform(negative.coordinate * corner), point, Transform());
}

}  // namespace jprim
