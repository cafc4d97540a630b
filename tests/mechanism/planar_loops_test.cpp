// SPDX-License-Identifier: Apache-2.0
// Loops that the joints in the tree keep in a plane, and what is left of the joint that closes them.
#include <gtest/gtest.h>

#include "base/format.h"
#include "support/four_bars.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

// A parallelogram in the xy plane, crank and rocker 1.2 rad from the base, whose coupler is closed by `last` between MARKER/32 and MARKER/42. The hinge of the
// rocker stands at 12; `tilt` turns the coupler's first hinge out of the plane, `lift` raises its last.
std::string makeFourBar(const std::string& last, double tilt = 0, double lift = 0) {
    return fmt::format(
        "t\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/11\nMARKER/12,QP=2,0,0\n"
        "PART/2,MASS=1,CM=20,IP=0.1,0.1,0.1,REULER=1.2,0,0\nMARKER/20,QP=0.5,0,0\nMARKER/21\n"
        "MARKER/22,QP=1,0,0\nPART/3,MASS=2,CM=30,IP=0.3,0.2,0.3,QG=0.36235775447667357,0.93203908596722635,0\nMARKER/30,QP=0.8,0,0\n"
        "MARKER/31,REULER=0,{},0\nMARKER/32,QP=2,0,{}\n"
        "PART/4,MASS=1,CM=40,IP=0.1,0.2,0.2,QG=2,0,0,REULER=1.2,0,0\nMARKER/40,QP=0.5,0,0\nMARKER/41\n"
        "MARKER/42,QP=1,0,0\nJOINT/1,REVOLUTE,I=21,J=11\nJOINT/2,REVOLUTE,I=31,J=22\n"
        "JOINT/3,REVOLUTE,I=41,J=12\n{}END\n",
        tilt, lift, last);
}

// How many equations the tree leaves.
int countEquations(const std::string& text) {
    const Mechanism mechanism = testing::buildOrFail(text, {Formulation::Tree});
    const SimTK::State state = mechanism.makeGivenState();
    mechanism.getSystem().realize(state, SimTK::Stage::Position);
    return int(mechanism.findEquations(state).size());
}

TEST(PlanarLoops, AreClosedByTwoEquations) {
    EXPECT_EQ(countEquations(makeFourBar("JOINT/4,REVOLUTE,I=42,J=32\n")), 2);
    EXPECT_EQ(countEquations(makeFourBar("JOINT/4,CYLINDRICAL,I=42,J=32\n")), 2);
    EXPECT_EQ(countEquations(makeFourBar("JOINT/4,SPHERICAL,I=42,J=32\n")), 2);
    EXPECT_EQ(countEquations(makeFourBar("JOINT/4,PLANAR,I=42,J=32\n")), 0);
    EXPECT_EQ(countEquations(makeFourBar("JPRIM/4,ATPOINT,I=42,J=32\nJPRIM/5,PARALLEL_AXES,I=32,J=42\n")), 2);
}

TEST(PlanarLoops, OthersKeepAllEquations) {
    EXPECT_EQ(countEquations(makeFourBar("JOINT/4,REVOLUTE,I=42,J=32\n", 1e-6)), 5);     // axes not parallel
    EXPECT_EQ(countEquations(makeFourBar("JOINT/4,REVOLUTE,I=42,J=32\n", 0, 1e-6)), 5);  // not in one plane
    EXPECT_EQ(countEquations(makeFourBar("JPRIM/4,ORIENTATION,I=42,J=32\n")), 3);        // not one of those
    EXPECT_EQ(countEquations(makeFourBar("JOINT/4,CONVEL,I=42,J=32\n")), 4);
}

// A slider moves in the plane if it goes along it; a cylinder leaves it.
TEST(PlanarLoops, JointsOnTheWayMustKeepThePlane) {
    const auto makeCrank = [](const char* joint, const char* axis) {
        return fmt::format(
            "t\nPART/1,GROUND\nMARKER/11\nMARKER/12{1}\nPART/2,MASS=1,CM=20,IP=1,1,1\nMARKER/20,QP=0,0.5,0\n"
            "MARKER/21\nMARKER/22,QP=0,1,0\nPART/3,MASS=1,CM=30,IP=1,1,1,QG=0,1,0\nMARKER/30,QP=1,0,0\n"
            "MARKER/31\nMARKER/32,QP=2,0,0\nPART/4,MASS=1,CM=40,IP=1,1,1,QG=2,1,0\nMARKER/40\n"
            "MARKER/42\nMARKER/43{1}\nJOINT/1,REVOLUTE,I=21,J=11\nJOINT/2,REVOLUTE,I=31,J=22\n"
            "JOINT/3,{0},I=43,J=12\nJOINT/4,SPHERICAL,I=32,J=42\nEND\n",
            joint, axis);
    };
    EXPECT_EQ(countEquations(makeCrank("TRANSLATIONAL", ",REULER=0,90D,0")), 2);
    EXPECT_EQ(countEquations(makeCrank("TRANSLATIONAL", "")), 3);
    EXPECT_EQ(countEquations(makeCrank("PLANAR", "")), 2);
    EXPECT_EQ(countEquations(makeCrank("CYLINDRICAL", "")), 3);
}

// Motion does not depend on it; loads in the plane are those that all equations give.
TEST(PlanarLoops, MoveAsWithAllEquations) {
    const std::string text = makeFourBar("JOINT/4,REVOLUTE,I=42,J=32\n");
    const Results tree = testing::run(testing::buildOrFail(text, {Formulation::Tree}), 0.5, 5, 1e-9).results;
    const Results constraints =
        testing::run(testing::buildOrFail(text, {Formulation::Constraints}), 0.5, 5, 1e-9).results;
    constexpr double Agreement = 1e-6;  // of both integrations, of values of order 1 to 100
    for (const char* column : {"PART/2.X", "PART/3.Y", "PART/4.WZ"})
        EXPECT_NEAR(tree.parts.getColumn(column).back(), constraints.parts.getColumn(column).back(),
                    Agreement);
    for (const char* column :
         {"JOINT/1.I.FX", "JOINT/2.I.FY", "JOINT/3.J.FX", "JOINT/4.I.FX", "JOINT/4.J.FY"}) {
        const double load = constraints.reactions.getColumn(column).back();
        EXPECT_GT(std::abs(load), 0.1) << column;
        EXPECT_NEAR(tree.reactions.getColumn(column).back(), load, 10 * Agreement) << column;
    }
}

// Two four-bars in a row have one freedom, of which the motion is known.
TEST(PlanarLoops, TwoFourBarsSwingAsOnePendulum) {
    for (const Formulation formulation : {Formulation::Tree, Formulation::Constraints}) {
        const Mechanism mechanism = testing::buildOrFail(testing::writeFourBars(2), {formulation});
        const SimulationOutcome outcome = testing::run(mechanism, 0.6, 1, 1e-9);
        EXPECT_EQ(outcome.summary.degreesOfFreedom, 1);
        EXPECT_EQ(outcome.summary.redundantEquations, formulation == Formulation::Tree ? 0 : 6);
        mechanism.getSystem().realize(outcome.finalState, SimTK::Stage::Position);
        const SimTK::Vec3 top = mechanism.getMarker(2002).findPoseInGround(outcome.finalState).p();
        const double angle = testing::calcFourBarsAngle(2, 0.6);
        EXPECT_LT((top - SimTK::Vec3(std::sin(angle), std::cos(angle), 0)).norm(), 1e-7);
    }
}

}  // namespace
}  // namespace jprim
