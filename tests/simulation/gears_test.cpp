// SPDX-License-Identifier: Apache-2.0
// What couples turns and travels: COUPLER, SCREW and RACKPIN, each as the inertia that its equation makes of
// several: sum r_i q_i = 0 and Lagrange's multiplier give the accelerations exactly.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "support/dataset_units.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using testing::buildOrFail;
using testing::DatasetUnits;
using testing::MetreSecond;

// Of the final displacement; the runs are parabolas, which the integrator gets right but for its tolerance.
constexpr double Tolerance = 1e-7;

class Gears : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(Gears);

Table runFor(const std::string& text, const DatasetUnits& u, double seconds) {
    return testing::run(buildOrFail(text), seconds * u.s, 20, 1e-9).results.requests;
}

// A part on a joint with the ground, of its own number: markers 10 n and 10 n + 1, moved by `load`.
std::string makeWheel(const DatasetUnits& u, int n, const char* type, double mass, double inertia) {
    return fmt::format(
        "MARKER/{0}0,PART=1,QP={1},{2},0,REULER=0.{0},0.5,0.{0}\n"
        "PART/{0},MASS={3},CM={0}1,IP={4},{4},{4},QG={1},{2},0,REULER=0.{0},0.5,0.{0}\nMARKER/{0}1\n"
        "JOINT/{0},{5},I={0}1,J={0}0\n",
        n, n * u.m, -0.3 * n * u.m, mass, inertia * u.m * u.m, type);
}

std::string makeTorque(const DatasetUnits& u, int n, double torque) {
    return fmt::format("SFORCE/{0},ROTATIONAL,ACTIONONLY,I={0}1,J={0}0,FUNCTION={1}\n", n, torque * u.m);
}

std::string begin(const DatasetUnits& u) {
    return fmt::format("gears\n{}PART/1,GROUND\n", u.statement);
}

//--------------------------------------------------------------------------------------------- COUPLER
constexpr double Torque = 4;

std::string makePair(const DatasetUnits& u, const char* scales) {
    return begin(u) + makeWheel(u, 2, "REVOLUTE", 1, 0.3) + makeWheel(u, 3, "REVOLUTE", 2, 0.5) +
           makeTorque(u, 2, Torque) + "COUPLER/1,JOINTS=2,3,TYPE=R:R,SCALES=" + scales +
           "\nREQUEST/1,F2=AZ(21,20)\\F3=AZ(31,30)\\F4=WZ(31,30,30)\nEND\n";
}

TEST_P(Gears, OneToMinusTwo) {
    const Table r = runFor(makePair(u, "1,-2"), u, 3);
    const double acceleration = Torque / (0.3 + 0.5 / 4), angle = acceleration * 9 / 2;  // 42 rad
    EXPECT_NEAR(r.getColumn("R1.F2").back(), angle, Tolerance * angle);
    EXPECT_NEAR(r.getColumn("R1.F3").back(), angle / 2, Tolerance * angle);
    EXPECT_NEAR(r.getColumn("R1.F4").back() * u.s, acceleration * 3 / 2, Tolerance * angle);
}

TEST(GearsMutated, AnotherRatioIsNoticed) {
    const Table r = runFor(makePair(MetreSecond, "1,-2.002"), MetreSecond, 3);
    const double angle = Torque / (0.3 + 0.5 / 4) * 9 / 2;
    EXPECT_GT(std::abs(r.getColumn("R1.F3").back() - angle / 2), 100 * Tolerance * angle);
}

TEST_P(Gears, AnOmittedFirstScaleIsOne) {
    EXPECT_NEAR(runFor(makePair(u, "-2"), u, 1).getColumn("R1.F3").back(),
                runFor(makePair(u, "1,-2"), u, 1).getColumn("R1.F3").back(), 1e-12);
}

// A differential: 2 q1 + 3 q2 - q3 = 0.
TEST_P(Gears, ThreeJointsShareATorque) {
    const std::string text = begin(u) + makeWheel(u, 2, "REVOLUTE", 1, 0.3) +
                             makeWheel(u, 3, "CYLINDRICAL", 2, 0.5) + makeWheel(u, 4, "REVOLUTE", 1, 0.2) +
                             makeTorque(u, 2, Torque) +
                             "COUPLER/1,JOINTS=2,3,4,TYPE=R:R:R,SCALES=2,3,-1\n"
                             "REQUEST/1,F2=AZ(21,20)\\F3=AZ(31,30)\\F4=AZ(41,40)\\F6=DZ(31,30,30)\nEND\n";
    const Table r = runFor(text, u, 2);
    const double multiplier = 2 * Torque / 0.3 / (4 / 0.3 + 9 / 0.5 + 1 / 0.2);
    EXPECT_NEAR(r.getColumn("R1.F2").back(), 2 * (Torque - 2 * multiplier) / 0.3, 20 * Tolerance);
    EXPECT_NEAR(r.getColumn("R1.F3").back(), -2 * 3 * multiplier / 0.5, 20 * Tolerance);
    EXPECT_NEAR(r.getColumn("R1.F4").back(), 2 * multiplier / 0.2, 20 * Tolerance);
    EXPECT_EQ(std::abs(r.getColumn("R1.F6").back()) < 1e-9 * u.m, true);
}

// A turn and a travel, x = 0.05 m of travel per radian: the scale of a travel has the unit of 1/length.
TEST_P(Gears, ATurnIsCoupledToATravel) {
    const std::string text = begin(u) + makeWheel(u, 2, "REVOLUTE", 1, 0.3) +
                             makeWheel(u, 3, "TRANSLATIONAL", 7, 0.5) + makeTorque(u, 2, Torque) +
                             fmt::format("COUPLER/1,JOINTS=2,3,TYPE=R:T,SCALES=1,{}\n", -1 / (0.05 * u.m)) +
                             "REQUEST/1,F2=AZ(21,20)\\F3=DZ(31,30,30)\nEND\n";
    const Table r = runFor(text, u, 2);
    const double angle = 2 * Torque / (0.3 + 7 * 0.05 * 0.05);
    EXPECT_NEAR(r.getColumn("R1.F2").back(), angle, Tolerance * angle);
    EXPECT_NEAR(r.getColumn("R1.F3").back() / u.m, 0.05 * angle, Tolerance * angle);
}

// The equation is on the displacements themselves: what the markers are given with counts.
TEST(Gears, CouplersAreAbsolute) {
    const std::string text =
        begin(MetreSecond) +
        "MARKER/20,PART=1\nPART/2,MASS=1,CM=21,IP=1,1,1,REULER=0.4,0,0\nMARKER/21\nJOINT/2,REVOLUTE,I=21,J=20\n"
        "MARKER/30,PART=1\nPART/3,MASS=1,CM=31,IP=1,1,1,REULER=-0.1,0,0\nMARKER/31\nJOINT/3,REVOLUTE,I=31,J=30\n"
        "COUPLER/1,JOINTS=2,3,SCALES=1,-2\nREQUEST/1,F2=AZ(21,20)\\F3=AZ(31,30)\nEND\n";
    const Table r = runFor(text, MetreSecond, 1);
    EXPECT_NEAR(r.getColumn("R1.F2")[0], 2 * r.getColumn("R1.F3")[0], 1e-9);
    EXPECT_GT(std::abs(r.getColumn("R1.F2")[0]), 0.01);
}

//---------------------------------------------------------------------------------- SCREW and RACKPIN
constexpr double Mass = 7, Inertia = 0.3;

// A nut on a screw of 0.02 m pitch, left- or right-handed, that a torque and its weight turn.
std::string makeScrew(const DatasetUnits& u, double pitch) {
    return fmt::format(
        "screw\n{0}ACCGRAV/KGRAV={1}\nPART/1,GROUND\nMARKER/10\n"
        "PART/2,MASS={2},CM=20,IP={3},{3},{3},QG=0,0,{4},REULER=0.5,0,0\nMARKER/20\n"
        "JOINT/1,CYLINDRICAL,I=20,J=10\nJOINT/2,SCREW,PITCH={5},I=20,J=10\n"
        "SFORCE/1,ROTATIONAL,I=20,J=10,FUNCTION={6}\n"
        "REQUEST/1,F2=AZ(20,10)\\F3=DZ(20,10)\\F4=VZ(20,10)/WZ(20,10)\\F6=JOINT(2,0,4)\\F7=JOINT(2,0,8)\nEND\n",
        u.statement, -10 * u.m / u.s / u.s, Mass, Inertia * u.m * u.m, 0.1 * u.m, pitch * u.m, Torque * u.m);
}

void checkScrew(const DatasetUnits& u, double pitch) {
    const Table r = runFor(makeScrew(u, pitch), u, 3);
    const double c = pitch / (2 * SimTK::Pi);
    const double acceleration = (Torque - c * Mass * 10) / (Inertia + Mass * c * c);
    const double angle = acceleration * 9 / 2;
    EXPECT_NEAR(r.getColumn("R1.F2").back(), 0.5 + angle, Tolerance * angle);
    EXPECT_NEAR(r.getColumn("R1.F3").back() / u.m, 0.1 + c * angle, Tolerance * angle);
    // The thread alone carries the axial load, and turns it into a torque.
    const double thread = Mass * (10 + c * acceleration);
    EXPECT_NEAR(r.getColumn("R1.F6").back(), thread, Tolerance * thread);
    EXPECT_NEAR(r.getColumn("R1.F7").back() / u.m, -c * thread, Tolerance * thread);
}

TEST_P(Gears, AScrewTravelsItsPitchPerTurn) {
    checkScrew(u, 0.02);
    checkScrew(u, -0.05);
}

// A pinion of 0.08 m pitch diameter drives a rack; both are given with an offset that stays.
TEST_P(Gears, ARackTravelsAsThePinionRolls) {
    const std::string text = fmt::format(
        "rack\n{0}PART/1,GROUND\nMARKER/10\nMARKER/11,REULER=90D,90D,0D\n"
        "PART/2,MASS=1,CM=20,IP={1},{1},{1},REULER=0.4,0,0\nMARKER/20\n"
        "PART/3,MASS={2},CM=30,IP=1,1,1,QG={3},{4},0\nMARKER/30,REULER=90D,90D,0D\n"
        "JOINT/1,REVOLUTE,I=20,J=10\nJOINT/2,TRANSLATIONAL,I=30,J=12\n"
        "MARKER/12,PART=1,QP=0,{4},0,REULER=90D,90D,0D\n"
        "JOINT/3,RACKPIN,PD={5},I=20,J=30\nSFORCE/1,ROTATIONAL,I=20,J=10,FUNCTION={6}\n"
        "REQUEST/1,F2=AZ(20,10)\\F3=DX(30)\nEND\n",
        u.statement, Inertia * u.m * u.m, Mass, 0.3 * u.m, -0.04 * u.m, 0.08 * u.m, Torque * u.m);
    const Table r = runFor(text, u, 2);
    const double angle = 2 * Torque / (Inertia + Mass * 0.04 * 0.04);
    EXPECT_NEAR(r.getColumn("R1.F2").back(), 0.4 + angle, Tolerance * angle);
    // The pinion travels +0.04 m per rad along the rack's z axis as the rack sees it: the rack goes back.
    EXPECT_NEAR(r.getColumn("R1.F3").back() / u.m, 0.3 - 0.04 * angle, Tolerance * angle);
}

}  // namespace
}  // namespace jprim
