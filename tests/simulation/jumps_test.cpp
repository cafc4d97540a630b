// SPDX-License-Identifier: Apache-2.0
// What no motion follows - a force that jumps where a mechanism can go to neither side, a MOTION that jumps or has a kink -
// ends a run with its name; what only looks like it does not.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "jprim/jprim.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

SimulationOutcome simulateWith(const std::string& text, double end, const std::string& integrator,
                               Formulation formulation = Formulation::Tree) {
    const Mechanism mechanism = testing::buildOrFail(text, {formulation});
    SimulationOptions options;
    options.end = end;
    options.steps = 10;
    options.integrator = integrator;
    return simulate(mechanism, assemble(mechanism), options);
}

// Slides at 1.1 m/s, and is braked by 2.3 m/s^2.
std::string writeSliding(const std::string& friction, double speed = 1.1) {
    return fmt::format(
        "slide\nPART/1,GROUND\nMARKER/1,REULER=90D,90D,0\nPART/2,MASS=1.9,CM=20,IP=1,1,1,VX={}\nMARKER/20\n"
        "MARKER/21,REULER=90D,90D,0\nJOINT/1,TRANSLATIONAL,I=21,J=1\n"
        "SFORCE/3,TRANSLATION,ACTIONONLY,I=21,J=1,FUNCTION={}\nEND\n",
        speed, friction);
}

class Jumps : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Integrators, Jumps,
                         ::testing::Values("RungeKuttaMerson", "RungeKutta3", "Verlet", "CPodes"),
                         [](const auto& info) { return info.param; });

TEST_P(Jumps, OfFrictionAtRestAreNamed) {
    for (const char* friction :
         {"-SIGN(4.37,VZ(21,1,1))", "-4.37*VZ(21,1,1)/ABS(VZ(21,1,1))", "IF(VZ(21,1,1):4.37,0,-4.37)"}) {
        const SimulationOutcome outcome = simulateWith(writeSliding(friction), 1.3, GetParam());
        EXPECT_NE(outcome.failure.find("SFORCE/3: its function jumps"), std::string::npos) << friction << "\n"
                                                                                           << outcome.failure;
        EXPECT_GE(outcome.results.parts.getNumRows(), 4u);  // to 0.39; it rests at 0.478
        EXPECT_LT(outcome.results.parts.getNumRows(), 10u);
    }
}

// SIGN has no branch for zero, so that rest is on one of its sides.
TEST(JumpsAtTheStart, OfFrictionAtRestAreNamed) {
    for (const std::string& integrator : getIntegratorNames()) {
        const std::string failure =
            simulateWith(writeSliding("-SIGN(4.37,VZ(21,1,1))", 0), 1.3, integrator).failure;
        EXPECT_NE(failure.find("SFORCE/3: its function jumps"), std::string::npos) << integrator << "\n"
                                                                                   << failure;
    }
}

TEST(UndefinedForces, AreNamed) {
    for (const std::string& integrator : getIntegratorNames())
        for (const char* function : {"SQRT(0.31-TIME)", "LOG(0.31-TIME)", "ASIN(TIME/0.31)",
                                     "VZ(21,1,1)/ABS(VZ(21,1,1)-VZ(21,1,1))", "SQRT(0.3-DZ(21,1,1))"}) {
            const std::string failure = simulateWith(writeSliding(function), 1.3, integrator).failure;
            EXPECT_EQ(failure.find("at time 0"), 0u) << function << failure;
            EXPECT_NE(failure.find("SFORCE/3: its function is infinite or not a number here"),
                      std::string::npos)
                << integrator << " " << function << "\n"
                << failure;
        }
}

// Before it comes to rest, and smoothed.
TEST_P(Jumps, OfWhatGoesOnAreNone) {
    EXPECT_EQ(simulateWith(writeSliding("-SIGN(4.37,VZ(21,1,1))"), 0.47, GetParam()).failure, "");
    EXPECT_EQ(simulateWith(writeSliding("-4.37*TANH(VZ(21,1,1)/0.003)"), 1, GetParam()).failure, "");
}

std::string writeDriven(const std::string& function) {
    return "driven\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.03,0.05,0.04\n"
           "MARKER/20,QP=0.3,0.1,0.02\nMARKER/21\nMARKER/22,QP=1,0,0\nJOINT/1,REVOLUTE,I=21,J=10\n"
           "PART/3,MASS=1,CM=30,IP=0.03,0.05,0.04,QG=1,0,0\nMARKER/30,QP=0.2,0,0\nMARKER/31\n"
           "JOINT/2,REVOLUTE,I=31,J=22\nMOTION/7,JOINT=1,FUNCTION=" +
           function + "\nEND\n";
}

TEST(MotionJumps, AreNamed) {
    for (const auto& [function, what] :
         {std::pair("MAX(0,0.3*(TIME-0.437))", "velocity"),
          std::pair("0.2*ABS(SIN(3.2*TIME-1.3984))", "velocity"),
          std::pair("IF(TIME-0.437:0.1,0.1,0.2)", "position"), std::pair("MOD(TIME,0.437)", "position")})
        for (const char* integrator : {"RungeKuttaMerson", "CPodes"})
            for (const Formulation formulation : {Formulation::Tree, Formulation::Constraints}) {
                const std::string failure =
                    simulateWith(writeDriven(function), 1, integrator, formulation).failure;
                EXPECT_EQ(failure.find("at time 0.437"), 0u) << failure;
                EXPECT_NE(failure.find(std::string("MOTION/7: its function jumps in ") + what),
                          std::string::npos)
                    << failure;
            }
}

// From the start on, and where it ends.
TEST(MotionJumps, AtAnEndAreNamed) {
    for (const std::string& integrator : getIntegratorNames())
        for (const auto& [function, text] :
             {std::pair("IF(TIME:0,0,0.1)",
                        "at time 0: the simulation cannot go on: MOTION/7: its function jumps in position"),
              std::pair("MAX(0,TIME)",
                        "at time 0: the simulation cannot go on: MOTION/7: its function jumps in velocity"),
              std::pair("ABS(TIME)",
                        "at time 0: the simulation cannot go on: MOTION/7: its function jumps in velocity"),
              std::pair("IF(TIME-1:0,0.1,0.1)",
                        "at time 1: the simulation cannot go on: MOTION/7: its function jumps in position"),
              std::pair("SQRT(0.31-TIME)", "MOTION/7: its function has no finite value here")}) {
            const std::string failure = simulateWith(writeDriven(function), 1, integrator).failure;
            EXPECT_NE(failure.find(text), std::string::npos) << integrator << "\n" << failure;
        }
    EXPECT_EQ(simulateWith(writeDriven("IF(TIME-1:0,0,0.1)"), 1, "RungeKuttaMerson").failure, "");
}

// Where nothing is free, kinks do no harm.
TEST(MotionJumps, InKinematics) {
    const auto run = [](const std::string& function) {
        std::string text = writeDriven(function);
        return simulateWith(text.erase(text.find("JOINT/2"), text.find("MOTION") - text.find("JOINT/2"))
                                .insert(text.find("MOTION"), "JOINT/2,FIXED,I=31,J=22\n"),
                            1, "RungeKuttaMerson");
    };
    for (const char* function : {"IF(TIME-0.437:0,0,1)", "IF(TIME-0.437:0.1,0.1,0.11)", "MOD(TIME,0.437)"}) {
        const SimulationOutcome outcome = run(function);
        EXPECT_TRUE(outcome.summary.isKinematic);
        EXPECT_EQ(outcome.failure.find(
                      "at time 0.437: the simulation cannot go on: MOTION/7: its function jumps in position"),
                  0u)
            << outcome.failure;
    }
    EXPECT_EQ(run("IF(TIME-0.5:0,0,1)").failure.find("at time 0.5:"), 0u);
    for (const char* function : {"0.3*ABS(TIME-0.437)", "0.3*ABS(TIME-0.5)", "0.3*MAX(0,TIME-0.437)"}) {
        const SimulationOutcome outcome = run(function);
        EXPECT_EQ(outcome.failure, "");
        EXPECT_NEAR(outcome.results.parts.getColumn("PART/2.WZ").back(), 0.3, 1e-12);
        EXPECT_NEAR(outcome.results.parts.getColumn("PART/2.WZ").front(), function[4] == 'A' ? -0.3 : 0,
                    1e-12);
    }
}

// A jump of the acceleration is no harm, and no step has both sides of it.
TEST(MotionJumps, OfAccelerationsAreNone) {
    const SimulationOutcome outcome =
        simulateWith(writeDriven("0.8*MAX(0,TIME-0.437)**2"), 1, "RungeKuttaMerson");
    EXPECT_EQ(outcome.failure, "");
    EXPECT_LT(outcome.summary.stepsTaken, 60);
}

}  // namespace
}  // namespace jprim
