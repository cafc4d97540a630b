// SPDX-License-Identifier: Apache-2.0
// Two shafts that meet at an angle: CONVEL turns the second as the first, HOOKE unevenly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "support/dataset_units.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using testing::buildOrFail;
using testing::DatasetUnits;
using testing::MetreSecond;

constexpr double Bend = 0.6, Rate = 4;  // rad, rad/s
constexpr double Tolerance = 1e-7;      // of the rate; the runs are accurate to 1e-10

class Shafts : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(Shafts);

/// Where the z axes of the joint's two markers point.
enum class Axes { Onward, AwayFromTheJoint };

// Shaft 2 turns in ground about z, shaft 3 about an axis bent from it about y. They meet at the origin. Shaft 3 is
// held by the joint and PARALLEL_AXES, so that nothing is held twice.
std::string makeShafts(const DatasetUnits& u, double bend, Axes axes, const char* type,
                       const std::string& drive) {
    const std::string flip = axes == Axes::Onward ? "" : ",REULER=0,180D,0";  // z backwards along shaft 2
    return fmt::format(
        "shafts\n{0}PART/1,GROUND\nMARKER/10\nMARKER/11,REULER=90D,{1},-90D\n"
        "PART/2,MASS=2,CM=20,IP={2},{2},{3},QG=0,0,0\nMARKER/20,QP=0,0,{4}\nMARKER/21{5}\nMARKER/22\n"
        "PART/3,MASS=3,CM=30,IP={2},{2},{6},REULER=90D,{1},-90D\nMARKER/30,QP=0,0,{7}\nMARKER/31\n"
        "JOINT/1,REVOLUTE,I=22,J=10\nJPRIM/2,PARALLEL_AXES,I=31,J=11\nJOINT/3,{8},I=21,J=31\n{9}"
        "REQUEST/1,F2=WZ(22,10,10)\\F3=WZ(31,11,11)\\F4=JOINT(3,1,8,11)\\F6=JOINT(3,0,8,10)\nEND\n",
        u.statement, bend, 0.2 * u.m * u.m, 0.1 * u.m * u.m, -0.4 * u.m, flip, 0.3 * u.m * u.m, 0.5 * u.m,
        type, drive);
}

SimulationOutcome runFor(const std::string& text, const DatasetUnits& u, double seconds) {
    return testing::run(buildOrFail(text), seconds * u.s, 40, 1e-10);
}

std::string makeDrive(const DatasetUnits& u) {
    return fmt::format("MOTION/1,JOINT=1,FUNCTION={}*TIME\n", Rate / u.s);
}

// Largest and smallest rate of shaft 3 over two turns, of the rate of shaft 2. Quarter turns are among the outputs.
std::pair<double, double> findRange(const DatasetUnits& u, Axes axes, const char* type) {
    const std::string text = makeShafts(u, Bend, axes, type, makeDrive(u));
    const std::vector<double> rate =
        runFor(text, u, 4 * SimTK::Pi / Rate).results.requests.getColumn("R1.F3");
    const auto [least, most] = std::minmax_element(rate.begin(), rate.end());
    return {*least * u.s / Rate, *most * u.s / Rate};
}

TEST_P(Shafts, AConvelTurnsThemAlike) {
    for (const Axes axes : {Axes::Onward, Axes::AwayFromTheJoint}) {
        const auto [least, most] = findRange(u, axes, "CONVEL");
        EXPECT_NEAR(least, 1, Tolerance);
        EXPECT_NEAR(most, 1, Tolerance);
    }
}

TEST_P(Shafts, AHookeTurnsThemUnevenly) {
    const auto [least, most] = findRange(u, Axes::Onward, "HOOKE");
    EXPECT_NEAR(least, std::cos(Bend), Tolerance);
    EXPECT_NEAR(most, 1 / std::cos(Bend), Tolerance);
}

// In line both ways of giving the axes must hold the turn: a torque accelerates both inertias.
TEST_P(Shafts, AConvelHoldsInLine) {
    const std::string drive = fmt::format("SFORCE/1,ROTATIONAL,I=22,J=10,FUNCTION={}\n", 2 * u.m);
    for (const Axes axes : {Axes::Onward, Axes::AwayFromTheJoint}) {
        const SimulationOutcome outcome = runFor(makeShafts(u, 0, axes, "CONVEL", drive), u, 1);
        EXPECT_EQ(outcome.summary.degreesOfFreedom, 1);
        EXPECT_EQ(outcome.summary.redundantEquations, 0);
        EXPECT_NEAR(outcome.results.requests.getColumn("R1.F2").back() * u.s, 2 / 0.4, 10 * Tolerance);
        EXPECT_NEAR(outcome.results.requests.getColumn("R1.F3").back() * u.s, 2 / 0.4, 10 * Tolerance);
        EXPECT_NEAR(outcome.results.requests.getColumn("R1.F4").back() / u.m, 2 * 0.3 / 0.4, 1e-6);
        EXPECT_NEAR(outcome.results.requests.getColumn("R1.F6").back() / u.m, -2 * 0.3 / 0.4, 1e-6);
    }
}

TEST_P(Shafts, AConvelNeedsNoWork) {
    const std::string text = makeShafts(u, Bend, Axes::AwayFromTheJoint, "CONVEL", "");
    const Mechanism mechanism =
        buildOrFail(text.substr(0, text.find("PART/3,")) + fmt::format("PART/3,WZ={},", 3 / u.s) +
                    text.substr(text.find("PART/3,") + 7));
    EXPECT_TRUE(mechanism.isConservative());
    const Results results = testing::run(mechanism, 3 * u.s, 20, 1e-10).results;
    const std::vector<double> energy = results.parts.getColumn("energy.kinetic");
    EXPECT_NEAR(energy.back(), energy[0], Tolerance * u.m);
    EXPECT_GT(energy[0], 0.5 * u.m);
}

}  // namespace
}  // namespace jprim
