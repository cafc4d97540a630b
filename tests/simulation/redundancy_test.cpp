// SPDX-License-Identifier: Apache-2.0
// Redundant equations in a run: shared or dropped, and what happens when they come into conflict.
#include "simulation/redundancy.h"

#include <gtest/gtest.h>

#include "jprim/analysis/constraint_report.h"
#include "jprim/base/error.h"
#include "jprim/simulation/run_commands.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Stage;
using SimTK::State;

// As equations, of which some can then be redundant.
Mechanism buildOrFail(const std::string& text) {
    return testing::buildOrFail(text, {Formulation::Constraints});
}

// A door: everything that its second hinge holds, the first one holds already.
const char* const Door =
    "door\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nMARKER/11,QP=0,0,1\n"
    "PART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\nMARKER/20,QP=0.5,0.1,0.5\nMARKER/21\nMARKER/22,QP=0,0,1\n"
    "JOINT/1,REVOLUTE,I=21,J=10\nJOINT/2,REVOLUTE,I=22,J=11\nEND\n";

SimulationOutcome run(const Mechanism& mechanism, Redundancy redundancy, double end = 1) {
    SimulationOptions options;
    options.end = end;
    options.steps = 10;
    options.accuracy = 1e-8;
    options.redundancy = redundancy;
    return simulate(mechanism, assemble(mechanism), options);
}

std::vector<double> getColumn(const SimulationOutcome& outcome, const char* name) {
    return outcome.results.reactions.getColumn(name);
}

TEST(Redundancy, DroppedEquationsCarryNothingAndTheMotionIsTheSame) {
    constexpr double IntegratorTolerance = 1e-6;
    const Mechanism mechanism = buildOrFail(Door);
    const SimulationOutcome shared = run(mechanism, Redundancy::Share);
    const SimulationOutcome dropped = run(mechanism, Redundancy::Drop);
    EXPECT_EQ(dropped.failure, "");
    ASSERT_EQ(dropped.summary.droppedEquations.size(), 5u);
    EXPECT_EQ(dropped.summary.droppedEquations[0], "JOINT/2 REVOLUTE: translation of I along Xj");
    EXPECT_TRUE(shared.summary.droppedEquations.empty());
    for (size_t row = 0; row < 11; ++row) {
        EXPECT_NEAR(dropped.results.parts.getColumn("PART/2.Y")[row],
                    shared.results.parts.getColumn("PART/2.Y")[row], IntegratorTolerance);
        for (const char* component : {"FX", "FY", "FZ", "TX", "TY", "TZ"})
            EXPECT_EQ(getColumn(dropped, (std::string("JOINT/2.I.") + component).c_str())[row], 0);
        // The first hinge carries alone what the two shared.
        const double sum = getColumn(shared, "JOINT/1.I.FY")[row] + getColumn(shared, "JOINT/2.I.FY")[row];
        EXPECT_NEAR(getColumn(dropped, "JOINT/1.I.FY")[row], sum, 100 * IntegratorTolerance);
        EXPECT_GT(std::abs(getColumn(shared, "JOINT/2.I.FY")[row]), 0.1);
    }
}

TEST(Redundancy, ADroppedEquationThatIsViolatedIsNamed) {
    const Mechanism mechanism = buildOrFail(Door);
    State state = assemble(mechanism).state;
    mechanism.getSystem().realize(state, Stage::Position);
    const DroppedEquations dropped(mechanism, state, DropChoice::Later);
    mechanism.getSystem().realize(state, Stage::Position);
    dropped.check(state, 1e-9);  // nothing is violated yet
    const MechanismPart& door = mechanism.getParts()[1];
    door.body.setQToFitTranslation(state, door.cm.findPoseInGround(state).p() + SimTK::Vec3(0, 0.03, 0));
    mechanism.getSystem().realize(state, Stage::Position);
    try {
        dropped.check(state, 1e-2);
        ADD_FAILURE() << "nothing was noticed";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(
            error.what(),
            "JOINT/2 REVOLUTE: translation of I along Yj, which was dropped because it followed from other "
            "equations, is violated by 0.03 length units: it is in conflict with them now");
    }
}

//------------------------------------------------------------- equations that are no primitive's
// A nut on a leaning screw and a slider on a leaning rail, and something that follows from them.
struct Redundant {
    const char* name;
    const char* statements;
    const char* dropped;
    const char* reaction;  ///< the column of what it carries if it is shared
};

std::string makeNutAndSlider(const std::string& redundant) {
    return "nut\nACCGRAV/KGRAV=-9.81\nPART/1,GROUND\nMARKER/10,REULER=0.3,0.4,0.5\nMARKER/11,QP=2,0,0,REULER=0,1,0\n"
           "PART/2,MASS=2,CM=21,IP=0.1,0.15,0.2\nMARKER/20,REULER=0.3,0.4,0.5\nMARKER/21,QP=0.2,-0.1,0.3\n"
           "PART/3,MASS=3,CM=30,IP=0.3,0.2,0.2\nMARKER/30,QP=2,0,0,REULER=0,1,0\n"
           "JOINT/1,CYLINDRICAL,I=20,J=10\nJOINT/2,TRANSLATIONAL,I=30,J=11\nJOINT/3,SCREW,PITCH=0.7,I=20,J=10\n" +
           redundant + "END\n";
}

class OtherEquations : public ::testing::TestWithParam<Redundant> {};

TEST_P(OtherEquations, AreDroppedToo) {
    constexpr double IntegratorTolerance = 1e-6;
    const Mechanism mechanism = buildOrFail(makeNutAndSlider(GetParam().statements));
    const SimulationOutcome shared = run(mechanism, Redundancy::Share);
    const SimulationOutcome dropped = run(mechanism, Redundancy::Drop);
    EXPECT_EQ(dropped.failure, "");
    EXPECT_EQ(dropped.summary.droppedEquations, std::vector<std::string>{GetParam().dropped});
    EXPECT_EQ(dropped.summary.redundantEquations, 1);
    for (const char* name : {"PART/2.Z", "PART/2.WY", "PART/3.Y", "PART/3.VZ"})
        for (size_t row = 0; row < 11; ++row)
            EXPECT_NEAR(dropped.results.parts.getColumn(name)[row], shared.results.parts.getColumn(name)[row],
                        IntegratorTolerance)
                << name << row;
    if (!GetParam().reaction) return;
    EXPECT_EQ(getColumn(dropped, GetParam().reaction), std::vector<double>(11, 0));
    EXPECT_GT(std::abs(getColumn(shared, GetParam().reaction).back()), 1e-2);
}

INSTANTIATE_TEST_SUITE_P(
    Redundancy, OtherEquations,
    ::testing::Values(
        Redundant{"Gcon", "GCON/1,I=20,FUNCTION=DX(20,10,10)\n", "GCON/1: its equation", "GCON/1.I.FX"},
        Redundant{"Joint", "JOINT/4,SCREW,PITCH=0.7,I=20,J=10\n", "JOINT/4 SCREW: its own equation",
                  "JOINT/4.I.FZ"},
        Redundant{"Coupler",
                  "COUPLER/1,JOINTS=1,2,TYPE=T:T,SCALES=1,-2\nCOUPLER/2,JOINTS=1,2,TYPE=T:T,SCALES=2,-4\n",
                  "COUPLER/2: its equation", nullptr},
        Redundant{"Motion", "MOTION/1,JOINT=2,FUNCTION=0.1*TIME**2\nMOTION/2,JOINT=2,FUNCTION=0.1*TIME**2\n",
                  "MOTION/2: its equation", "MOTION/2.I.FY"},
        Redundant{
            "MotionOfVelocity",
            "MOTION/1,JOINT=2,VELOCITY,FUNCTION=0.2*TIME\nMOTION/2,JOINT=2,VELOCITY,FUNCTION=0.2*TIME\n",
            "MOTION/2: its equation", "MOTION/2.I.FY"},
        Redundant{"MotionOfAcceleration",
                  "MOTION/1,JOINT=2,ACCELERATION,FUNCTION=0.2\nMOTION/2,JOINT=2,ACCELERATION,FUNCTION=0.2\n",
                  "MOTION/2: its equation", "MOTION/2.I.FY"}),
    [](const auto& info) { return info.param.name; });

// Of two equations that begin to part at 0.5 the second was dropped: at 0.6 they are 0.2 STEP(0.2) = 0.0208 apart.
std::string findViolation(const std::string& statements) {
    const SimulationOutcome outcome = run(buildOrFail(makeNutAndSlider(statements)), Redundancy::Drop);
    EXPECT_EQ(outcome.results.parts.getNumRows(), 6u) << "what was simulated is kept";
    const std::string reason = "which was dropped";
    return outcome.failure.substr(0, 11) + " … " +
           outcome.failure.substr(std::min(outcome.failure.find(reason), outcome.failure.size()));
}

TEST(Redundancy, ADroppedEquationThatPartsFromTheOthersStopsTheRun) {
    const char* const now = ": it is in conflict with them now";
    EXPECT_EQ(findViolation("GCON/1,FUNCTION=DX(20,10,10)-STEP(TIME,0.5,0,1,0.2)\n"),
              std::string(
                  "at time 0.6 … which was dropped because it followed from other equations, is violated by "
                  "0.0208 length units") +
                  now);
    EXPECT_EQ(findViolation("MOTION/1,JOINT=2,VELOCITY,FUNCTION=1\n"
                            "MOTION/2,JOINT=2,VELOCITY,FUNCTION=1+STEP(TIME,0.5,0,1,0.2)\n"),
              std::string(
                  "at time 0.6 … which was dropped because it followed from other equations, is violated by "
                  "0.0208 length units/s") +
                  now);
    EXPECT_EQ(findViolation("MOTION/1,JOINT=2,ACCELERATION,FUNCTION=1\n"
                            "MOTION/2,JOINT=2,ACCELERATION,FUNCTION=1-STEP(TIME,0.5,0,1,0.2)\n"),
              std::string(
                  "at time 0.6 … which was dropped because it followed from other equations, is violated by "
                  "0.0208 length units/s^2") +
                  now);
}

// What one hinge held for both, the other holds alone once the first is switched off.
TEST(Redundancy, WhatWasDroppedIsBackForTheNextSimulation) {
    const Mechanism mechanism = buildOrFail(Door);
    Diagnostics diagnostics;
    const CommandFile file = readCommands(
        "door\ndoor\nSIMULATE/DYNAMICS,END=0.5,STEPS=1\nDEACTIVATE/JOINT,ID=1\nSIMULATE/DYNAMICS,END=1,STEPS=1\n",
        diagnostics);
    ASSERT_TRUE(diagnostics.empty());
    SimulationOptions options;
    options.redundancy = Redundancy::Drop;
    const CommandsOutcome outcome = runCommands(mechanism, file.commands, options);
    EXPECT_EQ(outcome.failure, "");
    EXPECT_EQ(outcome.summaries.at(1).simulation.degreesOfFreedom, 1);
    EXPECT_TRUE(outcome.summaries.at(1).simulation.droppedEquations.empty());
    const std::vector<double> load = outcome.results.reactions.getColumn("JOINT/2.I.FY");
    EXPECT_EQ(load[1], 0);
    EXPECT_GT(std::abs(load.back()), 1);
}

//------------------------------------------------------------------------------------- conflicts
// x is held at zero twice, until one of the two begins to move.
TEST(Redundancy, AConflictStopsTheRunAtItsTimeAndNamesTheEquations) {
    const Mechanism mechanism = buildOrFail(
        "conflict\nPART/1,GROUND\nMARKER/10,REULER=90D,90D,0\nMARKER/11\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\n"
        "MARKER/20\nJPRIM/1,INPLANE,I=20,J=10\nGCON/1,FUNCTION=DX(20,11)-STEP(TIME,0.5,0,1,0.2)\nEND\n");
    const SimulationOutcome outcome = run(mechanism, Redundancy::Share, 2);
    EXPECT_EQ(outcome.summary.redundantEquations, 1);
    EXPECT_NE(outcome.failure.find("at time 0.5"), std::string::npos) << outcome.failure;
    EXPECT_NE(
        outcome.failure.find("a moment later these cannot be met together: JPRIM/1 INPLANE: translation of I "
                             "along Zj, GCON/1: its equation"),
        std::string::npos)
        << outcome.failure;
    EXPECT_GE(outcome.results.parts.getNumRows(), 3u) << "what was simulated is kept";
}

// An axis turned by Euler angles is off by rounding errors, in directions that nothing else holds.
TEST(Redundancy, RoundingErrorsAreNoIndependence) {
    const Mechanism mechanism = buildOrFail(
        "twice\nPART/1,GROUND\nMARKER/10,REULER=90D,90D,0\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\nMARKER/20\n"
        "JPRIM/1,INPLANE,I=20,J=10\nGCON/1,FUNCTION=DX(20)\nEND\n");
    const AssembledState initial = assemble(mechanism);
    EXPECT_EQ(countFreedoms(mechanism.getMatter(), initial.state).getNumRedundant(), 1);
}

TEST(SingleEquation, IsDroppedAndRestored) {
    const Mechanism mechanism = buildOrFail(Door);
    State state = assemble(mechanism).state;
    const PairConstraint& ball = *mechanism.getElements()[0].getJoint()->getPairConstraint();
    ball.dropEquation(state, 1);
    EXPECT_TRUE(ball.isEquationDropped(state, 1));
    EXPECT_FALSE(ball.isEquationDropped(state, 0));
    const MechanismPart& door = mechanism.getParts()[1];
    mechanism.getSystem().realize(state, Stage::Position);
    door.body.setQToFitTranslation(state, door.cm.findPoseInGround(state).p() + SimTK::Vec3(0.1, 0.2, 0.4));
    mechanism.getSystem().realize(state, Stage::Acceleration);
    constexpr double Rounding = 1e-14;
    const SimTK::Vector errors = ball.getPositionErrorsAsVector(state);
    EXPECT_NEAR(errors[0], 0.1, Rounding);
    EXPECT_EQ(errors[1], 0);
    EXPECT_NEAR(errors[2], 0.4, Rounding);
    EXPECT_NEAR(ball.calcEquationError(state, 1), 0.2, Rounding);
    ball.restoreEquation(state, 1);
    mechanism.getSystem().realize(state, Stage::Position);
    EXPECT_NEAR(ball.getPositionErrorsAsVector(state)[1], 0.2, Rounding);
    EXPECT_THROW(ball.dropEquation(state, 5), Error);
}

}  // namespace
}  // namespace jprim
