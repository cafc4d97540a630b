// SPDX-License-Identifier: Apache-2.0
#include "mechanism/frames.h"

#include <gtest/gtest.h>

#include "jprim/marker/angles.h"

namespace jprim {
namespace {

using SimTK::Transform;
using SimTK::Vec3;

constexpr double Rounding = 1e-14;

Transform makeOrFail(const FrameStatement& statement, double length = 1) {
    std::string problem;
    const Transform X = makeFrame(statement, length, problem);
    EXPECT_EQ(problem, "");
    return X;
}

TEST(Frame, OriginIsConvertedAnglesAreNot) {
    const Transform X = makeOrFail({Triple{10, -20, 30}, Triple{0.1, 0.2, 0.3}, {}, {}, false}, 1e-3);
    EXPECT_LT((X.p() - Vec3(0.01, -0.02, 0.03)).norm(), Rounding);
    EXPECT_LT((X.R().asMat33() - makeRotation313(Vec3(0.1, 0.2, 0.3)).asMat33()).norm(), Rounding);
}

// ZP and XP are points, not directions: z = unit(ZP - QP), x the part of XP - QP normal to z.
TEST(Frame, FromTwoPoints) {
    const Transform X = makeOrFail({Triple{1, 2, 3}, {}, Triple{1, 5, 3}, Triple{4, 7, 3}, false});
    EXPECT_LT((Vec3(X.z()) - Vec3(0, 1, 0)).norm(), Rounding);
    EXPECT_LT((Vec3(X.x()) - Vec3(1, 0, 0)).norm(), Rounding);
    EXPECT_LT((Vec3(X.y()) - Vec3(0, 0, -1)).norm(), Rounding);
}

TEST(Frame, UsexpExchangesTheRoles) {
    const Transform X = makeOrFail({Triple{1, 2, 3}, {}, Triple{4, 7, 3}, Triple{1, 5, 3}, true});
    EXPECT_LT((Vec3(X.x()) - Vec3(0, 1, 0)).norm(), Rounding);
    EXPECT_LT((Vec3(X.z()) - Vec3(1, 0, 0)).norm(), Rounding);
}

TEST(Frame, AMissingPointLeansToTheBaseAxis) {
    const Transform onlyZ = makeOrFail({{}, {}, Triple{0, 1, 1}, {}, false});
    EXPECT_LT((Vec3(onlyZ.x()) - Vec3(1, 0, 0)).norm(), Rounding);
    const Transform onlyX = makeOrFail({{}, {}, {}, Triple{1, 1, 0}, false});
    EXPECT_LT((Vec3(onlyX.z()) - Vec3(0, 0, 1)).norm(), Rounding);
    EXPECT_LT((Vec3(onlyX.x()) - Vec3(1, 1, 0) / std::sqrt(2.)).norm(), Rounding);
    // The base axis itself is taken: y stands in.
    const Transform alongX = makeOrFail({{}, {}, Triple{2, 0, 0}, {}, false});
    EXPECT_LT((Vec3(alongX.z()) - Vec3(1, 0, 0)).norm(), Rounding);
    EXPECT_LT((Vec3(alongX.x()) - Vec3(0, 1, 0)).norm(), Rounding);
}

TEST(Frame, ImpossiblePointsAreNamed) {
    std::string problem;
    makeFrame({Triple{1, 1, 1}, {}, Triple{1, 1, 1}, {}, false}, 1, problem);
    EXPECT_EQ(problem, "the point for the z axis lies at the origin of the frame; give another point");
    problem.clear();
    makeFrame({{}, {}, Triple{0, 0, 1}, Triple{0, 0, -2}, false}, 1, problem);
    EXPECT_EQ(
        problem,
        "the points for the x and the z axis lie on one line through the origin of the frame; give another "
        "point");
}

}  // namespace
}  // namespace jprim
