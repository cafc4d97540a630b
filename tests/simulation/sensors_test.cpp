// SPDX-License-Identifier: Apache-2.0
// A SENSOR ends a run when its function says so: at the moment that an exact solution gives, to within its ERROR.
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

class Sensors : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(Sensors);

// Thrown up at 5 m/s under 10 m/s^2 from z = 0.3 m: z = 0.3 + 5 t - 5 t^2, highest at 0.5 s.
std::string makeThrow(const DatasetUnits& u, const std::string& sensor) {
    return fmt::format(
        "throw\n{}ACCGRAV/KGRAV={}\nPART/1,GROUND\nPART/2,MASS=2,CM=20,IP=1,1,1,QG=0,0,{},VZ={}\nMARKER/20\n"
        "{}\nEND\n",
        u.statement, -10 * u.m / u.s / u.s, 0.3 * u.m, 5 * u.m / u.s, sensor);
}

SimulationOutcome runThrow(const DatasetUnits& u, const std::string& sensor) {
    return testing::run(buildOrFail(makeThrow(u, sensor)), 2 * u.s, 4, 1e-8);
}

double findEnd(const DatasetUnits& u, const SimulationOutcome& outcome) {
    return outcome.results.parts.getColumn("time").back() / u.s;
}

TEST_P(Sensors, GeFiresWhenTheValueIsReached) {
    const SimulationOutcome outcome = runThrow(
        u, fmt::format("SENSOR/3,GE,VALUE={},ERROR={},RETURN,FUNCTION=DZ(20)", 1.1 * u.m, 1e-6 * u.m));
    EXPECT_EQ(outcome.summary.endedBy, "SENSOR/3");
    EXPECT_FALSE(outcome.summary.isHalted);
    EXPECT_NEAR(findEnd(u, outcome), 0.2, 1e-6);  // ERROR over the velocity of 3 m/s
    EXPECT_NEAR(outcome.results.parts.getColumn("PART/2.Z").back(), 1.1 * u.m, 1e-6 * u.m);
    EXPECT_EQ(outcome.finalState.getTime(), findEnd(u, outcome));
}

TEST_P(Sensors, LeFiresWhenTheValueIsReachedAndHalts) {
    const SimulationOutcome outcome = runThrow(
        u,
        fmt::format("SENSOR/3,LE,VALUE={},ERROR={},HALT,FUNCTION=VZ(20)", -2 * u.m / u.s, 1e-6 * u.m / u.s));
    EXPECT_TRUE(outcome.summary.isHalted);
    EXPECT_NEAR(findEnd(u, outcome), 0.7, 1e-6);
    EXPECT_EQ(outcome.results.parts.getNumRows(), 3u);  // 0, 0.5 and the end
}

// A long step jumps over the crossing: free flight is integrated in as few steps as there are outputs.
TEST_P(Sensors, EqIsNotJumpedOver) {
    const SimulationOutcome outcome =
        runThrow(u, fmt::format("SENSOR/3,VALUE={},ERROR={},RETURN,FUNCTION=DZ(20)", -0.7 * u.m, 1e-7 * u.m));
    EXPECT_EQ(outcome.summary.endedBy, "SENSOR/3");
    EXPECT_NEAR(findEnd(u, outcome), (5 + std::sqrt(25 + 20)) / 10, 1e-7);
}

// Of two the earlier one counts, whatever their order; a function may jump.
TEST_P(Sensors, TheEarliestEndsTheRun) {
    const std::string late = fmt::format("SENSOR/1,LE,VALUE={},RETURN,FUNCTION=VZ(20)\n", -2.5 * u.m / u.s);
    const std::string early = fmt::format("SENSOR/2,GE,VALUE=1,HALT,FUNCTION=IF(TIME-{}:0,0,1)", 0.625 * u.s);
    for (const std::string& both : {late + early, early + "\n" + late}) {
        const SimulationOutcome outcome = runThrow(u, both);
        EXPECT_EQ(outcome.summary.endedBy, "SENSOR/2");
        EXPECT_NEAR(findEnd(u, outcome), 0.625, 1e-9);
    }
}

TEST_P(Sensors, ThatNeverFireChangeNothing) {
    const SimulationOutcome with =
        runThrow(u, fmt::format("SENSOR/1,GE,VALUE={},HALT,FUNCTION=DZ(20)", 9 * u.m));
    EXPECT_EQ(with.summary.endedBy, "");
    EXPECT_NEAR(findEnd(u, with), 2, 1e-12);
    EXPECT_NEAR(with.results.parts.getColumn("PART/2.Z").back() / u.m, 0.3 + 10 - 20, 1e-7);
}

// What is true from the start ends the run with its first step.
TEST_P(Sensors, ThatAreTrueFromTheStartFireAtOnce) {
    const SimulationOutcome outcome =
        runThrow(u, fmt::format("SENSOR/1,LE,VALUE={},HALT,FUNCTION=DZ(20)", 9 * u.m));
    EXPECT_EQ(outcome.summary.endedBy, "SENSOR/1");
    EXPECT_EQ(outcome.summary.stepsTaken, 1);
    EXPECT_LE(findEnd(u, outcome), 0.5);
    EXPECT_EQ(outcome.results.parts.getNumRows(), 2u);
}

// What is followed without integration is watched as well, and whole turns count.
TEST_P(Sensors, EndKinematicsToo) {
    const std::string text = fmt::format(
        "turn\n{}PART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20\nJOINT/1,REVOLUTE,I=20,J=10\n"
        "MOTION/1,JOINT=1,FUNCTION=5*TIME/{}\nSENSOR/1,GE,VALUE=810D,ERROR=1E-7,HALT,FUNCTION=AZ(20,10)\nEND\n",
        u.statement, u.s);
    const SimulationOutcome outcome = testing::run(buildOrFail(text), 4 * u.s, 2, 1e-8);
    EXPECT_TRUE(outcome.summary.isKinematic);
    EXPECT_NEAR(findEnd(u, outcome), 4.5 * SimTK::Pi / 5, 1e-7);
}

// A sensor may look at loads, here of the joint that a growing force pulls at.
TEST_P(Sensors, MayLookAtReactions) {
    const std::string text = fmt::format(
        "pull\n{}PART/1,GROUND\nMARKER/10,REULER=0,0,0\nPART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20\n"
        "JOINT/1,FIXED,I=20,J=10\nSFORCE/1,TRANSLATIONAL,ACTIONONLY,I=20,J=10,FUNCTION=3*TIME/{}\n"
        "SENSOR/1,LE,VALUE=-4,ERROR=1E-6,HALT,FUNCTION=JOINT(1,0,4)\nEND\n",
        u.statement, u.s);
    EXPECT_NEAR(findEnd(u, testing::run(buildOrFail(text), 4 * u.s, 2, 1e-8)), 4. / 3, 1e-6);
}

TEST(SensorsMutated, AnotherValueIsNoticed) {
    const SimulationOutcome outcome =
        runThrow(MetreSecond, "SENSOR/3,GE,VALUE=1.1001,ERROR=1E-6,RETURN,FUNCTION=DZ(20)");
    EXPECT_GT(std::abs(findEnd(MetreSecond, outcome) - 0.2), 1e-5);
}

}  // namespace
}  // namespace jprim
