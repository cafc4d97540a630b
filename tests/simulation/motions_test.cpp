// SPDX-License-Identifier: Apache-2.0
// What MOTIONs do: laws of time at three levels and in both forms, and the loads that they take.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "support/dataset_units.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Rotation;
using SimTK::Vec3;
using testing::buildOrFail;
using testing::calcDeviation;
using testing::DatasetUnits;
using testing::MetreSecond;

// Relative; far above the integrator's accuracy of 1e-10 over a few turns, far below any physical mistake.
constexpr double Accuracy = 1e-10, Tolerance = 1e-7;

class Motions : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(Motions);

SimulationOutcome runFor(const Mechanism& mechanism, const DatasetUnits& u, double seconds, int steps,
                         SimulationKind kind = SimulationKind::Automatic) {
    SimulationOptions options;
    options.kind = kind;
    options.end = seconds * u.s;
    options.steps = steps;
    options.accuracy = Accuracy;
    SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    EXPECT_EQ(outcome.failure, "");
    return outcome;
}

//------------------------------------------------------------------------------------- three levels
// A rotor that turns unevenly: theta = 0.25 + 3 t + 0.7 sin(2 t), four turns in 8 s.
constexpr double Inertia = 0.3;
double calcAngle(double t) {
    return 0.25 + 3 * t + 0.7 * std::sin(2 * t);
}
double calcRate(double t) {
    return 3 + 1.4 * std::cos(2 * t);
}
double calcAcceleration(double t) {
    return -2.8 * std::sin(2 * t);
}

std::string makeRotor(const DatasetUnits& u, const std::string& motion, double inertia = Inertia) {
    return fmt::format(
        "rotor\n{0}PART/1,GROUND\nMARKER/10,QP={1},{2},0,REULER=0.3,0.4,0.5\n"
        "PART/2,MASS=2,CM=20,IP={3},{4},{5},QG={1},{2},0,REULER=0.3,0.4,0.5\nMARKER/20\n"
        "JOINT/1,REVOLUTE,I=20,J=10\nMOTION/1,{6}\n"
        "REQUEST/1,F2=AZ(20,10)\\F3=WZ(20,10,10)\\F4=WDTZ(20,10,10,10)\\F6=MOTION(1,0,8,10)"
        "\\F7=MOTION(1,1,8,10)\\F8=JOINT(1,0,8,10)\nEND\n",
        u.statement, 0.4 * u.m, 0.7 * u.m, 0.2 * u.m * u.m, 0.24 * u.m * u.m, inertia * u.m * u.m, motion);
}

std::string makeDisplacement(const DatasetUnits& u) {
    return fmt::format("JOINT=1,FUNCTION=0.25+3*TIME/{0}+0.7*SIN(2*TIME/{0})", u.s);
}

double calcWorstDeviation(const DatasetUnits& u, const Table& table) {
    const std::vector<double> time = table.getColumn("time");
    const auto compare = [&](const char* name, double unit, auto law) {
        return calcDeviation(time, u.s, table.getColumn(name), unit, law);
    };
    const auto torque = [](double t) { return Inertia * calcAcceleration(t); };
    return std::max({compare("R1.F2", 1, calcAngle), compare("R1.F3", 1 / u.s, calcRate),
                     compare("R1.F4", 1 / u.s / u.s, calcAcceleration), compare("R1.F6", u.m, torque),
                     compare("R1.F7", -u.m, torque), compare("R1.F8", u.m, [](double) { return 0; })});
}

TEST_P(Motions, ADisplacementIsFollowedWithoutIntegration) {
    const SimulationOutcome outcome = runFor(buildOrFail(makeRotor(u, makeDisplacement(u))), u, 8, 40);
    EXPECT_TRUE(outcome.summary.isKinematic);
    EXPECT_LE(calcWorstDeviation(u, outcome.results.requests), Tolerance);
}

TEST_P(Motions, ADisplacementIsFollowedByIntegration) {
    const SimulationOutcome outcome =
        runFor(buildOrFail(makeRotor(u, makeDisplacement(u))), u, 8, 40, SimulationKind::Dynamics);
    EXPECT_FALSE(outcome.summary.isKinematic);
    EXPECT_LE(calcWorstDeviation(u, outcome.results.requests), Tolerance);
}

TEST_P(Motions, AVelocityIsIntegratedFromIcdisp) {
    const std::string motion =
        fmt::format("JOINT=1,VELOCITY,ICDISP=0.25,FUNCTION=(3+1.4*COS(2*TIME/{0}))/{0}", u.s);
    const SimulationOutcome outcome = runFor(buildOrFail(makeRotor(u, motion)), u, 8, 40);
    EXPECT_FALSE(outcome.summary.isKinematic);
    EXPECT_LE(calcWorstDeviation(u, outcome.results.requests), Tolerance);
}

TEST_P(Motions, AnAccelerationIsIntegratedFromIcdispAndIcvel) {
    const std::string motion =
        fmt::format("I=20,J=10,B3,ACCELERATION,ICDISP=0.25,ICVEL={0},FUNCTION=-2.8*SIN(2*TIME/{1})/{1}**2",
                    4.4 / u.s, u.s);
    const SimulationOutcome outcome = runFor(buildOrFail(makeRotor(u, motion)), u, 8, 40);
    EXPECT_LE(calcWorstDeviation(u, outcome.results.requests), Tolerance);
}

TEST(MotionsMutated, OnePercentMoreInertiaIsNoticed) {
    const std::string text = makeRotor(MetreSecond, makeDisplacement(MetreSecond), 1.01 * Inertia);
    const SimulationOutcome outcome = runFor(buildOrFail(text), MetreSecond, 8, 40);
    EXPECT_GT(calcWorstDeviation(MetreSecond, outcome.results.requests), 1e-3);
}

// One step of output may be a whole turn: the kinematic solution takes smaller ones.
TEST(Motions, WholeTurnsBetweenOutputsAreCounted) {
    const std::string text = makeRotor(MetreSecond, "JOINT=1,FUNCTION=4*PI*TIME");
    const SimulationOutcome outcome = runFor(buildOrFail(text), MetreSecond, 6, 6);
    EXPECT_NEAR(outcome.results.requests.getColumn("R1.F2").back(), 24 * SimTK::Pi, 1e-8);
}

TEST(Motions, KinematicsAreRefusedWhereSomethingIsFree) {
    const Mechanism mechanism = buildOrFail(makeRotor(MetreSecond, "JOINT=1,VELOCITY,FUNCTION=2"));
    SimulationOptions options;
    options.end = 1;
    options.kind = SimulationKind::Kinematics;
    EXPECT_THROW(simulate(mechanism, assemble(mechanism), options), std::exception);
}

//------------------------------------------------------------------------------- between two markers
// All six components of marker 21 in marker 10. What moves the part is what Newton and Euler demand at the mass
// centre; a part with equal moments of inertia has no gyroscopic torque.
TEST_P(Motions, SixComponentsPlaceAPart) {
    const auto law = [this](double amplitude, double rate) {
        return fmt::format("{}*SIN({}*TIME/{})", amplitude, rate, u.s);
    };
    const std::string text =
        fmt::format("six\n{}PART/1,GROUND\nMARKER/10,QP={},0,0,REULER=0.3,0.4,0.5\n", u.statement,
                    0.2 * u.m) +
        fmt::format("PART/2,MASS=3,CM=20,IP={0},{0},{0},QG={1},0,0,REULER=0.3,0.4,0.5\nMARKER/21\n",
                    0.4 * u.m * u.m, 0.2 * u.m) +
        fmt::format("MARKER/20,QP={},{},{}\n", 0.1 * u.m, 0.2 * u.m, -0.3 * u.m) +
        "MOTION/1,I=21,J=10,X,FUNCTION=" + law(0.5 * u.m, 1.1) +
        "\nMOTION/2,I=21,J=10,Y,FUNCTION=" + law(-0.3 * u.m, 1.3) +
        "\nMOTION/3,I=21,J=10,Z,FUNCTION=" + law(0.2 * u.m, 0.7) +
        "\nMOTION/4,I=21,J=10,B1,FUNCTION=" + law(2, 0.6) +
        "\nMOTION/5,I=21,J=10,B2,FUNCTION=" + law(0.9, 0.8) +
        "\nMOTION/6,I=21,J=10,B3,FUNCTION=" + law(-3, 0.9) +
        "\nREQUEST/1,FORCE,I=21,J=10\nREQUEST/2,ACCELERATION,I=20\nREQUEST/3,DISPLACEMENT,I=20,J=21\n"
        "REQUEST/4,F2=DX(21,10,10)\\F3=ACCX(21,10,10,10)\\F4=DZ(21,10,10)\\F6=PSI(21,10)\\F7=THETA(21,10)\n"
        "END\n";
    const Table r = runFor(buildOrFail(text), u, 5, 25).results.requests;
    const auto get = [&r](const char* name, size_t row) { return r.getColumn(name)[row]; };
    const auto getVector = [&](const std::string& prefix, const char* x, const char* y, const char* z,
                               size_t row) {
        return Vec3(get((prefix + x).c_str(), row), get((prefix + y).c_str(), row),
                    get((prefix + z).c_str(), row));
    };
    for (size_t k = 0; k < r.getNumRows(); ++k) {
        const double t = get("time", k) / u.s;
        EXPECT_NEAR(get("R4.F2", k) / u.m, 0.5 * std::sin(1.1 * t), Tolerance);
        EXPECT_NEAR(get("R4.F3", k) * u.s * u.s / u.m, -0.5 * 1.21 * std::sin(1.1 * t), Tolerance);
        EXPECT_NEAR(get("R4.F4", k) / u.m, 0.2 * std::sin(0.7 * t), Tolerance);
        const Rotation R(SimTK::BodyRotationSequence, 2 * std::sin(0.6 * t), SimTK::XAxis,
                         0.9 * std::sin(0.8 * t), SimTK::YAxis, -3 * std::sin(0.9 * t), SimTK::ZAxis);
        EXPECT_NEAR(std::cos(get("R4.F7", k)), R[2][2], Tolerance);

        const Vec3 force = getVector("R1.", "FX", "FY", "FZ", k);
        const Vec3 torque = getVector("R1.", "TX", "TY", "TZ", k) / u.m;
        const Vec3 acceleration = getVector("R2.", "ACCX", "ACCY", "ACCZ", k) * u.s * u.s / u.m;
        const Vec3 turning = getVector("R2.", "WDTX", "WDTY", "WDTZ", k) * u.s * u.s;
        const Vec3 lever = getVector("R3.", "X", "Y", "Z", k) / u.m;  // from the marker to the mass centre
        EXPECT_LT((force - 3 * acceleration).norm(), 20 * Tolerance);
        EXPECT_LT((torque - lever % force - 0.4 * turning).norm(), 20 * Tolerance);
    }
}

}  // namespace
}  // namespace jprim
