// SPDX-License-Identifier: Apache-2.0
// Rank that is lost in one position, told from redundancy.
#include <gtest/gtest.h>

#include "analysis/free_bodies.h"

namespace jprim {
namespace {

using SimTK::Vec3;
using testing::FreeBodies;
using testing::getRedundantTexts;
using testing::makeHinge;
constexpr int Ground = FreeBodies::Ground;

// Hinges across an oblique plane at the points (x, y) in it; the last link is Ground.
void addPlaneLoop(FreeBodies& loop, const std::vector<Vec3>& points) {
    const SimTK::Rotation R = makeHinge(Vec3(0), Vec3(0.3, -0.5, 0.8)).R();
    const int numLinks = int(points.size()) - 1;
    int before = Ground;
    for (int k = 0; k <= numLinks; ++k) {
        const int link = k == numLinks ? Ground : loop.addBody(R * points[size_t(k)]);
        loop.addJoint(Joint::Revolute, link, before, makeHinge(R * points[size_t(k)], R.z()));
        before = link;
    }
}

// Arms of 1 on pins a distance of 2 apart, turned by an angle from the line of the pins.
std::vector<Vec3> makeParallelogram(double angle) {
    const Vec3 arm(std::cos(angle), std::sin(angle), 0), base(2, 0, 0);
    return {Vec3(0), arm, base + arm, base};
}

// Flattened, a parallelogram may go on as one or as an antiparallelogram: two freedoms here, one nearby. Its
// three redundant equations are so everywhere.
TEST(SingularPosition, FlattenedParallelogram) {
    FreeBodies flat, open;
    addPlaneLoop(flat, makeParallelogram(0));
    addPlaneLoop(open, makeParallelogram(1.1));
    const ConstraintReport here = flat.analyze(), elsewhere = open.analyze();
    EXPECT_EQ(here.getGrueblerCount(), -2);
    EXPECT_EQ(here.getDegreesOfFreedom(), 2);
    EXPECT_EQ(here.freedomsNearby, 1);
    EXPECT_TRUE(here.isSingularPosition());
    EXPECT_EQ(here.getNumRedundant(), 4);

    EXPECT_EQ(elsewhere.getDegreesOfFreedom(), 1);
    EXPECT_FALSE(elsewhere.isSingularPosition());
    EXPECT_EQ(getRedundantTexts(here), getRedundantTexts(elsewhere));
    EXPECT_EQ(getRedundantTexts(here).size(), 3u);
    const std::set<std::string> lost = getRedundantTexts(here, true);
    ASSERT_EQ(lost.size(), 1u);
    EXPECT_EQ(lost.begin()->find("JOINT/4 REVOLUTE: translation of I along "), 0u) << *lost.begin();
    EXPECT_TRUE(getRedundantTexts(elsewhere, true).empty());
}

// Two links stretched straight between fixed pins can be moved to first order, and not at all. Of 15 equations
// for 12 speeds three are redundant everywhere. The decision does not depend on the proportions, nor on what
// else moves.
TEST(SingularPosition, StraightenedLinksOnlySeemFree) {
    for (const double length : {0.02, 0.1, 0.5, 1., 1.8, 2.3})
        for (const int numPendulums : {0, 1}) {
            SCOPED_TRACE(length);
            FreeBodies links;
            addPlaneLoop(links, {Vec3(0), Vec3(length, 0, 0), Vec3(2.5, 0, 0)});
            if (numPendulums > 0) links.addJoint(Joint::Revolute, links.addBody(), Ground, Vec3(1, 2, 3));
            const ConstraintReport report = links.analyze();
            EXPECT_EQ(report.getDegreesOfFreedom(), 1 + numPendulums);
            EXPECT_EQ(report.freedomsNearby, numPendulums);
            EXPECT_TRUE(report.isSingularPosition());
            EXPECT_EQ(getRedundantTexts(report).size(), 3u);
            EXPECT_EQ(getRedundantTexts(report, true).size(), 1u);
        }
}

// The same links bent hold each other, regularly.
TEST(SingularPosition, BentLinksDoNot) {
    FreeBodies links;
    addPlaneLoop(links, {Vec3(0), Vec3(0.8, 0.6, 0), Vec3(2, 0, 0)});
    const ConstraintReport report = links.analyze();
    EXPECT_EQ(report.getDegreesOfFreedom(), 0);
    EXPECT_EQ(report.getNumRedundant(), 3);
    EXPECT_FALSE(report.isSingularPosition());
}

// A thousandth of a radian from flat the position is regular, and the gap says how nearly it is not.
TEST(SingularPosition, NearlyFlatIsRegularAndTheGapTells) {
    FreeBodies flat, nearlyFlat;
    addPlaneLoop(flat, makeParallelogram(0));
    addPlaneLoop(nearlyFlat, makeParallelogram(1e-3));
    const ConstraintReport report = nearlyFlat.analyze();
    EXPECT_EQ(report.getDegreesOfFreedom(), 1);
    EXPECT_FALSE(report.isSingularPosition());
    EXPECT_LT(report.smallestKept, 3e-3);
    EXPECT_LT(report.largestDropped, 1e-12);
    EXPECT_GT(flat.analyze().smallestKept, 1e-1);
}

}  // namespace
}  // namespace jprim
