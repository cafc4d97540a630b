// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/assemble.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "jprim/base/error.h"
#include "jprim/marker/angles.h"
#include "support/expect_error.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Transform;
using SimTK::Vec3;
using testing::buildOrFail;

Transform getPose(const AssembledState& assembled, const MechanismPart& part) {
    return part.bcs.findPoseInGround(assembled.state);
}

SpatialVec getVelocity(const AssembledState& assembled, const MechanismPart& part) {
    return part.cm.findVelocityInGround(assembled.state);
}

// A rod of length 1 hinged at both ends to a second one; the given ends are apart by (0.1, 0.06, 0).
std::string makeTwoRods(const std::string& argumentsOf2, const std::string& argumentsOf3) {
    return "two rods\nPART/1, GROUND\nMARKER/10\n"
           "PART/2, MASS=1, CM=20, IP=0.1,0.1,0.01" +
           argumentsOf2 +
           "\n"
           "MARKER/20, QP=0.5,0,0\nMARKER/21\nMARKER/22, QP=1,0,0\n"
           "PART/3, MASS=1, CM=30, IP=0.1,0.1,0.01, QG=1.1,0.06,0" +
           argumentsOf3 +
           "\n"
           "MARKER/30, QP=0.5,0,0\nMARKER/31\n"
           "JPRIM/1, ATPOINT, I=21, J=10\nJPRIM/2, ATPOINT, I=31, J=22\nEND\n";
}

TEST(Assemble, GivenPositionsThatFitAreNotTouched) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=1,CM=20,IP=1,1,1,REULER=0.3,0.2,0.1\n"
        "MARKER/20,QP=1,2,3\nMARKER/21\nJOINT/1,SPHERICAL,I=21,J=10\nEND\n");
    const AssembledState assembled = assemble(mechanism);
    EXPECT_TRUE(assembled.moved.empty());
    EXPECT_LT((getPose(assembled, mechanism.getParts()[1]).R().asMat33() -
               makeRotation313(Vec3(0.3, 0.2, 0.1)).asMat33())
                  .norm(),
              1e-15);
}

TEST(Assemble, MovesAsLittleAsNeeded) {
    const Mechanism mechanism = buildOrFail(makeTwoRods("", ""));
    const AssembledState assembled = assemble(mechanism);
    EXPECT_NEAR(assembled.before.length, 0.1, 1e-12);
    EXPECT_EQ(assembled.before.element, "JPRIM/2");
    EXPECT_LT(std::max(assembled.after.length, assembled.after.angle), AssemblyTolerance);
    ASSERT_EQ(assembled.moved.size(), 2u);
    // The gap is 0.117 long; nothing need move further than that.
    for (const MovedPart& part : assembled.moved) {
        EXPECT_LT(part.distance, 0.12) << part.part;
        EXPECT_LT(part.angle, 0.12) << part.part;
    }
}

TEST(Assemble, ExactCoordinatesStay) {
    const Mechanism mechanism = buildOrFail(makeTwoRods("", ", EXACT=Y:Z:PSI"));
    const AssembledState assembled = assemble(mechanism);
    const Transform X = getPose(assembled, mechanism.getParts()[2]);
    EXPECT_LT(assembled.after.length, AssemblyTolerance);
    EXPECT_NEAR(X.p()[1], 0.06, 1e-7);
    EXPECT_NEAR(X.p()[2], 0, 1e-7);
    EXPECT_GT(std::abs(X.p()[0] - 1.1), 1e-3) << "X is not exact and has to move";
}

TEST(Assemble, APartThatIsAllExactDoesNotMoveAtAll) {
    const Mechanism mechanism = buildOrFail(makeTwoRods("", ", EXACT=X:Y:Z:PSI:THETA:PHI"));
    // The first rod alone cannot reach: it is 1 long and the end is sqrt(1.1^2 + 0.06^2) away.
    EXPECT_THROW(assemble(mechanism), Error);
    const Mechanism other = buildOrFail(makeTwoRods(", EXACT=X:Y:Z:PSI:THETA:PHI", ""));
    const AssembledState assembled = assemble(other);
    ASSERT_EQ(assembled.moved.size(), 1u);
    EXPECT_EQ(assembled.moved[0].part, "PART/3");
}

// A crank in the plane, its hinge 0.2 out of place: translation alone mends it, whatever angle is held.
class ExactAngles : public ::testing::TestWithParam<std::string> {};

TEST_P(ExactAngles, AreHeldWhereTheAnglesAreSingular) {
    for (const int degrees : {0, 5, 20, 45, 80}) {
        SCOPED_TRACE(degrees);
        const Mechanism mechanism =
            buildOrFail("crank\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=1,CM=20,IP=1,1,1,QG=0.2,0,0,REULER=" +
                        std::to_string(degrees) + "D,0D,0D,EXACT=" + GetParam() +
                        "\nMARKER/20,QP=0.3,0,0\nMARKER/21\nJOINT/1,REVOLUTE,I=21,J=10\nEND\n");
        const AssembledState assembled = assemble(mechanism);
        const Transform X = getPose(assembled, mechanism.getParts()[1]);
        const SimTK::Rotation turn = ~mechanism.getParts()[1].givenPose.R() * X.R();
        EXPECT_LT(X.p().norm(), 1e-7);
        EXPECT_LT(std::abs(turn.convertRotationToAngleAxis()[0]), 1e-7);
    }
}

INSTANTIATE_TEST_SUITE_P(Held, ExactAngles, ::testing::Values("PSI", "PHI", "PSI:THETA:PHI", "PSI:THETA"),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::replace(name.begin(), name.end(), ':', '_');
                             return name;
                         });

TEST(Assemble, FailureNamesTheElementAndWhatIsLeft) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nMARKER/10\nMARKER/11,QP=3,0,0\nPART/2,MASS=1,CM=20,IP=1,1,1\nMARKER/20\n"
        "MARKER/21,QP=1,0,0\nJPRIM/1,ATPOINT,I=20,J=10\nJPRIM/2,ATPOINT,I=21,J=11\nEND\n");
    const std::string text = testing::catchError([&] { assemble(mechanism); });
    EXPECT_EQ(text.find("JPRIM/"), 0u) << text;
    EXPECT_NE(text.find("the parts cannot be assembled from their given positions; an error of"),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find("EXACT"), std::string::npos);
}

TEST(Assemble, FailureSaysWhatIsHeld) {
    const Mechanism mechanism = buildOrFail(makeTwoRods("", ", EXACT=X:Y:Z:PSI:THETA:PHI"));
    const std::string text = testing::catchError([&] { assemble(mechanism); });
    EXPECT_NE(text.find("is left, with the EXACT coordinates of PART/3 held"), std::string::npos) << text;
}

// A gap of 0.9 nm on parts of 1 nm is a gap.
TEST(Assemble, TolerancesSuitTheSize) {
    const Mechanism mechanism = buildOrFail(
        "t\nUNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=NANOMETER,TIME=SECOND\nPART/1,GROUND\nMARKER/10\n"
        "PART/2,MASS=1,CM=20,IP=1,1,1,QG=0.9,0,0\nMARKER/20\nMARKER/21,QP=1,0,0\n"
        "JPRIM/1,ATPOINT,I=20,J=10\nEND\n");
    const AssembledState assembled = assemble(mechanism);
    ASSERT_EQ(assembled.moved.size(), 1u);
    EXPECT_NEAR(assembled.moved[0].distance / mechanism.getUnits().length, 0.9, 1e-6);
}

//---------------------------------------------------------------------------------- initial velocities
// A rod pinned at its end by ATPOINT, turning about its own z by 0.5 rad/s; its mass centre is 0.5 away.
std::string makePinnedRod(const std::string& velocity) {
    return "t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.01," + velocity +
           "\nMARKER/20,QP=0.5,0,0,REULER=0,0.4,0\nMARKER/21\nMARKER/22,REULER=0.2,0.3,0.4\n"
           "JPRIM/1,ATPOINT,I=21,J=10\nEND\n";
}

TEST(InitialVelocities, UnsetOnesFollow) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.01,WZ=0.5\nMARKER/20,QP=0.5,0,0\n"
        "MARKER/21\nJPRIM/1,ATPOINT,I=21,J=10\nEND\n");
    const SpatialVec V = getVelocity(assemble(mechanism), mechanism.getParts()[1]);
    EXPECT_LT((V[0] - Vec3(0, 0, 0.5)).norm(), 1e-12);
    EXPECT_LT((V[1] - Vec3(0, 0.25, 0)).norm(), 1e-12);
}

// Asking for rest and for rotation at once: both are met as nearly as can be, neither wholly.
TEST(InitialVelocities, ZeroIsNotTheSameAsUnset) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.01,WZ=0.5,VY=0\n"
        "MARKER/20,QP=0.5,0,0\nMARKER/21\nJPRIM/1,ATPOINT,I=21,J=10\nEND\n");
    // Minimize (s w - s 0.5)^2 + (0.5 w)^2 with the part's size s = 0.5: w = 0.25.
    const SpatialVec V = getVelocity(assemble(mechanism), mechanism.getParts()[1]);
    EXPECT_LT((V[0] - Vec3(0, 0, 0.25)).norm(), 1e-12);
}

TEST(InitialVelocities, AreGivenInTheAxesOfVmAndWm) {
    const Mechanism mechanism = buildOrFail(makePinnedRod("WX=1,WY=2,WZ=3,WM=22"));
    const AssembledState assembled = assemble(mechanism);
    const Vec3 w = makeRotation313(Vec3(0.2, 0.3, 0.4)) * Vec3(1, 2, 3);
    EXPECT_LT((getVelocity(assembled, mechanism.getParts()[1])[0] - w).norm(), 1e-12);

    const Mechanism byCm = buildOrFail(makePinnedRod("WX=1,WY=2,WZ=3"));
    const Vec3 wByCm = makeRotation313(Vec3(0, 0.4, 0)) * Vec3(1, 2, 3);
    EXPECT_LT((getVelocity(assemble(byCm), byCm.getParts()[1])[0] - wByCm).norm(), 1e-12);

    const Mechanism free = buildOrFail(
        "t\nPART/1,GROUND\nPART/2,MASS=2,CM=20,IP=1,1,1,VX=1,VY=2,VZ=3,VM=20\n"
        "MARKER/20,REULER=0.2,0.3,0.4\nEND\n");
    EXPECT_LT((getVelocity(assemble(free), free.getParts()[1])[1] - w).norm(), 1e-12);
}

TEST(InitialVelocities, ThatTheConstraintsForbidAreDropped) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=1,1,1,VX=1,VZ=2\nMARKER/20\n"
        "JOINT/1,TRANSLATIONAL,I=20,J=10\nEND\n");
    const AssembledState assembled = assemble(mechanism);
    const SpatialVec V = getVelocity(assembled, mechanism.getParts()[1]);
    EXPECT_LT((V[1] - Vec3(0, 0, 2)).norm(), 1e-12);
    EXPECT_LT(assembled.state.getUErr().norm(), 1e-12);
}

}  // namespace
}  // namespace jprim
