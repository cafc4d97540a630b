// SPDX-License-Identifier: Apache-2.0
#include "jprim/mechanism/build_mechanism.h"

#include <gtest/gtest.h>

#include "base/format.h"
#include "jprim/base/error.h"
#include "mechanism/part_mass.h"
#include "support/expect_error.h"
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
    "MARKER/12, PART=1, REULER=-90D,0D,0D\n"
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
    EXPECT_EQ(findMassProblem(3, central), "");
}

// With the sign of the products turned the same figures are no inertia at all.
TEST(PartInertia, WrongSignOfProductsIsNoticed) {
    PartMass part;
    part.mass = 3;
    part.X_BC = Transform(Vec3(0.5, 1, 2));
    part.ip = {20, 17, 5, -1.5, -3, -6};
    EXPECT_TRUE(hasNegativeMoment(calcPrincipalMoments(calcCentralInertia(part))));
}

TEST(PartInertia, IsTurnedFromTheAxesOfIM) {
    PartMass part;
    part.X_BI = Transform(Rotation(SimTK::Pi / 2, SimTK::ZAxis));
    part.X_BC = part.X_BI;
    part.ip = {1, 2, 3, 0, 0, 0};
    EXPECT_LT((calcCentralInertia(part) - Mat33(2, 0, 0, 0, 1, 0, 0, 0, 3)).norm(), 1e-14);
}

TEST(PartInertia, ReachesTheBodyAtTheMassCentre) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nPART/2, MASS=3, CM=20, IM=21, IP=20,17,5,1.5,3,6\n"
        "MARKER/20, QP=0.5,1,2\nMARKER/21\n");
    const SimTK::State state = mechanism.getSystem().realizeTopology();
    const SimTK::MassProperties& mp = mechanism.getParts()[1].body.getBodyMassProperties(state);
    EXPECT_DOUBLE_EQ(mp.getMass(), 3);
    EXPECT_EQ(mp.getMassCenter(), Vec3(0));
    // As in ProductsArePositiveIntegrals: a box of 1 x 2 x 4, about its centre.
    EXPECT_LT((Mat33(mp.getInertia().toMat33()) - Mat33(5, 0, 0, 0, 4.25, 0, 0, 0, 1.25)).norm(), 1e-13);
    EXPECT_EQ(mechanism.getParts()[1].bcs.getPose().p(), Vec3(-0.5, -1, -2));
}

// Rotational energy does not suffer from an origin a thousand kilometres away.
TEST(PartInertia, AFarOriginCostsNothing) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nPART/2, MASS=3, CM=20, IP=1E-3,1E-3,1E-3\nMARKER/20, QP=1E6,0,0\nMARKER/21, "
        "QP=1E6,1,0\n");
    SimTK::State state = mechanism.getSystem().realizeTopology();
    state.updU()[2] = 10;
    mechanism.getSystem().realize(state, SimTK::Stage::Velocity);
    EXPECT_DOUBLE_EQ(mechanism.getSystem().calcKineticEnergy(state), 0.05);
}

TEST(PartInertia, ImpossibleOnesAreErrorsAtThePart) {
    const std::string mm = "t\nUNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=SECOND\n";
    const std::string rest = "MARKER/20\nPART/1,GROUND\nEND\n";
    Diagnostics diagnostics;
    EXPECT_FALSE(buildFromText(mm + "  PART/2, MASS=1, CM=20, IP=1,1,-5\n" + rest, diagnostics));
    EXPECT_EQ(
        formatAll(diagnostics),
        "3:3: error: PART/2 has a negative principal moment of inertia about the mass centre (-5), and the "
        "constraints allow a motion whose kinetic energy it makes negative or zero; check MASS, IP, IM and CM\n");
    diagnostics.clear();
    EXPECT_FALSE(
        buildFromText("t\nPART/2, MASS=1E300, CM=20, IM=21, IP=1,1,1\nMARKER/20, QP=1E300,0,0\nMARKER/21\n"
                      "PART/1,GROUND\nEND\n",
                      diagnostics));
    EXPECT_EQ(
        formatAll(diagnostics),
        "2:1: error: PART/2: no body can have this MASS and IP: mass or inertia about the mass centre is too "
        "large to be a number; check MASS, IP, IM and CM\n");
    diagnostics.clear();
    EXPECT_FALSE(
        buildFromText("t\nPART/2\nMARKER/20\nMARKER/21, QP=1E300,0,0\nPART/1,GROUND\nEND\n", diagnostics));
    EXPECT_EQ(
        formatAll(diagnostics),
        "2:1: error: PART/2: no body can have this MASS and IP: mass or inertia about the mass centre is too "
        "large to be a number; check MASS, IP, IM and CM\n");
}

TEST(PartInertia, MasslessPartsAreBuiltWithAWarning) {
    Diagnostics diagnostics;
    ASSERT_TRUE(
        buildFromText("t\nPART/1,GROUND\nPART/2, MASS=4, CM=20, IP=1,1,1\nMARKER/20\n"
                      "PART/3\nMARKER/30\nPART/4, MASS=2, CM=40\nMARKER/40\nMARKER/41, QP=0.5,0,0\nEND\n",
                      diagnostics));
    EXPECT_EQ(
        formatAll(diagnostics),
        "5:1: warning: PART/3 has no mass; MASS=2e-07 is used so that the equations can be solved\n"
        "7:1: warning: PART/4 has no inertia about some axis; a little is used so that the equations can be "
        "solved\n");
}

TEST(PartInertia, AMassThatVanishesWithoutBeingZeroIsAnError) {
    Diagnostics diagnostics;
    EXPECT_FALSE(
        buildFromText("t\nPART/1,GROUND\nPART/2,MASS=1E-307,CM=20,IP=1,1,1\nMARKER/20\nEND\n", diagnostics));
    EXPECT_EQ(formatAll(diagnostics),
              "3:1: error: PART/2: no body can have this MASS and IP: the mass is too small to divide by; "
              "check MASS, "
              "IP, IM and CM\n");
    diagnostics.clear();
    EXPECT_FALSE(
        buildFromText("t\nPART/1,GROUND\nPOINT_MASS/2,MASS=1E-307,CM=20\nMARKER/20\nEND\n", diagnostics));
    EXPECT_EQ(formatAll(diagnostics), "3:1: error: POINT_MASS/2: the mass is too small to divide by\n");
}

// Only what is zero is replaced, however small it is beside the part's reach.
TEST(PartInertia, SmallOnesStay) {
    const Mat33 small(4e-11, 0, 0, 0, 4e-11, 0, 0, 0, 4e-11);
    const SolvableMass used = makeSolvable(1, small, 100, 1);
    EXPECT_FALSE(used.massReplaced || used.inertiaReplaced);
    EXPECT_EQ((used.inertia - small).norm(), 0);
    EXPECT_TRUE(makeSolvable(1, Mat33(1, 0, 0, 0, 1, 0, 0, 0, 0), 100, 1).inertiaReplaced);
}

TEST(BuildMechanism, WhatGroundCannotHaveIsAWarning) {
    Diagnostics diagnostics;
    EXPECT_TRUE(buildFromText("t\nPART/1,GROUND,EXACT=X\nEND\n", diagnostics));
    EXPECT_EQ(formatAll(diagnostics),
              "2:1: warning: PART/1 is GROUND: its mass, inertia, velocities and EXACT have no effect\n");
}

//----------------------------------------------------------------------------------- misaligned axes
struct Misalignment {
    std::string statement;  // begins in column 2
    std::string error;      // behind the statement's name and type; empty: no error
};

const std::string ZFlipped =
    "the z axes of I=21 and J=11 are 180 degrees apart, nearer to opposite than to equal; turn one of the "
    "markers "
    "so that they point the same way";
const std::string Flipped =
    "the axes of I=21 and J=11 are 180 degrees apart, nearer to opposite than to equal; turn one of the "
    "markers "
    "so that they point the same way";

class MisalignedAxes : public ::testing::TestWithParam<Misalignment> {};

TEST_P(MisalignedAxes, AreErrorsAtTheStatement) {
    const auto& [statement, error] = GetParam();
    Diagnostics diagnostics;
    const bool built = bool(buildFromText(Preamble + " " + statement + "\nEND\n", diagnostics));
    // "JPRIM/3, INLINE, …" is called "JPRIM/3 INLINE".
    const size_t comma = statement.find(','), second = statement.find(',', comma + 1);
    const std::string name = statement.substr(0, comma) + statement.substr(comma + 1, second - comma - 1);
    EXPECT_EQ(formatAll(diagnostics), error.empty() ? "" : "9:2: error: " + name + ": " + error + "\n");
    EXPECT_EQ(built, error.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Statements, MisalignedAxes,
    ::testing::Values(
        Misalignment{"JPRIM/3, PARALLEL_AXES, I=21, J=11", ZFlipped},
        Misalignment{"JPRIM/3, ORIENTATION, I=21, J=11", Flipped},
        Misalignment{"JOINT/4, REVOLUTE, I=21, J=11", ZFlipped},
        Misalignment{"JOINT/4, CYLINDRICAL, I=21, J=11", ZFlipped},
        Misalignment{"JOINT/4, PLANAR, I=21, J=11", ZFlipped},
        Misalignment{"JOINT/4, TRANSLATIONAL, I=21, J=11", Flipped},
        Misalignment{"JOINT/4, FIXED, I=21, J=11", Flipped},
        Misalignment{"JPRIM/3, PERPENDICULAR, I=21, J=10",
                     "the z axis of I=21 and the z axis of J=10 must be perpendicular but are parallel; "
                     "turn one of the markers"},
        Misalignment{"JOINT/4, UNIVERSAL, I=21, J=11",
                     "the z axis of I=21 and the z axis of J=11 must be perpendicular but are parallel; "
                     "turn one of the markers"},
        Misalignment{"JOINT/4, HOOKE, I=21, J=12",
                     "the x axis of I=21 and the y axis of J=12 must be perpendicular but are parallel; "
                     "turn one of the markers"},
        // Nothing to be wrong about.
        Misalignment{"JOINT/4, SPHERICAL, I=21, J=11", ""}, Misalignment{"JPRIM/3, INLINE, I=21, J=11", ""},
        Misalignment{"JPRIM/3, PARALLEL_AXES, I=21, J=10", ""}));

TEST(MisalignedAxes, TheGivenPoseOfThePartCounts) {
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

// The unit suits the largest reach of a part; reactions by number are in newtons all the same.
TEST(BuildMechanism, LengthUnitSuitsTheMechanism) {
    const auto build = [](const std::string& units, double reach) {
        return buildOrFail(
            fmt::format("t\nUNITS/SYSTEM={}\nACCGRAV/KGRAV=-10\nPART/1,GROUND\nMARKER/10\n"
                        "PART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20\nMARKER/21,QP={},0,0\n"
                        "JOINT/1,FIXED,I=20,J=10\nEND\n",
                        units, reach));
    };
    EXPECT_DOUBLE_EQ(build("MKS", 0.05).getLengthUnit(), 1);
    EXPECT_DOUBLE_EQ(build("MKS", 20).getLengthUnit(), 1);
    EXPECT_DOUBLE_EQ(build("MKS", 0.01).getLengthUnit(), 1e-3);
    EXPECT_DOUBLE_EQ(build("CGS", 1).getLengthUnit(), 1e-3);
    EXPECT_DOUBLE_EQ(build("MKS", 1e-6).getLengthUnit(), 1e-6);
    const Mechanism small = build("MKS", 1e-6);
    SimTK::State state = small.makeGivenState();
    small.getSystem().realize(state, SimTK::Stage::Acceleration);
    EXPECT_NEAR(small.calcJOINT(state, 1, 0, 4), 20, 1e-10);
}

TEST(BuildMechanism, ADisplacedGroundCarriesItsMarkers) {
    const Mechanism mechanism = buildOrFail("t\nPART/1,GROUND,QG=1,2,3\nMARKER/10,QP=1,0,0\nEND\n");
    EXPECT_EQ(mechanism.getMarker(10).getPose().p(), Vec3(2, 2, 3));
}

TEST(BuildMechanism, AdamsFunctionsByNumber) {
    const Mechanism mechanism =
        buildOrFail(Preamble + "JPRIM/012, ATPOINT, I=10, J=21\nACCGRAV/KGRAV=-10\nEND\n");
    SimTK::State state = mechanism.makeGivenState();
    mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
    // On ground: minus what holds a rod of mass m whose mass centre, a distance c from the pin, falls.
    const double m = 2, c = 0.5, I = 0.2, g = 10;
    EXPECT_NEAR(mechanism.calcJPRIM(state, 12, 0, 4), -m * g * I / (I + m * c * c), 1e-12);
    EXPECT_NEAR(mechanism.calcJPRIM(state, 12, 1, 4), m * g * I / (I + m * c * c), 1e-12);
    EXPECT_NEAR(mechanism.calcJPRIM(state, 12, 0, 4, 11), m * g * I / (I + m * c * c), 1e-12);
    EXPECT_EQ(testing::catchError([&] { static_cast<void>(mechanism.calcJPRIM(state, 13, 0, 4)); }),
              "JPRIM/13: does not exist in this mechanism");
    EXPECT_THROW(static_cast<void>(mechanism.calcJOINT(state, 12, 0, 4)), Error);
    EXPECT_THROW(static_cast<void>(mechanism.getMarker(99)), Error);
}

}  // namespace
}  // namespace jprim
