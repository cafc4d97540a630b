// SPDX-License-Identifier: Apache-2.0
// Euler parameters of a part go on without jumps, however often it turns: in one run, and from command to command.
#include <cmath>

#include "jprim/dataset/commands.h"
#include "jprim/simulation/run_commands.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

// Three turns in a second.
const char* const Wheel =
    "wheel\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\nMARKER/20\n"
    "JOINT/1,REVOLUTE,I=20,J=10\nMOTION/1,JOINT=1,FUNCTION=6*PI*TIME\nEND\n";

// Of each row with the one before, the cosine of half the turn between them; they would be negative at a jump.
double findLeastCosine(const Results& results) {
    std::vector<double> e[4];
    for (int k = 0; k < 4; ++k) e[k] = results.parts.getColumn("PART/2.E" + std::to_string(k));
    double least = 1;
    for (size_t row = 1; row < e[0].size(); ++row) {
        double cosine = 0;
        for (const auto& component : e) cosine += component[row] * component[row - 1];
        least = std::min(least, cosine);
    }
    return least;
}

TEST(EulerParameters, KeepTheirSignOverTurns) {
    const SimulationOutcome outcome = testing::run(testing::buildOrFail(Wheel), 1, 60, 1e-8);
    ASSERT_EQ(outcome.results.parts.getNumRows(), 61u);
    EXPECT_NEAR(findLeastCosine(outcome.results), std::cos(SimTK_PI / 20), 1e-9);
    // After three turns the orientation is the first one, and the parameters are opposite.
    EXPECT_NEAR(outcome.results.parts.getColumn("PART/2.E0").front(), 1, 1e-9);
    EXPECT_NEAR(outcome.results.parts.getColumn("PART/2.E0").back(), -1, 1e-9);
}

TEST(EulerParameters, KeepTheirSignFromCommandToCommand) {
    Diagnostics diagnostics;
    const CommandFile file = readCommands(
        "model\n\nSIMULATE/KINEMATICS, END=0.35, STEPS=21\nSIMULATE/KINEMATICS, END=1, STEPS=39\nSTOP\n",
        diagnostics);
    ASSERT_EQ(testing::formatAll(diagnostics), "");
    const Mechanism mechanism = testing::buildOrFail(Wheel);
    const CommandsOutcome outcome = runCommands(mechanism, file.commands, {});
    EXPECT_EQ(outcome.failure, "");
    ASSERT_EQ(outcome.results.parts.getNumRows(), 61u);
    EXPECT_GT(findLeastCosine(outcome.results), 0.98);
}

}  // namespace
}  // namespace jprim
