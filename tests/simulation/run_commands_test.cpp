// SPDX-License-Identifier: Apache-2.0
// Command files: one State goes through all commands.
#include "jprim/simulation/run_commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "jprim/dataset/commands.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

// A pendulum of length 0.5 in a hinge, given horizontal; and a body that a MOTION turns.
const char* const Pendulum =
    "pendulum\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\n"
    "MARKER/20,QP=0.5,0,0\nMARKER/21\nJOINT/1,REVOLUTE,I=21,J=10\nSENSOR/1,HALT,GE,VALUE=7,FUNCTION=TIME\n"
    "REQUEST/1,DISPLACEMENT,I=20\nEND\n";
const char* const Driven =
    "driven\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\nMARKER/20\n"
    "JOINT/1,REVOLUTE,I=20,J=10\nMOTION/1,JOINT=1,FUNCTION=TIME**2\nREQUEST/1,F2=AZ(20,10)\nEND\n";

CommandsOutcome run(const char* dataset, const std::string& commands, double accuracy = 1e-8,
                    Formulation formulation = Formulation::Tree) {
    Diagnostics diagnostics;
    const CommandFile file = readCommands("model\n\n" + commands, diagnostics);
    if (hasErrors(diagnostics)) throw std::runtime_error(testing::formatAll(diagnostics));
    const Mechanism mechanism = testing::buildOrFail(dataset, {formulation});
    SimulationOptions options;
    options.accuracy = accuracy;
    return runCommands(mechanism, file.commands, options);
}

TEST(RunCommands, OneRunInTwoPartsIsTheSameRun) {
    constexpr double IntegratorTolerance = 1e-6;
    const CommandsOutcome whole = run(Pendulum, "SIMULATE/DYNAMICS, END=1, STEPS=10\n");
    const CommandsOutcome parts =
        run(Pendulum, "SIMULATE/DYNAMICS, END=0.4, STEPS=4\nSIMULATE/TRANSIENT, DURATION=0.6, DTOUT=0.1\n");
    EXPECT_EQ(parts.failure, "");
    ASSERT_EQ(parts.results.parts.getNumRows(), 11u);
    for (const char* name : {"time", "PART/2.X", "PART/2.Y", "PART/2.WZ"}) {
        const std::vector<double> a = whole.results.parts.getColumn(name),
                                  b = parts.results.parts.getColumn(name);
        for (size_t row = 0; row < a.size(); ++row) EXPECT_NEAR(a[row], b[row], IntegratorTolerance) << name;
    }
    ASSERT_EQ(parts.summaries.size(), 2u);
    EXPECT_EQ(parts.summaries[1].command, "SIMULATE/TRANSIENT");
    EXPECT_DOUBLE_EQ(parts.summaries[1].start, 0.4);
    EXPECT_DOUBLE_EQ(parts.summaries[1].end, 1);
}

// Without its hinge the pendulum flies on as a projectile.
TEST(RunCommands, ADeactivatedJointLetsGo) {
    const CommandsOutcome outcome = run(Pendulum,
                                        "SIMULATE/DYNAMICS, END=0.3, STEPS=1\nDEACTIVATE/JOINT, ID=1\n"
                                        "SIMULATE/DYNAMICS, END=0.5, STEPS=1\n",
                                        1e-8, Formulation::Constraints);
    const Table& parts = outcome.results.parts;
    ASSERT_EQ(parts.getNumRows(), 4u);  // the moment of switching twice
    const auto get = [&parts](const char* name, size_t row) { return parts.getColumn(name)[row]; };
    EXPECT_EQ(get("time", 1), get("time", 2));
    constexpr double t = 0.2, IntegratorTolerance = 1e-7;
    EXPECT_NEAR(get("PART/2.X", 3), get("PART/2.X", 1) + t * get("PART/2.VX", 1), IntegratorTolerance);
    EXPECT_NEAR(get("PART/2.Y", 3), get("PART/2.Y", 1) + t * get("PART/2.VY", 1) - 9.81 * t * t / 2,
                IntegratorTolerance);
    EXPECT_EQ(outcome.results.reactions.getColumn("JOINT/1.I.FY")[3], 0);
}

// Assembly is of what is switched on at the first SIMULATE: with JOINT/2 it is impossible, or leads elsewhere.
TEST(RunCommands, WhatIsDeactivatedBeforeTheFirstIsNotAssembled) {
    for (const char* place : {"100,0,0", "0.3,0.4,0"}) {
        const std::string text = fmt::format(
            "two hinges\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nMARKER/11,QP={}\n"
            "PART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\nMARKER/20,QP=0.5,0,0\nMARKER/21\nJOINT/1,REVOLUTE,I=21,J=10\n"
            "JOINT/2,REVOLUTE,I=20,J=11\nEND\n",
            place);
        const std::string once = "SIMULATE/DYNAMICS, END=0.3, STEPS=3\n";
        const CommandsOutcome swinging = run(Pendulum, once);
        const CommandsOutcome outcome =
            run(text.c_str(), "DEACTIVATE/JOINT, ID=2\n" + once, 1e-8, Formulation::Constraints);
        ASSERT_EQ(outcome.failure, "") << place;
        for (const char* name : {"PART/2.X", "PART/2.Y"})
            for (size_t row = 0; row < 4; ++row)
                EXPECT_NEAR(outcome.results.parts.getColumn(name)[row],
                            swinging.results.parts.getColumn(name)[row], 1e-6)
                    << place << " " << name << " " << row;
    }
}

// Nor do values given for it count; switched on again, they do.
TEST(RunCommands, WhatIsDeactivatedGivesNoInitialValues) {
    const std::string text =
        "ic\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\nMARKER/20,QP=0.5,0,0\nMARKER/21\n"
        "JOINT/1,REVOLUTE,I=21,J=10,IC=30D,1\nEND\n";
    const auto getFirst = [&](const std::string& commands, const char* column) {
        const CommandsOutcome outcome = run(text.c_str(), commands + "SIMULATE/DYNAMICS, END=0.1, STEPS=1\n",
                                            1e-8, Formulation::Constraints);
        EXPECT_EQ(outcome.failure, "");
        return outcome.results.parts.getColumn(column).at(0);
    };
    const std::string off = "DEACTIVATE/JOINT, ID=1\n", on = "ACTIVATE/JOINT, ID=1\n";
    EXPECT_EQ(getFirst(off, "PART/2.Y"), 0);
    EXPECT_EQ(getFirst(off, "PART/2.WZ"), 0);
    EXPECT_NEAR(getFirst(off + on, "PART/2.Y"), 0.25, 1e-9);
    EXPECT_NEAR(getFirst(off + on, "PART/2.WZ"), 1, 1e-9);
}

TEST(RunCommands, StaticsHangsThePendulumAndDynamicsLeavesItThere) {
    const CommandsOutcome outcome = run(Pendulum, "SIMULATE/STATICS\nSIMULATE/DYNAMICS, END=1, STEPS=2\n");
    constexpr double Exact = 1e-7;
    for (const double y : outcome.results.parts.getColumn("PART/2.Y")) EXPECT_NEAR(y, -0.5, Exact);
    EXPECT_EQ(outcome.results.parts.getNumRows(), 3u);
}

TEST(RunCommands, KinematicsFollowsTheMotion) {
    constexpr double Tolerance = 1e-7;  // a tenth of the accuracy
    const CommandsOutcome outcome = run(Driven, "SIMULATE/KINEMATICS, END=4, STEPS=8\n");
    EXPECT_TRUE(outcome.summaries.at(0).simulation.isKinematic);
    const std::vector<double> time = outcome.results.requests.getColumn("time");
    const std::vector<double> angle = outcome.results.requests.getColumn("R1.F2");
    for (size_t k = 0; k < time.size(); ++k)
        EXPECT_NEAR(angle[k], time[k] * time[k], Tolerance) << "turns counted";
    EXPECT_GT(angle.back(), 2 * SimTK::Pi);
}

TEST(RunCommands, InitialConditionsWriteOneRow) {
    EXPECT_EQ(run(Pendulum, "SIMULATE/INITIAL_CONDITIONS\n").results.parts.getNumRows(), 1u);
}

TEST(RunCommands, AHaltingSensorEndsTheWholeFile) {
    const CommandsOutcome outcome =
        run(Pendulum, "SIMULATE/DYNAMICS, END=8, STEPS=16\nSIMULATE/DYNAMICS, END=9, STEPS=1\n", 1e-4);
    ASSERT_EQ(outcome.summaries.size(), 1u);
    EXPECT_EQ(outcome.summaries[0].simulation.endedBy, "SENSOR/1");
    EXPECT_GE(outcome.summaries[0].end, 7 - 1e-3);
    EXPECT_LE(outcome.summaries[0].end, 7.5);
}

// The tyre carries all the weight, before the kerb and, 2.4 s after it, again.
TEST(RunCommands, TheQuarterCarOfTheExamplesStandsOnItsTyre) {
    const std::string folder = std::string(JPRIM_SOURCE_DIR) + "/examples/";
    Diagnostics diagnostics;
    const CommandFile file = readCommandFile(folder + "quarter_car.acf", diagnostics);
    const Mechanism mechanism = testing::buildFileOrFail(folder + file.model + ".adm");
    const CommandsOutcome outcome = runCommands(mechanism, file.commands, SimulationOptions());
    EXPECT_TRUE(diagnostics.empty());
    EXPECT_EQ(outcome.failure, "");
    const Table& requests = outcome.results.requests;
    const std::vector<double> tyre = requests.getColumn("R1.F4"), wheel = requests.getColumn("R1.F2");
    const double weight = (40 + 320) * 9.80665;
    EXPECT_NEAR(tyre.front(), weight, 1e-6 * weight);
    // An oscillation of 1.2 Hz with 0.29 of critical damping has decayed to e^-5.
    EXPECT_NEAR(tyre.back(), weight, 5e-3 * weight);
    EXPECT_NEAR(wheel.back() - wheel.front(), 60, 0.1);
    EXPECT_GT(*std::max_element(tyre.begin(), tyre.end()), 1.5 * weight);
}

TEST(RunCommands, FailuresNameTheCommand) {
    const auto fail = [](const char* dataset, const char* commands) {
        const CommandsOutcome outcome = run(dataset, commands);
        return fmt::format("{}: {}", outcome.where.line, outcome.failure);
    };
    EXPECT_EQ(
        fail(Pendulum, "SIMULATE/KINEMATICS, END=1, STEPS=2\n"),
        "3: kinematics: needs a mechanism without freedoms and without MOTIONs or GCONs of velocities; this one "
        "has 1 degrees of freedom; run dynamics instead");
    EXPECT_EQ(fail(Pendulum, "DEACTIVATE/JPRIM, ID=4\n"), "3: JPRIM/4 does not exist in this model");
}

std::string check(const std::string& commands) {
    Diagnostics diagnostics;
    const CommandFile file = readCommands("model\n\n" + commands, diagnostics);
    checkCommands(testing::buildOrFail(Driven, {Formulation::Constraints}), file.commands, diagnostics);
    return testing::formatAll(diagnostics);
}

TEST(CheckCommands, ListsAllThatAModelDoesNotHave) {
    EXPECT_EQ(check("DEACTIVATE/JPRIM, ID=4, 5\nDEACTIVATE/JOINT, ID=1\nSIMULATE/STATICS\n"
                    "ACTIVATE/MOTION, RANGE=2, 9\nACTIVATE/SENSOR, ID=1\nACTIVATE/MOTION, RANGE=1, 9\n"),
              "3:1: error: JPRIM/4 does not exist in this model\n"
              "3:1: error: JPRIM/5 does not exist in this model\n"
              "6:1: warning: this model has no MOTION from 2 to 9\n"
              "7:1: error: SENSOR/1 does not exist in this model\n");
}

TEST(CheckCommands, WantsASimulation) {
    EXPECT_EQ(check("DEACTIVATE/JOINT, ID=1\n"),
              " error: there is no SIMULATE command, so nothing would be simulated\n");
}

}  // namespace
}  // namespace jprim
