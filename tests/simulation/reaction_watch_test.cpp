// SPDX-License-Identifier: Apache-2.0
// Reactions that no load explains end a run; those of a toggle near its dead point, large as they are, do not.
#include "simulation/reaction_watch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::State;

// Two links of 1 kg and 1 m between fixed hinges, at an angle from the line through these, with their weight.
std::string writeToggle(double angle) {
    const double x = std::cos(angle), y = std::sin(angle);
    return fmt::format(
        "toggle\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nMARKER/11,QP={4},0,0\n"
        "PART/2,MASS=1,CM=20,IP=0.1,0.1,0.1,REULER={0},0,0\nMARKER/20,QP=0.5,0,0\nMARKER/21\nMARKER/22,QP=1,0,0\n"
        "PART/3,MASS=1,CM=30,IP=0.1,0.1,0.1,QG={1},{2},0,REULER={3},0,0\nMARKER/30,QP=0.5,0,0\nMARKER/31\n"
        "MARKER/32,QP=1,0,0\n"
        "JOINT/1,REVOLUTE,I=21,J=10\nJOINT/2,REVOLUTE,I=31,J=22\nJOINT/3,REVOLUTE,I=32,J=11\nEND\n",
        angle, x, y, -angle, 2 * x);
}

class Toggles : public ::testing::TestWithParam<double> {};

// The thrust at the knee: its moment about the hinge of a link carries the link's weight, H sin(a) = m g cos(a)/2.
TEST_P(Toggles, NearTheirDeadPointRun) {
    constexpr double Relative = 1e-5;  // rounding errors of positions, 1e-16, over the angle, with room
    const Mechanism mechanism = testing::buildOrFail(writeToggle(GetParam()), {Formulation::Tree});
    const SimulationOutcome outcome = testing::run(mechanism, 1, 2, 1e-6);
    const double thrust = 9.81 / (2 * std::tan(GetParam()));
    for (const double reaction : outcome.results.reactions.getColumn("JOINT/2.I.FX"))
        EXPECT_NEAR(std::abs(reaction) / thrust, 1, Relative);
}

INSTANTIATE_TEST_SUITE_P(Angles, Toggles, ::testing::Values(1e-2, 1e-4, 1e-6));

// Where the thrust would be lost, or be more than any lever explains, the singular position is named.
TEST(ReactionWatch, AToggleTooNearItsDeadPointNamesTheSingularPosition) {
    for (const auto& [formulation, angle] : {std::pair(Formulation::Constraints, 1e-6)}) {
        const Mechanism mechanism = testing::buildOrFail(writeToggle(angle), {formulation});
        SimulationOptions options;
        options.end = 1;
        const SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
        EXPECT_NE(outcome.failure.find("close to a singular position"), std::string::npos) << outcome.failure;
        EXPECT_NE(outcome.failure.find("the accelerations violate JOINT/"), std::string::npos)
            << outcome.failure;
    }
}

// A lid on two hinges in the tree, its second hinge's equations in use though nothing is left of them but rounding
// errors: what a run would do that did not leave them out.
TEST(ReactionWatch, AMultiplierFoundByDividingByRoundingErrorsIsNamed) {
    const Mechanism mechanism = testing::buildOrFail(
        "lid\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/1,REULER=90D,90D,0\nMARKER/2,QP=1,0,0,REULER=90D,90D,0\n"
        "PART/2,MASS=10,CM=20,IP=1,2,3\nMARKER/20,QP=0.3,-0.2,0.5\nMARKER/21,REULER=90D,90D,0\n"
        "MARKER/22,QP=1,0,0,REULER=90D,90D,0\nJOINT/1,REVOLUTE,I=21,J=1\nJOINT/2,REVOLUTE,I=22,J=2\nEND\n",
        {Formulation::Tree});
    State state = assemble(mechanism).state;
    mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
    try {
        ReactionWatch(mechanism).check(state);
        FAIL() << "nothing was noticed";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("the reaction at JOINT/"), std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find("nothing explains it"), std::string::npos) << error.what();
    }
}

// At rest without any load there is nothing to hold a reaction against, and none to complain of.
TEST(ReactionWatch, AMechanismAtRestWithoutLoadsRuns) {
    std::string text = writeToggle(0.3);
    text.replace(text.find("JGRAV=-9.81"), 11, "JGRAV=0");
    EXPECT_EQ(testing::run(testing::buildOrFail(text), 1, 2, 1e-6).failure, "");
}

}  // namespace
}  // namespace jprim
