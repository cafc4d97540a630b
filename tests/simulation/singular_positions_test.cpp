// SPDX-License-Identifier: Apache-2.0
// Rows of four-bars pass through horizontal, where they have N + 1 freedoms for an instant.
#include <gtest/gtest.h>

#include <cmath>

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

struct Row {
    int fourBars;
    Formulation formulation;
    int steps;
};

class FourBars : public ::testing::TestWithParam<Row> {};

// On the smooth branch all links stay parallel and are one pendulum. How many output steps there are decides how near
// to the singular positions the integrator's steps end.
TEST_P(FourBars, FollowTheSmoothBranchThroughSingularPositions) {
    constexpr double Accuracy = 1e-8, AtTheEnd = 1e-4, OfTheEnergy = 1e-3;
    const auto [fourBars, formulation, steps] = GetParam();
    const Mechanism mechanism = testing::buildOrFail(testing::writeFourBars(fourBars), {formulation});
    const SimulationOutcome outcome = testing::run(mechanism, End, steps, Accuracy);
    const double angle = testing::calcFourBarsAngle(fourBars, End);
    const Vec3 exact(std::sin(angle), std::cos(angle), 0);
    EXPECT_LT((findTop(mechanism, outcome.finalState) - exact).norm(), AtTheEnd);
    EXPECT_LT(outcome.summary.largestEnergyChange, OfTheEnergy * outcome.summary.energyScale);
}

INSTANTIATE_TEST_SUITE_P(Tree, FourBars,
                         ::testing::Values(Row{1, Formulation::Tree, 100}, Row{1, Formulation::Tree, 2000},
                                           Row{2, Formulation::Tree, 37}, Row{2, Formulation::Tree, 2000},
                                           Row{5, Formulation::Tree, 100}, Row{5, Formulation::Tree, 311}));
INSTANTIATE_TEST_SUITE_P(Constraints, FourBars,
                         ::testing::Values(Row{1, Formulation::Constraints, 100},
                                           Row{2, Formulation::Constraints, 37}));

// The figure of the benchmark's own solution for N = 2.
TEST(FourBarsReference, ThePendulumIsTheSmoothBranch) {
    const double angle = testing::calcFourBarsAngle(2, End);
    EXPECT_NEAR(std::sin(angle), 0.32845811, 1e-8);
    EXPECT_NEAR(std::cos(angle), 0.94451854, 1e-8);
}

}  // namespace
}  // namespace jprim
