// SPDX-License-Identifier: Apache-2.0
#include "jprim/marker/angles.h"

#include <gtest/gtest.h>

namespace jprim {
namespace {

using SimTK::Pi;
using SimTK::Rotation;
using SimTK::Vec3;

constexpr double Rounding = 1e-14;

// R = Rz(90) Rx(90): x = (0,1,0), y = (0,0,1), z = (1,0,0).
TEST(Angles313, AreBodyFixedAboutZXZ) {
    const Rotation R = makeRotation313(Vec3(Pi / 2, Pi / 2, 0));
    EXPECT_LT((Vec3(R.x()) - Vec3(0, 1, 0)).norm(), Rounding);
    EXPECT_LT((Vec3(R.y()) - Vec3(0, 0, 1)).norm(), Rounding);
    EXPECT_LT((Vec3(R.z()) - Vec3(1, 0, 0)).norm(), Rounding);
}

TEST(Angles313, AreRecovered) {
    const Vec3 angles(-2.1, 0.7, 2.9);
    EXPECT_LT((calcAngles313(makeRotation313(angles)) - angles).norm(), 1e-13);
}

// Only the sum or difference of the outer angles is defined there; it goes into the first.
TEST(Angles313, AtTheSingularPositions) {
    EXPECT_LT((calcAngles313(Rotation(0.8, SimTK::ZAxis)) - Vec3(0.8, 0, 0)).norm(), Rounding);
    const Rotation turned = makeRotation313(Vec3(0.5, Pi, 0.2));
    EXPECT_LT((makeRotation313(calcAngles313(turned)).asMat33() - turned.asMat33()).norm(), 1e-13);
}

}  // namespace
}  // namespace jprim
