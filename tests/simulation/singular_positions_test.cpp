// SPDX-License-Identifier: Apache-2.0
// Rows of four-bars pass through horizontal, where they have N + 1 freedoms for an instant.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/failure.h"
#include "support/four_bars.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Vec3;

constexpr double End = 10;
constexpr int Top = 2002;  // the marker at the top of the first rocker

Vec3 findTop(const Mechanism& mechanism, const SimTK::State& state) {
    mechanism.getSystem().realize(state, SimTK::Stage::Position);
    return mechanism.getMarker(Top).findPoseInGround(state).p();
}

Vec3 calcExactTop(int fourBars, double time, double start = 0) {
    const double angle = testing::calcFourBarsAngle(fourBars, time, start);
    return {std::sin(angle), std::cos(angle), 0};
}

struct Row {
    int fourBars;
    Formulation formulation;
    int steps;
    double accuracy = 1e-8;
};

class FourBars : public ::testing::TestWithParam<Row> {};

// On the smooth branch all links stay parallel and are one pendulum. How many output steps there are decides how near
// to the singular positions the integrator's steps end; with a tight accuracy it gets stuck there.
TEST_P(FourBars, FollowTheSmoothBranchThroughSingularPositions) {
    constexpr double AtTheEnd = 1e-3, OfTheEnergy = 1e-3;
    const auto [fourBars, formulation, steps, accuracy] = GetParam();
    const Mechanism mechanism = testing::buildOrFail(testing::writeFourBars(fourBars), {formulation});
    const SimulationOutcome outcome = testing::run(mechanism, End, steps, accuracy);
    EXPECT_LT((findTop(mechanism, outcome.finalState) - calcExactTop(fourBars, End)).norm(), AtTheEnd);
    EXPECT_LT(outcome.summary.largestEnergyChange, OfTheEnergy * outcome.summary.energyScale);
}

INSTANTIATE_TEST_SUITE_P(Tree, FourBars,
                         ::testing::Values(Row{1, Formulation::Tree, 100}, Row{1, Formulation::Tree, 2000},
                                           Row{2, Formulation::Tree, 37}, Row{2, Formulation::Tree, 2000},
                                           Row{5, Formulation::Tree, 100}, Row{5, Formulation::Tree, 311},
                                           Row{5, Formulation::Tree, 173, 1e-9},
                                           Row{2, Formulation::Tree, 1, 1e-10},
                                           Row{5, Formulation::Tree, 37, 1e-10}));
INSTANTIATE_TEST_SUITE_P(Constraints, FourBars,
                         ::testing::Values(Row{1, Formulation::Constraints, 100},
                                           Row{2, Formulation::Constraints, 37}));

// In the singular position itself the velocity alone says which way to go.
TEST(SingularPositions, ARunMayStartInOne) {
    constexpr double AtTheEnd = 1e-5, OfTheEnergy = 1e-3;
    const double Horizontal = SimTK::Pi / 2;
    for (const double angle : {0., 1e-12, -1e-9, -1e-6, 1e-5}) {
        const Mechanism mechanism = testing::buildOrFail(testing::writeFourBars(2, Horizontal + angle));
        const SimulationOutcome outcome = testing::run(mechanism, 1, 3, 1e-8);
        const Vec3 exact = calcExactTop(2, 1, Horizontal + angle);
        EXPECT_LT((findTop(mechanism, outcome.finalState) - exact).norm(), AtTheEnd) << angle;
        EXPECT_LT(outcome.summary.largestEnergyChange, OfTheEnergy * outcome.summary.energyScale) << angle;
    }
}

void expectThrownOff(const SimulationOutcome& outcome, const std::string& start) {
    EXPECT_EQ(outcome.failure.find(start), 0u) << outcome.failure;
    EXPECT_NE(
        outcome.failure.find(" of the kinetic energy has come from nowhere or is lost within a step near a "
                             "singular position, and with it the motion through that"),
        std::string::npos)
        << outcome.failure;
}

SimulationOutcome runCoarsely(const std::string& text, double accuracy) {
    const Mechanism mechanism = testing::buildOrFail(text, {Formulation::Tree});
    SimulationOptions options;
    options.end = End;
    options.steps = 1;
    options.accuracy = accuracy;
    return simulate(mechanism, assemble(mechanism), options);
}

// A brake on the first rocker, so that the energy is not kept.
std::string writeBrakedFourBars(int n, const std::string& damping) {
    std::string text = testing::writeFourBars(n);
    const std::string brake = "SFORCE/1,ROTATION,I=2001,J=1,FUNCTION=-" + damping + "*WZ(2001,1,1)\n";
    return text.insert(text.find("JOINT/1,"), brake);
}

// Steps of a tenth of a second overlook the singular position, and what they find behind it is not the motion.
TEST(SingularPositions, ARunThatIsThrownOffItsMotionStops) {
    expectThrownOff(runCoarsely(testing::writeFourBars(1), 0.1), "at time 0.7");
    expectThrownOff(runCoarsely(writeBrakedFourBars(2, "0.05"), 0.1), "at time 0.7");
}

// Work and kinetic energy tell at which accuracy a run that brakes can be trusted.
TEST(SingularPositions, ARunWithABrakeKeepsItsBalance) {
    constexpr double Tolerable = 1e-3;
    const std::string text = writeBrakedFourBars(2, "0.01");
    const Mechanism mechanism = testing::buildOrFail(text);
    const SimulationSummary fine = testing::run(mechanism, End, 37, 1e-6).summary;
    EXPECT_GT(fine.energyAtStart - fine.energyAtEnd, 1);
    EXPECT_LT(fine.largestImbalance, Tolerable * fine.energyScale);
    const SimulationSummary coarse = runCoarsely(text, 0.05).summary;
    EXPECT_GT(coarse.largestImbalance, Tolerable * coarse.energyScale);
}

std::string describeFailureAtAngle(int fourBars, Formulation formulation, double fromHorizontal) {
    const Mechanism mechanism = testing::buildOrFail(
        testing::writeFourBars(fourBars, 0.5 * SimTK::Pi + fromHorizontal), {formulation});
    const SimTK::State state = assemble(mechanism).state;
    return describeFailure(mechanism, state,
                           std::runtime_error("Integrator step failed: Unable to advance time past 0."));
}

TEST(SingularPositions, AFailureThereNamesThem) {
    const std::string end = "the integrator does not meet its accuracy however short its steps are";
    for (const Formulation formulation : {Formulation::Tree, Formulation::Constraints}) {
        const std::string at = describeFailureAtAngle(2, formulation, 0);
        const std::string close = describeFailureAtAngle(2, formulation, 1e-4);
        const std::string far = describeFailureAtAngle(2, formulation, 0.5);
        EXPECT_NE(at.find("this is a singular position with 3 degrees of freedom, where nearby there are 1"),
                  std::string::npos)
            << at;
        EXPECT_NE(close.find("this is close to a singular position (smallest singular value "),
                  std::string::npos)
            << close;
        EXPECT_EQ(far.find("singular"), std::string::npos) << far;
        for (const std::string& text : {at, close, far})
            EXPECT_EQ(text.substr(text.size() - end.size()), end) << text;
    }
}

// The figure of the benchmark's own solution for N = 2.
TEST(FourBarsReference, ThePendulumIsTheSmoothBranch) {
    EXPECT_LT((calcExactTop(2, End) - Vec3(0.32845811, 0.94451854, 0)).norm(), 1e-8);
}

}  // namespace
}  // namespace jprim
