// SPDX-License-Identifier: Apache-2.0
// What a run integrates beside the motion: the work of loads without a potential, which is what the energy changes by.
#include <gtest/gtest.h>

#include "jprim/jprim.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

const std::string Pendulum =
    "t\nUNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=SECOND\nACCGRAV/JGRAV=-9810\n"
    "PART/1,GROUND\nMARKER/10\nMARKER/11,QP=900,-300,0\n"
    "PART/2,MASS=2,CM=20,IP=3E4,5E4,4E4\nMARKER/20,QP=300,100,20\nMARKER/21\nMARKER/22,QP=500,0,0\n";

struct Case {
    const char* name;
    const char* elements;
    double work;  // the least that it gains, or loses if negative [J]; 0 if either
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

// A MOTION of each level, a velocity that a GCON keeps, and forces that brake, drive and come and go.
const Case Cases[] = {
    {"Damper", "JOINT/1,REVOLUTE,I=21,J=10\nSPRINGDAMPER/1,TRANSLATION,I=22,J=11,C=0.002,K=0.1,LENGTH=400\n",
     -0.1},
    {"Brake", "JOINT/1,SPHERICAL,I=21,J=10\nSFORCE/1,ROTATION,I=21,J=10,FUNCTION=-300*WZ(21,10,10)\n", -0.1},
    {"Bushing", "BUSHING/1,I=21,J=10,K=9,9,9,C=0.04,0.04,0.04,KT=3E5,3E5,3E5,CT=3E3,3E3,3E3\n", -0.05},
    {"Drive",
     "JOINT/1,REVOLUTE,I=21,J=10\nSFORCE/1,ROTATION,I=21,J=10,FUNCTION=9000*STEP(TIME,0.2,0,0.4,1)\n", 1},
    {"Motion", "JPRIM/1,ATPOINT,I=21,J=10\nMOTION/1,Y,I=22,J=10,FUNCTION=200*SIN(2*TIME)\n", 0},
    {"MotionOfVelocity",
     "JPRIM/1,ATPOINT,I=21,J=10\nMOTION/1,Y,I=22,J=10,VELOCITY,FUNCTION=-300*SIN(3*TIME)\n", 0},
    {"MotionOfAcceleration",
     "JPRIM/1,ATPOINT,I=21,J=10\nMOTION/1,Y,I=22,J=10,ACCELERATION,FUNCTION=400*COS(5*TIME)\n", 0},
    {"Velocity", "JPRIM/1,ATPOINT,I=21,J=10\nGCON/1,I=21,FUNCTION=WZ(21,10,10)-1-TIME\n", 0}};

class EnergyBalance : public ::testing::TestWithParam<std::tuple<Case, Formulation>> {};

TEST_P(EnergyBalance, IsKept) {
    constexpr double OfAccuracy = 1e-5;  // of the kinetic energy's range, at an accuracy of 1e-8
    const auto& [c, formulation] = GetParam();
    const Mechanism mechanism = testing::buildOrFail(Pendulum + c.elements + "END\n", {formulation});
    ASSERT_FALSE(mechanism.isConservative());
    const SimulationSummary summary = testing::run(mechanism, 1, 20, 1e-8).summary;
    EXPECT_FALSE(summary.isKinematic);
    EXPECT_LT(summary.largestImbalance, OfAccuracy * summary.energyScale);
    EXPECT_GT(summary.largestImbalance, 0);
    EXPECT_GT(summary.largestEnergyChange, 0.01 * summary.energyScale);
    const double change = summary.energyAtEnd - summary.energyAtStart;
    if (c.work != 0) {
        EXPECT_GE(change / c.work, 1);
    }
}

INSTANTIATE_TEST_SUITE_P(Elements, EnergyBalance,
                         ::testing::Combine(::testing::ValuesIn(Cases),
                                            ::testing::Values(Formulation::Tree, Formulation::Constraints)),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param).name) +
                                    (std::get<1>(info.param) == Formulation::Tree ? "Tree" : "Constraints");
                         });

// Twins, of which one has a force of nothing: the same steps, and a balance that is the energy.
class BalanceOfIntegrators : public ::testing::TestWithParam<std::string> {};

TEST_P(BalanceOfIntegrators, ChangesNoStepAndTellsTheErrorOfTheEnergy) {
    const auto simulateWith = [](const std::string& force) {
        const std::string spring =
            "JOINT/1,REVOLUTE,I=21,J=10\nSPRINGDAMPER/1,TRANSLATION,I=22,J=11,K=9,LENGTH=300\n";
        const Mechanism mechanism = testing::buildOrFail(Pendulum + spring + force + "END\n");
        SimulationOptions options;
        options.end = 1;
        options.steps = 4;
        options.accuracy = 1e-4;
        options.integrator = GetParam();
        return simulate(mechanism, assemble(mechanism), options);
    };
    const SimulationOutcome conservative = simulateWith("");
    const SimulationOutcome other = simulateWith("SFORCE/1,ROTATION,I=21,J=10,FUNCTION=0*TIME\n");
    const double error = conservative.summary.largestEnergyChange;
    EXPECT_EQ(conservative.summary.largestImbalance, error);
    EXPECT_GT(error, 0);
    if (GetParam() == "CPodes") {  // averages its errors over one more variable
        EXPECT_LT(other.summary.stepsTaken, 1.1 * conservative.summary.stepsTaken);
        EXPECT_LT(other.summary.largestImbalance, 10 * error);
    } else {
        EXPECT_EQ(other.summary.stepsTaken, conservative.summary.stepsTaken);
        EXPECT_NEAR(other.summary.largestImbalance, error, 1e-6 * error);
    }
}

INSTANTIATE_TEST_SUITE_P(All, BalanceOfIntegrators, ::testing::ValuesIn(getIntegratorNames()),
                         [](const auto& info) { return info.param; });

// Next to rest there is no range to hold the energy against, and speeds are as small as the accuracy.
TEST(EnergyBalanceAtRest, IsTolerable) {
    const std::string elements = std::string(Cases[0].elements) + "END\n";
    const Mechanism mechanism = testing::buildOrFail(Pendulum + elements);
    SimulationOptions options;
    options.end = 10;
    options.steps = 10;
    for (const double accuracy : {1e-4, 1e-6}) {
        options.accuracy = accuracy;
        AssembledState initial = assemble(mechanism);
        initial.state = findEquilibrium(mechanism, initial.state);
        const SimulationSummary summary = simulate(mechanism, initial, options).summary;
        EXPECT_LT(summary.largestImbalance, summary.tolerableImbalance) << accuracy;
        EXPECT_LT(summary.tolerableImbalance, 10 * accuracy) << accuracy;
    }
}

// The balance can fail: steps too long for the accuracy of the brake's work show in it.
TEST(EnergyBalanceMutant, CoarseStepsAreNoticed) {
    const Mechanism mechanism = testing::buildOrFail(Pendulum + Cases[1].elements + "END\n");
    const SimulationSummary summary = testing::run(mechanism, 10, 1, 0.05).summary;
    EXPECT_GT(summary.largestImbalance, 1e-3 * summary.energyScale);
}

}  // namespace
}  // namespace jprim
