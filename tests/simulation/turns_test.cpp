// SPDX-License-Identifier: Apache-2.0
// Angles of datasets that go on for whole turns: through commands, in statics, and in run after run.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "jprim/dataset/commands.h"
#include "jprim/simulation/equilibrium.h"
#include "jprim/simulation/run_commands.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Pi;

constexpr double IntegratorTolerance = 1e-6;

// A nut on a screw of 20 mm pitch that spins at 10 rad/s from the start, faster and faster; weightless.
const char* const Screw =
    "screw\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=7,CM=20,IP=0.3,0.3,0.3,QG=0,0,0.1,REULER=0.5,0,0,WZ=10\n"
    "MARKER/20\nJOINT/1,CYLINDRICAL,I=20,J=10\nJOINT/2,SCREW,PITCH=0.02,I=20,J=10\n"
    "SFORCE/1,ROTATIONAL,I=20,J=10,FUNCTION=0.5\nREQUEST/1,F2=AZ(20,10)\\F3=DZ(20,10)\nEND\n";

// Its travel is what its turns say, within a thread of where it is.
double calcThreadDefect(const Table& r, size_t row) {
    const double threads = (r.getColumn("R1.F3")[row] - 0.1) / 0.02;
    return std::remainder(threads - (r.getColumn("R1.F2")[row] - 0.5) / (2 * Pi), 1);
}

CommandsOutcome runCommandText(const Mechanism& mechanism, const std::string& commands) {
    Diagnostics diagnostics;
    const CommandFile file = readCommands("model\n\n" + commands, diagnostics);
    if (hasErrors(diagnostics)) throw std::runtime_error(testing::formatAll(diagnostics));
    SimulationOptions options;
    options.accuracy = 1e-8;
    return runCommands(mechanism, file.commands, options);
}

// While the thread is off the nut flies on, no faster; the thread catches it where it is.
TEST(Turns, AThreadSwitchedOnAgainCatchesTheNutWhereItIs) {
    const Mechanism mechanism = testing::buildOrFail(Screw, {Formulation::Constraints});
    const CommandsOutcome outcome =
        runCommandText(mechanism,
                       "SIMULATE/DYNAMICS, END=1, STEPS=10\nDEACTIVATE/JOINT, ID=2\n"
                       "SIMULATE/DYNAMICS, END=2.5, STEPS=15\nACTIVATE/JOINT, ID=2\n"
                       "SIMULATE/DYNAMICS, END=3, STEPS=5\n");
    EXPECT_EQ(outcome.failure, "");
    const Table& r = outcome.results.requests;
    const std::vector<double> time = r.getColumn("time"), travel = r.getColumn("R1.F3");
    size_t before = 0;  // the row before the thread is on again
    while (time[before] < 2.5) ++before;
    ASSERT_LT(before + 1, time.size());
    EXPECT_GT(r.getColumn("R1.F2")[before], 3 * 2 * Pi);
    EXPECT_LE(std::abs(travel[before + 1] - travel[before]), 0.02 / 2 * (1 + IntegratorTolerance));
    EXPECT_NEAR(calcThreadDefect(r, before + 1), 0, IntegratorTolerance);
    EXPECT_NEAR(calcThreadDefect(r, time.size() - 1), 0, IntegratorTolerance);
}

TEST(Turns, EveryRunOfAMechanismIsTheSame) {
    for (const Formulation formulation : {Formulation::Tree, Formulation::Constraints}) {
        const Mechanism mechanism = testing::buildOrFail(Screw, {formulation});
        const std::string commands = "SIMULATE/DYNAMICS, END=3, STEPS=30\n";
        const CommandsOutcome first = runCommandText(mechanism, commands),
                              second = runCommandText(mechanism, commands);
        EXPECT_EQ(second.failure, "");
        EXPECT_EQ(first.results.requests.values, second.results.requests.values);
        EXPECT_GT(second.results.requests.getColumn("R1.F2").back(), 4 * 2 * Pi);
        EXPECT_NEAR(calcThreadDefect(second.results.requests, 30), 0, IntegratorTolerance);
    }
}

// A torsional spring of 0.7 N m/rad that carries 7 N m: 10 rad, where a wheel without turns finds nothing.
TEST(Turns, AnEquilibriumMayBeTurnsAway) {
    const std::string text =
        "spring\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=1,CM=20,IP=0.1,0.1,0.1\nMARKER/20\n"
        "JOINT/1,REVOLUTE,I=20,J=10\nSFORCE/1,ROTATIONAL,I=20,J=10,FUNCTION={}-0.7*AZ(20,10)\n"
        "REQUEST/1,F2=AZ(20,10)\nEND\n";
    for (const double torque : {7.0, -30.0}) {
        const Mechanism mechanism = testing::buildOrFail(fmt::format(fmt::runtime(text), torque));
        const CommandsOutcome outcome = runCommandText(mechanism, "SIMULATE/STATICS\n");
        EXPECT_EQ(outcome.failure, "");
        EXPECT_NEAR(outcome.results.requests.getColumn("R1.F2").back(), torque / 0.7, 1e-6);
    }
}

// Gears of 20 and 35 teeth: any of the positions in which they mesh is as good as another.
TEST(Turns, GearsAreAssembledToTheNearestTooth) {
    const Mechanism mechanism = testing::buildOrFail(
        "gears\nPART/1,GROUND\nMARKER/20,PART=1\nPART/2,MASS=1,CM=21,IP=1,1,1,REULER=2,0,0\nMARKER/21\n"
        "JOINT/2,REVOLUTE,I=21,J=20\nMARKER/30,PART=1\nPART/3,MASS=1,CM=31,IP=1,1,1,REULER=-0.1,0,0\nMARKER/31\n"
        "JOINT/3,REVOLUTE,I=31,J=30\nCOUPLER/1,JOINTS=2,3,SCALES=20,35\nREQUEST/1,F2=AZ(21,20)\\F3=AZ(31,30)\nEND\n");
    const CommandsOutcome outcome = runCommandText(mechanism, "SIMULATE/DYNAMICS, END=1, STEPS=1\n");
    EXPECT_EQ(outcome.failure, "");
    const Table& r = outcome.results.requests;
    const double a = r.getColumn("R1.F2")[0], b = r.getColumn("R1.F3")[0];
    EXPECT_NEAR(std::remainder(20 * a + 35 * b, 5 * 2 * Pi), 0, 1e-6);
    const double given = 20 * 2 - 35 * 0.1, left = std::remainder(given, 5 * 2 * Pi);
    EXPECT_NEAR(std::hypot(a - 2, b + 0.1), std::abs(left) / std::hypot(20, 35), 1e-3);  // straight there
}

}  // namespace
}  // namespace jprim
