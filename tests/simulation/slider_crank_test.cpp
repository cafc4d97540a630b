// SPDX-License-Identifier: Apache-2.0
// A slider-crank driven by a MOTION, solved without integration and with it, against the exact one.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "support/dataset_units.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using testing::buildOrFail;
using testing::DatasetUnits;

constexpr double Crank = 0.15, Rod = 0.4, Rate = 7;  // m, m, rad/s
constexpr double CrankInertia = 0.02, RodMass = 0.8, RodInertia = 0.011, SliderMass = 1.7;

// The crank turns about the ground's z axis, the rod's own turn about its length is held by the UNIVERSAL.
std::string makeSliderCrank(const DatasetUnits& u, double rodMass = RodMass, double crank = Crank) {
    const double r = crank * u.m, l = Rod * u.m, inertia = u.m * u.m;
    return fmt::format(
               "slider-crank\n{0}PART/1,GROUND\nMARKER/10\nMARKER/11,REULER=90D,90D,0D\n"
               "PART/2,MASS=1,CM=20,IP={1},{1},{1}\nMARKER/20\nMARKER/21,QP={2},0,0\n"
               "PART/3,MASS={3},CM=30,IP={4},{5},{5},QG={2},0,0\nMARKER/30,QP={6},0,0\nMARKER/31\n"
               "MARKER/32,QP={7},0,0,REULER=90D,90D,0D\n",
               u.statement, CrankInertia * inertia, r, rodMass, 0.002 * inertia, RodInertia * inertia, l / 2,
               l) +
           fmt::format(
               "PART/4,MASS={},CM=40,IP=1,1,1,QG={},0,0\nMARKER/40\nMARKER/41,REULER=90D,90D,0D\n"
               "MARKER/42,REULER=90D,90D,0D\n"
               "JOINT/1,REVOLUTE,I=20,J=10\nJOINT/2,SPHERICAL,I=31,J=21\nJOINT/3,HOOKE,I=32,J=42\n"
               "JOINT/4,TRANSLATIONAL,I=41,J=11\nMOTION/1,JOINT=1,FUNCTION={}*TIME\n"
               "REQUEST/1,F2=DX(40)\\F3=VX(40)\\F4=ACCX(40)\\F6=MOTION(1,0,8)\\F7=JOINT(4,0,3)\\F8=AZ(31)\n"
               "END\n",
               SliderMass, r + l, Rate / u.s);
}

SimulationOutcome runTurns(const DatasetUnits& u, SimulationKind kind, double rodMass = RodMass) {
    SimulationOptions options;
    options.kind = kind;
    options.end = 2 * u.s;
    options.steps = 50;
    options.accuracy = 1e-10;
    const Mechanism mechanism = buildOrFail(makeSliderCrank(u, rodMass));
    SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    EXPECT_EQ(outcome.failure, "");
    return outcome;
}

double calcTravel(double angle) {
    return Crank * std::cos(angle) + std::sqrt(Rod * Rod - std::pow(Crank * std::sin(angle), 2));
}

// Of f as a function of the crank's angle, by differences that err by about 1e-10.
template <class F>
double differentiate(const F& f, double angle) {
    constexpr double h = 1e-4;
    return (8 * (f(angle + h) - f(angle - h)) - (f(angle + 2 * h) - f(angle - 2 * h))) / (12 * h);
}

// What the masses are as one inertia at the crank: twice the kinetic energy at unit rate.
double calcReducedInertia(double angle) {
    const auto rodAngle = [](double a) { return -std::asin(Crank / Rod * std::sin(a)); };
    const auto rodX = [&](double a) { return Crank * std::cos(a) + Rod / 2 * std::cos(rodAngle(a)); };
    const auto rodY = [&](double a) { return Crank * std::sin(a) + Rod / 2 * std::sin(rodAngle(a)); };
    const auto square = [angle](const auto& f) { return std::pow(differentiate(f, angle), 2); };
    return CrankInertia + SliderMass * square(calcTravel) + RodMass * (square(rodX) + square(rodY)) +
           RodInertia * square(rodAngle);
}

// Differences within differences: 1e-7 of a torque of about 10 N m.
constexpr double TorqueTolerance = 1e-6, Tolerance = 1e-8;

class SliderCrank : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(SliderCrank);

double calcTorqueDeviation(const DatasetUnits& u, const Table& table) {
    const auto law = [](double t) { return Rate * Rate / 2 * differentiate(calcReducedInertia, Rate * t); };
    return testing::calcDeviation(table.getColumn("time"), u.s, table.getColumn("R1.F6"), u.m, law);
}

TEST_P(SliderCrank, MovesAsTheExactOne) {
    const SimulationOutcome outcome = runTurns(u, SimulationKind::Kinematics);
    EXPECT_TRUE(outcome.summary.isKinematic);
    EXPECT_EQ(outcome.summary.degreesOfFreedom, 0);
    EXPECT_EQ(outcome.summary.redundantEquations, 0);
    const Table& r = outcome.results.requests;
    const std::vector<double> time = r.getColumn("time");
    const auto travel = [](double t) { return calcTravel(Rate * t); };
    const auto velocity = [](double t) { return Rate * differentiate(calcTravel, Rate * t); };
    EXPECT_LE(testing::calcDeviation(time, u.s, r.getColumn("R1.F2"), u.m, travel), Tolerance);
    EXPECT_LE(testing::calcDeviation(time, u.s, r.getColumn("R1.F3"), u.m / u.s, velocity), Tolerance);
    EXPECT_LE(calcTorqueDeviation(u, r), TorqueTolerance);
}

// Without integration there is no error to be tolerated, whatever the accuracy.
TEST(SliderCrankKinematics, AreMetToRounding) {
    const Mechanism mechanism = buildOrFail(makeSliderCrank(testing::MetreSecond));
    const SimulationOutcome outcome = testing::run(mechanism, 2, 50, 1e-3);
    EXPECT_TRUE(outcome.summary.isKinematic);
    EXPECT_LE(outcome.summary.worstViolation.length, 1e-13);
    const Table& r = outcome.results.requests;
    const auto travel = [](double t) { return calcTravel(Rate * t); };
    EXPECT_LE(testing::calcDeviation(r.getColumn("time"), 1, r.getColumn("R1.F2"), 1, travel), 1e-13);
}

// Positions, velocities, accelerations and reactions: every column of every table.
TEST_P(SliderCrank, IntegrationAndKinematicsAgree) {
    const Results a = runTurns(u, SimulationKind::Kinematics).results;
    const Results b = runTurns(u, SimulationKind::Dynamics).results;
    for (const auto& [kinematic, dynamic] :
         {std::pair(&a.parts, &b.parts), std::pair(&a.requests, &b.requests),
          std::pair(&a.reactions, &b.reactions)}) {
        ASSERT_EQ(kinematic->values.size(), dynamic->values.size());
        for (size_t c = 0; c < kinematic->columns.size(); ++c) {
            const std::vector<double> x = kinematic->getColumn(kinematic->columns[c]),
                                      y = dynamic->getColumn(kinematic->columns[c]);
            double size = 1, difference = 0;
            for (size_t k = 0; k < x.size(); ++k) {
                size = std::max(size, std::abs(x[k]));
                difference = std::max(difference, std::abs(x[k] - y[k]));
            }
            EXPECT_LE(difference, 1e-6 * size) << kinematic->columns[c];
        }
    }
}

// Drawn as engineers draw it, with pins only, three equations say the same as others: the motion is as good. The
// tree keeps the loop in its plane without them.
TEST_P(SliderCrank, RedundantPinsChangeNothing) {
    std::string text = makeSliderCrank(u);
    text.replace(text.find("SPHERICAL,I=31,J=21"), 19, "REVOLUTE,I=31,J=21");
    text.replace(text.find("HOOKE,I=32,J=42"), 15,
                 "REVOLUTE,I=33,J=40\nMARKER/33,PART=3,QP=" + fmt::format("{},0,0", Rod * u.m));
    for (const auto& [formulation, redundant] :
         {std::pair(Formulation::Tree, 0), std::pair(Formulation::Constraints, 3)}) {
        const SimulationOutcome outcome = testing::run(buildOrFail(text, {formulation}), 2 * u.s, 50, 1e-10);
        EXPECT_TRUE(outcome.summary.isKinematic);
        EXPECT_EQ(outcome.summary.redundantEquations, redundant);
        const Table& r = outcome.results.requests;
        const auto travel = [](double t) { return calcTravel(Rate * t); };
        EXPECT_LE(testing::calcDeviation(r.getColumn("time"), u.s, r.getColumn("R1.F2"), u.m, travel),
                  Tolerance);
        EXPECT_LE(calcTorqueDeviation(u, r), TorqueTolerance);
    }
}

// A crank longer than the rod cannot go round: it locks where crank * sin = rod.
TEST_P(SliderCrank, LocksWhereTheRodIsTooShort) {
    constexpr double LongCrank = 0.5;
    const Mechanism mechanism = buildOrFail(makeSliderCrank(u, RodMass, LongCrank));
    SimulationOptions options;
    options.end = 0.5 * u.s;
    options.steps = 100;
    const SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    const double locked = std::asin(Rod / LongCrank) / Rate;
    EXPECT_NE(
        outcome.failure.find("the positions at the next time cannot be found; the mechanism may lock there"),
        std::string::npos)
        << outcome.failure;
    EXPECT_NEAR(outcome.finalState.getTime(), locked, 1e-3);
    EXPECT_LE(outcome.results.parts.getColumn("time").back(), locked * u.s);
}

TEST(SliderCrankMutated, OnePercentMoreRodIsNoticed) {
    const Results results =
        runTurns(testing::MetreSecond, SimulationKind::Kinematics, 1.01 * RodMass).results;
    EXPECT_GT(calcTorqueDeviation(testing::MetreSecond, results.requests), 1e-4);
}

}  // namespace
}  // namespace jprim
