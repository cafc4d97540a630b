// SPDX-License-Identifier: Apache-2.0
// Control systems in runs of all kinds: statics, commands, restarts, sensors that evaluate, what cannot be run.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"
#include "jprim/simulation/equilibrium.h"
#include "jprim/simulation/run_commands.h"
#include "support/dataset_units.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using testing::buildOrFail;

// A mass on a vertical slide, pushed by statements; 10 m/s^2 pull it down.
std::string makeSlide(const std::string& statements) {
    return "slide\nACCGRAV/KGRAV=-10\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20\n"
           "JOINT/1,TRANSLATIONAL,I=20,J=10\n" +
           statements + "\nEND\n";
}

const char* const Controller =
    "VARIABLE/1,FUNCTION=0.3-DZ(20)\nDIFF/1,FUNCTION=VARVAL(1)\nDIFF/2,FUNCTION=(VARVAL(1)-DIF(2))/0.1\n"
    "SFORCE/1,TRANSLATIONAL,ACTIONONLY,I=20,J=10,FUNCTION=40*VARVAL(1)+50*DIF(1)+8*DIF1(2)\n"
    "REQUEST/1,F2=DIF(1)\\F3=DIF(2)\\F4=DZ(20)";

CommandsOutcome runCommandsOf(const std::string& dataset, const std::string& commands) {
    Diagnostics diagnostics;
    const CommandFile file = readCommands("model\n\n" + commands, diagnostics);
    const Mechanism mechanism = buildOrFail(dataset);
    SimulationOptions options;
    options.accuracy = 1e-8;
    const CommandsOutcome outcome = runCommands(mechanism, file.commands, options);
    EXPECT_EQ(outcome.failure, "");
    return outcome;
}

double evaluate(const Mechanism& mechanism, const SimTK::State& state, size_t function) {
    return mechanism.getRequests()[0].functions[function].second.calcValue(state);
}

TEST(ControlCommands, StatesGoOnFromOneSimulateToTheNext) {
    const CommandsOutcome whole =
        runCommandsOf(makeSlide(Controller), "SIMULATE/DYNAMICS, END=1, STEPS=10\n");
    const CommandsOutcome parts =
        runCommandsOf(makeSlide(Controller),
                      "SIMULATE/DYNAMICS, END=0.4, STEPS=4\nSIMULATE/DYNAMICS, DURATION=0.6, DTOUT=0.1\n");
    constexpr double IntegratorTolerance = 1e-6;
    for (const char* name : {"R1.F2", "R1.F3", "R1.F4"}) {
        const std::vector<double> a = whole.results.requests.getColumn(name),
                                  b = parts.results.requests.getColumn(name);
        ASSERT_EQ(a.size(), b.size());
        for (size_t row = 0; row < a.size(); ++row) EXPECT_NEAR(a[row], b[row], IntegratorTolerance) << name;
    }
}

// The derivatives of states are zero and the forces in balance: the integral holds the weight of 20 N where it should be.
TEST(ControlCommands, DynamicsStaysWhereStaticsLedTo) {
    const CommandsOutcome outcome =
        runCommandsOf(makeSlide(Controller), "SIMULATE/STATICS\nSIMULATE/DYNAMICS, END=1, STEPS=3\n");
    constexpr double Exact = 1e-8;
    for (const double z : outcome.results.requests.getColumn("R1.F4")) EXPECT_NEAR(z, 0.3, Exact);
    for (const double integral : outcome.results.requests.getColumn("R1.F2"))
        EXPECT_NEAR(integral, 20. / 50, Exact);
}

TEST(ControlRuns, AStateCanBeCopiedAndGoneOnFrom) {
    const Mechanism mechanism = buildOrFail(makeSlide(Controller));
    const SimulationOutcome whole = testing::run(mechanism, 1, 2, 1e-8),
                            half = testing::run(mechanism, 0.5, 1, 1e-8);
    AssembledState middle;
    middle.state = half.finalState;
    SimulationOptions options;
    options.end = 1;
    options.accuracy = 1e-8;
    const SimulationOutcome rest = simulate(mechanism, middle, options);
    for (const size_t function : {0, 1, 2})
        EXPECT_NEAR(evaluate(mechanism, rest.finalState, function),
                    evaluate(mechanism, whole.finalState, function), 1e-7);
}

TEST(ControlStatics, HeldStatesStayWhatTheyAre) {
    const Mechanism mechanism = buildOrFail(
        makeSlide("DIFF/1,IC=0.25,STATIC_HOLD,FUNCTION=1\nDIFF/2,IC=7,FUNCTION=3*DZ(20)-DIF(2)**3\n"
                  "SFORCE/1,TRANSLATIONAL,ACTIONONLY,I=20,J=10,FUNCTION=20+100*(DIF(1)-DZ(20))\n"
                  "REQUEST/1,F2=DIF(1)\\F3=DIF(2)\\F4=DZ(20)"));
    const SimTK::State state = findEquilibrium(mechanism, assemble(mechanism).state);
    constexpr double Exact = 1e-8;
    EXPECT_EQ(evaluate(mechanism, state, 0), 0.25);
    EXPECT_NEAR(evaluate(mechanism, state, 2), 0.25, Exact);
    EXPECT_NEAR(evaluate(mechanism, state, 1), std::cbrt(0.75), Exact);
}

TEST(ControlStatics, OfStatesAlone) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nDIFF/1,IC=1,FUNCTION=DIF(2)\nDIFF/2,FUNCTION=10-4*DIF(1)-DIF(2)\n"
        "REQUEST/1,F2=DIF(1)\\F3=DIF(2)\nEND\n");
    const SimTK::State state = findEquilibrium(mechanism, assemble(mechanism).state);
    EXPECT_NEAR(evaluate(mechanism, state, 0), 2.5, 1e-8);
    EXPECT_NEAR(evaluate(mechanism, state, 1), 0, 1e-8);
}

TEST(ControlStatics, AStateThatCannotRestIsNamed) {
    const Mechanism mechanism = buildOrFail(
        makeSlide("SFORCE/1,TRANSLATIONAL,ACTIONONLY,I=20,J=10,FUNCTION=20-100*DZ(20)\nDIFF/3,FUNCTION=1"));
    try {
        findEquilibrium(mechanism, assemble(mechanism).state);
        FAIL() << "found";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  "equilibrium: none was found from here; DIFF/3 goes on changing");
    }
}

// Nothing is free, but the states are to be integrated: of the angle t^2 and of the torque of the MOTION.
const char* const Driven =
    "driven\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\nMARKER/20\n"
    "JOINT/1,REVOLUTE,I=20,J=10\nMOTION/1,JOINT=1,FUNCTION=TIME**2\nDIFF/1,FUNCTION=AZ(20,10)\n"
    "DIFF/2,FUNCTION=MOTION(1,0,8)\nDIFF/3,FUNCTION=WDTZ(20)\nREQUEST/1,F2=DIF(1)\\F3=DIF(2)\\F4=DIF(3)\nEND\n";

TEST(ControlRuns, StatesOfADrivenMechanismAreIntegrated) {
    const Mechanism mechanism = buildOrFail(Driven);
    const SimulationOutcome outcome = testing::run(mechanism, 3, 3, 1e-8);
    EXPECT_FALSE(outcome.summary.isKinematic);
    constexpr double Tolerance = 1e-7;
    EXPECT_NEAR(evaluate(mechanism, outcome.finalState, 0), 9, Tolerance);
    EXPECT_NEAR(evaluate(mechanism, outcome.finalState, 1), 0.2 * 2 * 3, Tolerance);
    EXPECT_NEAR(evaluate(mechanism, outcome.finalState, 2), 2 * 3, Tolerance);
}

TEST(ControlRuns, KinematicsRefusesThem) {
    const Mechanism mechanism = buildOrFail(Driven);
    SimulationOptions options;
    options.end = 1;
    options.kind = SimulationKind::Kinematics;
    try {
        simulate(mechanism, assemble(mechanism), options);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(
            std::string(error.what()),
            "kinematics: nothing is integrated there, as the state of DIFF/1 has to be; run dynamics instead");
    }
}

// A pulse of a thousandth of a second, and one that a state decides on.
TEST(ControlRuns, WhatIsShortIsNotOverlooked) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nDIFF/1,FUNCTION=IF(TIME-0.5:0,0,IF(TIME-0.501:1,1,0))\nDIFF/2,FUNCTION=1\n"
        "DIFF/3,FUNCTION=IF(ABS(DIF(2)-1.5)-0.0005:1,1,0)\nREQUEST/1,F2=DIF(1)\\F3=DIF(3)\nEND\n");
    for (const char* integrator : {"RungeKuttaMerson", "CPodes"}) {
        SimulationOptions options;
        options.end = 3;
        options.steps = 1;
        options.accuracy = 1e-7;
        options.integrator = integrator;
        const SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
        EXPECT_EQ(outcome.failure, "");
        EXPECT_NEAR(evaluate(mechanism, outcome.finalState, 0), 1e-3, 1e-9) << integrator;
        EXPECT_NEAR(evaluate(mechanism, outcome.finalState, 1), 1e-3, 1e-5) << integrator;
    }
}

// Thrown up at 5 m/s from 0.3 m: highest after 0.5 s, at 1.55 m. From there on a force carries it, twice its weight.
TEST(ControlSensors, SenvalKeepsWhatWasEvaluatedAndMovesOn) {
    const Mechanism mechanism = buildOrFail(
        "throw\nACCGRAV/KGRAV=-10\nPART/1,GROUND\nMARKER/10\n"
        "PART/2,MASS=2,CM=20,IP=1,1,1,QG=0,0,0.3,VZ=5\nMARKER/20\n"
        "SENSOR/3,LE,VALUE=0,ERROR=1E-9,EVALUATE=DZ(20)\\FUNCTION=VZ(20)\n"
        "SFORCE/1,TRANSLATIONAL,ACTIONONLY,I=20,J=10,FUNCTION=40*SENVAL(3)/1.55\n"
        "REQUEST/1,F2=SENVAL(3)\\F3=DZ(20)\nEND\n");
    const SimulationOutcome outcome = testing::run(mechanism, 1, 5, 1e-9);
    EXPECT_EQ(outcome.summary.endedBy, "");
    const std::vector<double> noted = outcome.results.requests.getColumn("R1.F2"),
                              height = outcome.results.requests.getColumn("R1.F3");
    constexpr double Tolerance = 1e-7;
    for (const size_t before : {0, 1, 2}) EXPECT_EQ(noted[before], 0);
    for (const size_t behind : {3, 4, 5}) EXPECT_NEAR(noted[behind], 1.55, Tolerance);
    EXPECT_NEAR(height.back(), 1.55 + 5 * 0.5 * 0.5, Tolerance);
}

TEST(ControlSensors, ASensorEvaluatesAnewWhenItFiresAgain) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nDIFF/1,IC=1,FUNCTION=-DIF(2)\nDIFF/2,FUNCTION=DIF(1)\n"
        "SENSOR/1,GE,VALUE=0.5,ERROR=1E-9,EVALUATE=TIME\\FUNCTION=DIF(2)\n"
        "SENSOR/2,GE,VALUE=0.5,ERROR=1E-9,RETURN,EVALUATE=SENVAL(2)+1\\FUNCTION=DIF(1)-2*STEP(TIME,2,1,3,0)\n"
        "REQUEST/1,F2=SENVAL(1)\\F3=SENVAL(2)\nEND\n");
    const SimulationOutcome outcome = testing::run(mechanism, 20, 40, 1e-9);
    EXPECT_EQ(outcome.summary.endedBy, "SENSOR/2");
    EXPECT_NEAR(outcome.finalState.getTime(), 5 * SimTK::Pi / 3, 1e-6);  // of cos t
    EXPECT_NEAR(evaluate(mechanism, outcome.finalState, 0), SimTK::Pi / 6, 1e-6);
    EXPECT_EQ(evaluate(mechanism, outcome.finalState, 1), 1);
    AssembledState next;
    next.state = outcome.finalState;
    SimulationOptions options;
    options.end = 8;
    options.accuracy = 1e-9;
    options.sensors = outcome.sensors;
    const SimulationOutcome again = simulate(mechanism, next, options);
    EXPECT_NEAR(evaluate(mechanism, again.finalState, 0), 2 * SimTK::Pi + SimTK::Pi / 6, 1e-6);
}

// At rest the motor carries the arm's weight: m g l cos(angle).
TEST(ControlCommands, TheControlledArmOfTheExamplesComesToRestWhereItShould) {
    const std::string folder = std::string(JPRIM_SOURCE_DIR) + "/examples/";
    Diagnostics diagnostics;
    const CommandFile file = readCommandFile(folder + "controlled_arm.acf", diagnostics);
    const Mechanism mechanism = testing::buildFileOrFail(folder + file.model + ".adm");
    const CommandsOutcome outcome = runCommands(mechanism, file.commands, SimulationOptions());
    EXPECT_TRUE(diagnostics.empty());
    EXPECT_EQ(outcome.failure, "");
    const Table& requests = outcome.results.requests;
    const double moment = 4 * 9.80665 * 0.25, Exact = 1e-7, StillDecaying = 1e-3;
    EXPECT_NEAR(requests.getColumn("R1.F4").front(), moment, Exact);
    EXPECT_NEAR(requests.getColumn("R1.F2").front(), 0, Exact);
    EXPECT_NEAR(requests.getColumn("R1.F2").back(), SimTK::Pi / 3, StillDecaying);
    EXPECT_NEAR(requests.getColumn("R1.F4").back(), moment / 2, StillDecaying * moment);
    const double halfway = requests.getColumn("R1.F6").back();
    EXPECT_TRUE(0.7 < halfway && halfway < 0.85) << halfway;
}

TEST(ControlRuns, PlantsAreReadByFunctions) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nVARIABLE/1,FUNCTION=3\nVARIABLE/2,FUNCTION=2*TIME\nPINPUT/1,VARIABLES=1,2\n"
        "POUTPUT/4,VARIABLES=2\nREQUEST/1,F2=PINVAL(1,1)\\F3=PINVAL(1,2)\\F4=POUVAL(4,1)\nEND\n");
    const SimTK::State state = testing::run(mechanism, 2, 1, 1e-6).finalState;
    EXPECT_EQ(evaluate(mechanism, state, 0), 3);
    EXPECT_EQ(evaluate(mechanism, state, 1), 4);
    EXPECT_EQ(evaluate(mechanism, state, 2), 4);
}

}  // namespace
}  // namespace jprim
