// SPDX-License-Identifier: Apache-2.0
// Command files: when rows are written, where a SIMULATE ends, and sensors over several of them.
#include <gtest/gtest.h>

#include "base/format.h"
#include "jprim/dataset/commands.h"
#include "jprim/simulation/run_commands.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

// An angle that follows sin t exactly, and the sensors that look at it.
CommandsOutcome run(const std::string& sensors, const std::string& commands,
                    const char* level = "DISPLACEMENT") {
    Diagnostics diagnostics;
    const CommandFile file = readCommands("model\n\n" + commands, diagnostics);
    if (hasErrors(diagnostics)) throw std::runtime_error(testing::formatAll(diagnostics));
    const Mechanism mechanism = testing::buildOrFail(fmt::format(
        "t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=1,2,3\nMARKER/20\nJOINT/1,REVOLUTE,I=20,J=10\n"
        "MOTION/1,JOINT=1,{},FUNCTION={}\nREQUEST/1,F2=AZ(20,10)\n{}\nEND\n",
        level, std::string(level) == "VELOCITY" ? "COS(TIME)" : "SIN(TIME)", sensors));
    return runCommands(mechanism, file.commands, SimulationOptions());
}

std::vector<double> getTimes(const CommandsOutcome& outcome) {
    EXPECT_EQ(outcome.failure, "");
    return outcome.results.requests.getColumn("time");
}

void expectTimes(const CommandsOutcome& outcome, const std::vector<double>& expected,
                 double tolerance = 1e-12) {
    const std::vector<double> times = getTimes(outcome);
    ASSERT_EQ(times.size(), expected.size());
    for (size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(times[k], expected[k], tolerance) << k;
}

TEST(OutputTimes, AreMultiplesOfDtoutAndTheEnd) {
    expectTimes(run("", "SIMULATE/DYNAMICS, END=2, DTOUT=0.6\n"), {0, 0.6, 1.2, 1.8, 2});
    expectTimes(run("", "SIMULATE/DYNAMICS, DURATION=0.9, DTOUT=0.3\n"), {0, 0.3, 0.6, 0.9});
    // Longer than the run; and counted from where the command starts.
    expectTimes(
        run("", "SIMULATE/DYNAMICS, END=0.003, DTOUT=0.048\nSIMULATE/DYNAMICS, END=0.1, DTOUT=0.048\n"),
        {0, 0.003, 0.051, 0.099, 0.1});
    expectTimes(run("", "SIMULATE/STATICS, END=0.5, DTOUT=0.2\n"), {0, 0.2, 0.4, 0.5});
    EXPECT_EQ(getTimes(run("", "SIMULATE/KINEMATICS, END=1, DTOUT=0.1\n")),
              getTimes(run("", "SIMULATE/KINEMATICS, END=1, STEPS=10\n")))
        << "to the last digit";
}

TEST(OutputTimes, MustBeOfANumberThatCanBeWritten) {
    EXPECT_EQ(
        run("", "SIMULATE/DYNAMICS, END=2, DTOUT=1E-12\n").failure,
        "output step: 1e-12 is too short for a run from 0 to 2: there would be 2000000000001 rows; at most 10000000 can be");
}

// A model without sensors is known to end where it is told, so nothing is simulated in vain.
TEST(SimulateEnd, MustLieBehindTheTimeReached) {
    const CommandsOutcome known =
        run("", "SIMULATE/DYNAMICS, END=2, STEPS=3\nSIMULATE/DYNAMICS, END=2, STEPS=3\n");
    EXPECT_EQ(known.failure,
              "SIMULATE: END is 2, but the time reached is 2; give a later time, or a DURATION");
    EXPECT_EQ(known.where.line, 4);
    EXPECT_TRUE(known.summaries.empty());

    const std::string sensor = "SENSOR/1,GE,VALUE=2,ERROR=1E-9,RETURN,FUNCTION=AZ(20,10)";  // never
    const CommandsOutcome late =
        run(sensor, "SIMULATE/DYNAMICS, END=2, STEPS=3\nSIMULATE/DYNAMICS, END=1.5, STEPS=3\n");
    EXPECT_EQ(late.failure,
              "SIMULATE: END is 1.5, but the time reached is 2; give a later time, or a DURATION");
    EXPECT_EQ(late.where.line, 4);
    EXPECT_EQ(late.results.requests.getNumRows(), 4u);
}

// sin t = 0.5 at π/6; the second END lies before the first.
TEST(SimulateEnd, CountsFromWhereASensorReturned) {
    const CommandsOutcome outcome =
        run("SENSOR/1,GE,VALUE=0.5,ERROR=1E-9,RETURN,FUNCTION=AZ(20,10)",
            "SIMULATE/DYNAMICS, END=3, STEPS=2\nSIMULATE/DYNAMICS, END=2, STEPS=1\n");
    expectTimes(outcome, {0, SimTK::Pi / 6, 2}, 1e-6);
    EXPECT_EQ(outcome.summaries.at(0).simulation.endedBy, "SENSOR/1");
    EXPECT_EQ(outcome.summaries.at(1).simulation.endedBy, "");
}

// sin t is above 0.5 from 30° to 150°, then again from 390°; integrated and followed.
TEST(SensorsOverCommands, FireAgainOnlyAfterTheyHaveBeenFalse) {
    const std::string command = "SIMULATE/DYNAMICS, END=10, DTOUT=0.3\n";
    for (const char* level : {"DISPLACEMENT", "VELOCITY"})
        for (const char* other : {"", "SENSOR/2,LE,VALUE=-2,RETURN,FUNCTION=AZ(20,10)\n"}) {
            const CommandsOutcome outcome =
                run(std::string(other) + "SENSOR/1,GE,VALUE=0.5,ERROR=1E-7,RETURN,FUNCTION=AZ(20,10)",
                    command + command + command + "SIMULATE/DYNAMICS, DURATION=0.5, STEPS=1\n", level);
            EXPECT_EQ(outcome.failure, "");
            ASSERT_EQ(outcome.summaries.size(), 4u);
            constexpr double Tolerance = 1e-5;  // of the integration, over the rate of sin t
            EXPECT_NEAR(outcome.summaries[0].end, SimTK::Pi / 6, Tolerance);
            EXPECT_NEAR(outcome.summaries[1].end, SimTK::Pi * 13 / 6, Tolerance);
            EXPECT_NEAR(outcome.summaries[2].end, 10, Tolerance);
            EXPECT_EQ(outcome.summaries[2].simulation.endedBy, "");
            EXPECT_NEAR(outcome.summaries[3].end, 10.5, Tolerance);
        }
}

// Each crossing once, upward and downward: at 30°, 150° and 390°.
TEST(SensorsOverCommands, EqFiresOncePerCrossing) {
    const std::string command = "SIMULATE/DYNAMICS, END=10, STEPS=50\n";
    const CommandsOutcome outcome =
        run("SENSOR/1,EQ,VALUE=0.5,ERROR=1E-6,RETURN,FUNCTION=AZ(20,10)", command + command + command);
    ASSERT_EQ(outcome.summaries.size(), 3u);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(outcome.summaries[size_t(k)].end, SimTK::Pi / 6 * (k == 0 ? 1 : k == 1 ? 5 : 13), 2e-6);
}

// Where two are true at once both have fired, and HALT has the last word.
TEST(SensorsOverCommands, AllThatAreTrueHaveFired) {
    const std::string twice =
        "SENSOR/1,GE,VALUE=1,RETURN,FUNCTION=IF(TIME-1:0,1,1)\nSENSOR/2,GE,VALUE=1,{},FUNCTION=IF(TIME-1:0,1,1)\n";
    const std::string commands = "SIMULATE/DYNAMICS, END=3, STEPS=3\nSIMULATE/DYNAMICS, END=3, STEPS=3\n";
    const CommandsOutcome returned = run(fmt::format(twice, "RETURN"), commands);
    ASSERT_EQ(returned.summaries.size(), 2u);
    EXPECT_NEAR(returned.summaries[0].end, 1, 1e-9);
    EXPECT_NEAR(returned.summaries[1].end, 3, 1e-9);
    const CommandsOutcome halted = run(fmt::format(twice, "HALT"), commands);
    ASSERT_EQ(halted.summaries.size(), 1u);
    EXPECT_EQ(halted.summaries[0].simulation.endedBy, "SENSOR/2");
}

TEST(SensorsOverCommands, AreSwitched) {
    const std::string sensors =
        "SENSOR/1,GE,VALUE=0.5,ERROR=1E-9,RETURN,FUNCTION=AZ(20,10)\nSENSOR/7,GE,VALUE=1,RETURN,FUNCTION=TIME";
    const std::string simulate = "SIMULATE/DYNAMICS, END=1.5, STEPS=1\n";
    // Off, then on: what is true already fires with the first step.
    const CommandsOutcome off = run(sensors, "DEACTIVATE/SENSOR, RANGE=1,9\n" + simulate);
    expectTimes(off, {0, 1.5});
    const CommandsOutcome one = run(sensors, "DEACTIVATE/SENSOR, ID=1\n" + simulate);
    EXPECT_EQ(one.summaries.at(0).simulation.endedBy, "SENSOR/7");
    const CommandsOutcome again =
        run(sensors, simulate + "DEACTIVATE/SENSOR, ID=7\nACTIVATE/SENSOR, ID=1\n" + simulate);
    ASSERT_EQ(again.summaries.size(), 2u);
    EXPECT_EQ(again.summaries[1].simulation.endedBy, "SENSOR/1");
    EXPECT_EQ(again.summaries[1].simulation.stepsTaken, 1);
    EXPECT_EQ(run(sensors, "ACTIVATE/SENSOR, ID=2\n").failure, "SENSOR/2 does not exist in this model");
}

// The reader warns that it has no effect.
TEST(SensorsOverCommands, WithoutHaltAndReturnDoNothing) {
    expectTimes(run("SENSOR/1,GE,VALUE=0.5,PRINT,FUNCTION=TIME", "SIMULATE/DYNAMICS, END=1, STEPS=1\n"),
                {0, 1});
}

}  // namespace
}  // namespace jprim
