// SPDX-License-Identifier: Apache-2.0
#include "jprim/build/build_mechanism.h"

#include <gtest/gtest.h>

#include "build/part_mass.h"
#include "jprim/base/error.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Mat33;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;
using testing::buildFromText;
using testing::buildOrFail;
using testing::formatAll;

// Everything about ground and one body, for tests to add to.
const std::string Preamble =
    "title\n"
    "PART/1, GROUND\n"
    "MARKER/10\n"
    "MARKER/11, REULER=0D,180D,0D\n"
    "PART/2, MASS=2, CM=20, IP=0.1,0.2,0.15\n"
    "MARKER/20, QP=0.5,0,0\n"
    "MARKER/21\n";

//-------------------------------------------------------------------------------------------- inertia
// A box of homogeneous mass has products of inertia about a corner that are all positive integrals; about its
// centre they vanish. (Any textbook: I_xx = m (b^2 + c^2)/3 at the corner, /12 at the centre; Int(xy dm) = m
// a b/4.)
TEST(PartInertia, ProductsArePositiveIntegrals) {
    const double m = 3, a = 1, b = 2, c = 4;
    PartMass part;
    part.mass = m;
    part.X_BC = Transform(Vec3(a, b, c) / 2);
    part.ip = {m * (b * b + c * c) / 3, m * (a * a + c * c) / 3, m * (a * a + b * b) / 3,
               m * a * b / 4,           m * a * c / 4,           m * b * c / 4};
    const Mat33 central = calcCentralInertia(part);
    const Mat33 expected(m * (b * b + c * c) / 12, 0, 0, 0, m * (a * a + c * c) / 12, 0, 0, 0,
                         m * (a * a + b * b) / 12);
    EXPECT_LT((central - expected).norm(), 1e-13);
    EXPECT_EQ(findInertiaProblem(central, 1), "");
}

// With the sign of the products turned the same figures are no inertia at all.
TEST(PartInertia, WrongSignOfProductsIsNoticed) {
    PartMass part;
    part.mass = 3;
    part.X_BC = Transform(Vec3(0.5, 1, 2));
    part.ip = {20, 17, 5, -1.5, -3, -6};
    EXPECT_NE(findInertiaProblem(calcCentralInertia(part), 1), "");
}

TEST(PartInertia, IsTurnedFromTheAxesOfIM) {
    PartMass part;
    part.X_BI = Transform(Rotation(SimTK::Pi / 2, SimTK::ZAxis));
    part.X_BC = part.X_BI;
    part.ip = {1, 2, 3, 0, 0, 0};
    EXPECT_LT((calcCentralInertia(part) - Mat33(2, 0, 0, 0, 1, 0, 0, 0, 3)).norm(), 1e-14);
}

TEST(PartInertia, ReachesTheBody) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nPART/2, MASS=3, CM=20, IM=21, IP=20,17,5,1.5,3,6\n"
        "MARKER/20, QP=0.5,1,2\nMARKER/21\n");
    const SimTK::State state = mechanism.getSystem().realizeTopology();
    const SimTK::MassProperties& mp = mechanism.getParts()[1].body.getBodyMassProperties(state);
    EXPECT_DOUBLE_EQ(mp.getMass(), 3);
    EXPECT_LT((mp.getMassCenter() - Vec3(0.5, 1, 2)).norm(), 1e-15);
    const Mat33 aboutOrigin = Mat33(mp.getInertia().toMat33());
    EXPECT_LT((aboutOrigin - Mat33(20, -1.5, -3, -1.5, 17, -6, -3, -6, 5)).norm(), 1e-12);
}

TEST(PartInertia, ImpossibleOnesAreErrorsAtThePart) {
    Diagnostics diagnostics;
    EXPECT_FALSE(
        buildFromText("t\nUNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=SECOND\n"
                      "  PART/2, MASS=1, CM=20, IP=1,1,5\nMARKER/20\nPART/1,GROUND\nEND\n",
                      diagnostics));
    EXPECT_EQ(formatAll(diagnostics),
              "3:3: error: PART/2: no body can have this IP: its largest principal moment about the mass "
              "centre (5) "
              "is larger than the sum of the other two (2); check IP, IM and CM\n");
}

TEST(PartInertia, MasslessPartsAreBuiltWithAWarning) {
    Diagnostics diagnostics;
    ASSERT_TRUE(
        buildFromText("t\nPART/1,GROUND\nPART/2, MASS=4, CM=20, IP=1,1,1\nMARKER/20\n"
                      "PART/3\nMARKER/30\nPART/4, MASS=2, CM=40\nMARKER/40\nMARKER/41, QP=0.5,0,0\nEND\n",
                      diagnostics));
    EXPECT_EQ(
        formatAll(diagnostics),
        "5:1: warning: PART/3 has no mass; 2e-07 kg is used so that the equations can be solved\n"
        "7:1: warning: PART/4 has no inertia about some axis; 5e-08 kg m^2 is used so that the equations can "
        "be solved\n");
}

//-------------------------------------------------------------------------------------- flipped axes
struct Flip {
    const char* statement;
    const char* error;  // empty: no error
};

class FlippedAxes : public ::testing::TestWithParam<Flip> {};

TEST_P(FlippedAxes, AreErrorsAtTheStatement) {
    Diagnostics diagnostics;
    const bool built = bool(buildFromText(Preamble + GetParam().statement + "\nEND\n", diagnostics));
    EXPECT_EQ(formatAll(diagnostics), GetParam().error);
    EXPECT_EQ(built, std::string(GetParam().error).empty());
}

INSTANTIATE_TEST_SUITE_P(
    Statements, FlippedAxes,
    ::testing::Values(
        Flip{"JPRIM/3, PARALLEL_AXES, I=21, J=11",
             "8:1: error: JPRIM/3 PARALLEL_AXES: the z axes of I=21 and J=11 are 180 degrees apart and would "
             "assemble flipped; turn one of the markers so that they point the same way\n"},
        Flip{"JPRIM/3, ORIENTATION, I=21, J=11",
             "8:1: error: JPRIM/3 ORIENTATION: the axes of I=21 and J=11 are 180 degrees apart and would "
             "assemble flipped; turn one of the markers so that they point the same way\n"},
        Flip{" JOINT/4, REVOLUTE, I=11, J=21",
             "8:2: error: JOINT/4 REVOLUTE: the z axes of I=11 and J=21 are 180 degrees apart and would "
             "assemble "
             "flipped; turn one of the markers so that they point the same way\n"},
        Flip{"JOINT/4, CYLINDRICAL, I=11, J=21",
             "8:1: error: JOINT/4 CYLINDRICAL: the z axes of I=11 and J=21 are 180 degrees apart and would "
             "assemble "
             "flipped; turn one of the markers so that they point the same way\n"},
        Flip{"JOINT/4, PLANAR, I=11, J=21",
             "8:1: error: JOINT/4 PLANAR: the z axes of I=11 and J=21 are 180 degrees apart and would "
             "assemble "
             "flipped; turn one of the markers so that they point the same way\n"},
        Flip{"JOINT/4, TRANSLATIONAL, I=11, J=21",
             "8:1: error: JOINT/4 TRANSLATIONAL: the axes of I=11 and J=21 are 180 degrees apart and would "
             "assemble "
             "flipped; turn one of the markers so that they point the same way\n"},
        Flip{"JOINT/4, FIXED, I=11, J=21",
             "8:1: error: JOINT/4 FIXED: the axes of I=11 and J=21 are 180 degrees apart and would assemble "
             "flipped; turn one of the markers so that they point the same way\n"},
        // No sense to be wrong about.
        Flip{"JOINT/4, SPHERICAL, I=11, J=21", ""}, Flip{"JPRIM/3, INLINE, I=11, J=21", ""},
        Flip{"JPRIM/3, PARALLEL_AXES, I=21, J=10", ""}));

TEST(FlippedAxes, TheGivenPoseOfThePartCounts) {
    Diagnostics diagnostics;
    const std::string text =
        "t\nPART/1,GROUND\nMARKER/10\nPART/2, MASS=1, CM=20, IP=1,1,1, REULER=0,100D,0\nMARKER/20\n"
        "JPRIM/3, PARALLEL_AXES, I=20, J=10\nEND\n";
    EXPECT_FALSE(buildFromText(text, diagnostics));
    EXPECT_NE(formatAll(diagnostics).find("are 100 degrees apart"), std::string::npos)
        << formatAll(diagnostics);
}

//----------------------------------------------------------------------------------- frames and units
TEST(BuildMechanism, FramesThatPointsDoNotDefineAreErrors) {
    Diagnostics diagnostics;
    EXPECT_FALSE(buildFromText("t\nPART/1,GROUND\nMARKER/10, ZP=0,0,0\nEND\n", diagnostics));
    EXPECT_EQ(formatAll(diagnostics),
              "3:1: error: MARKER/10: the point for the z axis lies at the origin of the frame; give another "
              "point\n");
}

TEST(BuildMechanism, UcfAloneGivesTheForceUnit) {
    const Mechanism mechanism = buildOrFail("t\nUNITS/UCF=1000\nPART/1,GROUND\nEND\n");
    EXPECT_DOUBLE_EQ(mechanism.getUnits().force, 1000);
}

TEST(BuildMechanism, UcfAgainstTheNamedUnitsIsAWarning) {
    Diagnostics diagnostics;
    const auto mechanism = buildFromText(
        "t\nUNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=SECOND,UCF=1\nPART/1,GROUND\nEND\n",
        diagnostics);
    ASSERT_TRUE(mechanism);
    EXPECT_DOUBLE_EQ(mechanism->getUnits().force, 1);
    EXPECT_EQ(
        formatAll(diagnostics),
        "2:1: warning: UCF=1 does not fit the named units, whose factor is 1000; the named units are used\n");
}

TEST(BuildMechanism, ADisplacedGroundCarriesItsMarkers) {
    const Mechanism mechanism = buildOrFail("t\nPART/1,GROUND,QG=1,2,3\nMARKER/10,QP=1,0,0\nEND\n");
    EXPECT_EQ(mechanism.getMarker(10).getPose().p(), Vec3(2, 2, 3));
}

TEST(BuildMechanism, AdamsFunctionsByNumber) {
    const Mechanism mechanism =
        buildOrFail(Preamble + "JPRIM/012, ATPOINT, I=10, J=21\nACCGRAV/KGRAV=-10\nEND\n");
    SimTK::State state = mechanism.getSystem().realizeTopology();
    mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
    // On ground: minus what holds a rod of mass m whose mass centre, a distance c from the pin, falls.
    const double m = 2, c = 0.5, I = 0.2, g = 10;
    EXPECT_NEAR(mechanism.calcJPRIM(state, 12, 0, 4), -m * g * I / (I + m * c * c), 1e-12);
    EXPECT_NEAR(mechanism.calcJPRIM(state, 12, 1, 4), m * g * I / (I + m * c * c), 1e-12);
    EXPECT_NEAR(mechanism.calcJPRIM(state, 12, 0, 4, 11), m * g * I / (I + m * c * c), 1e-12);
    try {
        mechanism.calcJPRIM(state, 13, 0, 4);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "JPRIM/13: does not exist in this mechanism");
    }
    EXPECT_THROW(mechanism.calcJOINT(state, 12, 0, 4), Error);
    EXPECT_THROW(mechanism.getMarker(99), Error);
}

}  // namespace
}  // namespace jprim
