// SPDX-License-Identifier: Apache-2.0
// Coordinates given at the start by joints and motions: IC, ICTRAN, ICROT, ICDISP, ICVEL.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "support/dataset_units.h"
#include "support/expect_error.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using testing::buildOrFail;
using testing::DatasetUnits;
using testing::MetreSecond;

// Of assembly, in metres and radians.
constexpr double Tolerance = 1e-8;

class InitialCoordinates : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(InitialCoordinates);

// The functions of REQUEST/1 at the start.
std::vector<double> findAtStart(const std::string& text, const DatasetUnits& u) {
    const Results results = testing::run(buildOrFail(text), 0.01 * u.s, 1, 1e-8).results;
    std::vector<double> values;
    for (size_t c = 1; c < results.requests.columns.size(); ++c)
        values.push_back(results.requests.getValue(0, c));
    return values;
}

// A part on a tilted axis, given turned by `turn` about it and shifted along it.
std::string makePart(const DatasetUnits& u, double turn, const std::string& statements) {
    return fmt::format(
        "part\n{0}PART/1,GROUND\nMARKER/10,QP={1},0,0,REULER=0.3,0.4,0.5\n"
        "PART/2,MASS=2,CM=20,IP={2},{2},{3},QG={1},0,0,REULER=0.3,0.4,{4}\nMARKER/20\n{5}"
        "REQUEST/1,F2=AZ(20,10)\\F3=WZ(20,10,10)\\F4=DZ(20,10,10)\\F6=VZ(20,10,10,10)\nEND\n",
        u.statement, 0.7 * u.m, 0.1 * u.m * u.m, 0.2 * u.m * u.m, 0.5 + turn, statements);
}

TEST_P(InitialCoordinates, OfARevolute) {
    const auto values =
        findAtStart(makePart(u, 0.2, fmt::format("JOINT/1,REVOLUTE,I=20,J=10,IC=75D,{}\n", -3 / u.s)), u);
    EXPECT_NEAR(values[0], 75 * SimTK::Pi / 180, Tolerance);
    EXPECT_NEAR(values[1] * u.s, -3, Tolerance);
    EXPECT_NEAR(values[2] / u.m, 0, Tolerance);
}

TEST_P(InitialCoordinates, OfATranslational) {
    const auto values = findAtStart(
        makePart(u, 0, fmt::format("JOINT/1,TRANSLATIONAL,I=20,J=10,IC={},{}\n", 0.4 * u.m, 1.5 * u.m / u.s)),
        u);
    EXPECT_NEAR(values[0], 0, Tolerance);
    EXPECT_NEAR(values[2] / u.m, 0.4, Tolerance);
    EXPECT_NEAR(values[3] * u.s / u.m, 1.5, Tolerance);
}

TEST_P(InitialCoordinates, OfACylindrical) {
    const auto values =
        findAtStart(makePart(u, -0.4,
                             fmt::format("JOINT/1,CYLINDRICAL,I=20,J=10,ICTRAN={},{},ICROT=-0.8,{}\n",
                                         -0.3 * u.m, 0.6 * u.m / u.s, 2 / u.s)),
                    u);
    EXPECT_NEAR(values[0], -0.8, Tolerance);
    EXPECT_NEAR(values[1] * u.s, 2, Tolerance);
    EXPECT_NEAR(values[2] / u.m, -0.3, Tolerance);
    EXPECT_NEAR(values[3] * u.s / u.m, 0.6, Tolerance);
}

// Without a second number nothing is said of the velocity, and what the part says counts.
TEST_P(InitialCoordinates, ADisplacementAloneLeavesTheVelocityToThePart) {
    std::string text = makePart(u, 0.2, "JOINT/1,REVOLUTE,I=20,J=10,IC=0.9\n");
    text.replace(text.find(",QG="), 4, fmt::format(",WZ={},QG=", 4 / u.s));
    const auto values = findAtStart(text, u);
    EXPECT_NEAR(values[0], 0.9, Tolerance);
    EXPECT_NEAR(values[1] * u.s, 4, Tolerance);
}

TEST_P(InitialCoordinates, OfAMotion) {
    const auto values = findAtStart(
        makePart(u, 0.1,
                 fmt::format("JOINT/1,CYLINDRICAL,I=20,J=10\n"
                             "MOTION/1,JOINT=1,TRANSLATION,ACCELERATION,ICDISP={},ICVEL={},FUNCTION=0\n"
                             "MOTION/2,JOINT=1,ROTATION,VELOCITY,ICDISP=1.1,FUNCTION={}\n",
                             0.25 * u.m, -0.5 * u.m / u.s, 5 / u.s)),
        u);
    EXPECT_NEAR(values[0], 1.1, Tolerance);
    EXPECT_NEAR(values[1] * u.s, 5, Tolerance);
    EXPECT_NEAR(values[2] / u.m, 0.25, Tolerance);
    EXPECT_NEAR(values[3] * u.s / u.m, -0.5, Tolerance);
}

// A double pendulum given straight is assembled bent, and its parts have the velocities that the two rates give.
TEST_P(InitialCoordinates, OfAChain) {
    const double m = u.m;
    const std::string text =
        fmt::format(
            "chain\n{0}PART/1,GROUND\nMARKER/10\nPART/2,MASS=1,CM=20,IP={1},{1},{1}\nMARKER/20,QP={2},0,0\n"
            "MARKER/21\nMARKER/22,QP={3},0,0\nPART/3,MASS=2,CM=30,IP={1},{1},{1},QG={3},0,0\nMARKER/30,QP={4},0,0\n"
            "MARKER/31\n",
            u.statement, 0.02 * m * m, 0.2 * m, 0.5 * m, 0.3 * m) +
        fmt::format(
            "JOINT/1,REVOLUTE,I=21,J=10,IC=40D,{}\nJOINT/2,REVOLUTE,I=31,J=22,IC=-110D,{}\n"
            "REQUEST/1,F2=DX(30)\\F3=DY(30)\\F4=VX(30)\\F6=VY(30)\\F7=WZ(30)\nEND\n",
            2 / u.s, -7 / u.s);
    const auto v = findAtStart(text, u);
    const double a = 40 * SimTK::Pi / 180, b = -70 * SimTK::Pi / 180;
    EXPECT_NEAR(v[0] / m, 0.5 * std::cos(a) + 0.3 * std::cos(b), Tolerance);
    EXPECT_NEAR(v[1] / m, 0.5 * std::sin(a) + 0.3 * std::sin(b), Tolerance);
    EXPECT_NEAR(v[2] * u.s / m, -0.5 * 2 * std::sin(a) + 0.3 * 5 * std::sin(b), Tolerance);
    EXPECT_NEAR(v[3] * u.s / m, 0.5 * 2 * std::cos(a) - 0.3 * 5 * std::cos(b), Tolerance);
    EXPECT_NEAR(v[4] * u.s, -5, Tolerance);
}

TEST(InitialCoordinatesMutated, AHundredthOfADegreeIsNoticed) {
    const auto values =
        findAtStart(makePart(MetreSecond, 0.2, "JOINT/1,REVOLUTE,I=20,J=10,IC=75.01D\n"), MetreSecond);
    EXPECT_GT(std::abs(values[0] - 75 * SimTK::Pi / 180), 1000 * Tolerance);
}

// EXACT yields to an IC, on one line 0.4 m along z.
TEST_P(InitialCoordinates, WinAgainstExact) {
    std::string text = makePart(u, 0.2, fmt::format("JOINT/1,TRANSLATIONAL,I=20,J=10,IC={}\n", 0.4 * u.m));
    text.replace(text.find(",QG="), 4, ",EXACT=X:Y:Z,QG=");
    const Mechanism mechanism = buildOrFail(text);
    const AssembledState assembled = assemble(mechanism);
    const double metre = 1 / mechanism.getLengthUnit();
    EXPECT_NEAR(mechanism.getInitialCoordinates()[0].coordinate.calcValue(assembled.state), 0.4 * metre,
                Tolerance * metre);
    ASSERT_EQ(assembled.yielded.size(), 3u);
    double sum = 0;
    for (const MissedCoordinate& missed : assembled.yielded) {
        EXPECT_EQ(missed.element, "PART/2");
        EXPECT_EQ(missed.dimension, Dimension::Length);
        sum += missed.amount * missed.amount;
    }
    EXPECT_EQ(assembled.yielded[0].coordinate, "EXACT Z");
    EXPECT_NEAR(std::sqrt(sum), 0.4 * metre, Tolerance * metre);
}

TEST_P(InitialCoordinates, AgainstAMotionAreAnError) {
    const std::string text = makePart(
        u, 0.2,
        fmt::format("JOINT/1,REVOLUTE,I=20,J=10,IC=0.5\nMOTION/1,JOINT=1,FUNCTION=0.2+TIME/{}\n", u.s));
    EXPECT_EQ(
        testing::catchError([&] { assemble(buildOrFail(text)); }),
        "JOINT/1: its initial value contradicts the constraints or other given coordinates; the nearest that can "
        "be assembled misses it by 0.3 rad");
}

// Parallelograms with three rockers, parts up to 0.6 rad out of place. The first is met by going along the equations
// only, the second beyond a dead point near which the equations alone are met.
TEST(InitialAngles, AreReachedFromFarAway) {
    for (const auto& [name, angle] :
         {std::pair("three_rockers_a.adm", 0.2), std::pair("three_rockers_b.adm", -0.03590622423542289)}) {
        const Mechanism mechanism = testing::buildFileOrFail(testing::getDataFolder() + "assembly/" + name);
        const AssembledState assembled = assemble(mechanism);
        EXPECT_NEAR(mechanism.getRequests()[0].functions[0].second.calcValue(assembled.state), angle,
                    Tolerance);
        EXPECT_LT(std::max(assembled.after.length, assembled.after.angle), Tolerance);
    }
}

// Both drive the same joint, from the same angle but not as fast.
TEST_P(InitialCoordinates, TwoMotionsThatDisagreeOnVelocityAreAnError) {
    const std::string text =
        makePart(u, 0,
                 fmt::format("JOINT/1,REVOLUTE,I=20,J=10\nMOTION/1,JOINT=1,FUNCTION=0.2*TIME/{0}\n"
                             "MOTION/2,I=20,J=10,B3,FUNCTION=0.3*TIME/{0}\n",
                             u.s));
    const std::string error = testing::catchError([&] { assemble(buildOrFail(text)); });
    EXPECT_NE(error.find("MOTION/"), std::string::npos) << error;
    EXPECT_NE(
        error.find(": no velocities at the start satisfy it together with the other constraints; 0.05 length "
                   "units/s or rad/s of it are left"),
        std::string::npos)
        << error;
}

}  // namespace
}  // namespace jprim
