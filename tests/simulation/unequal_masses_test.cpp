// SPDX-License-Identifier: Apache-2.0
// Parts of grams beside parts of hundreds of kilograms, moments of inertia over seven decades, joints doubled, in
// millimetres: by constraints, where Simbody has to tell dependent equations from those of heavy parts, as in a tree,
// where there are hardly any equations.
#include <gtest/gtest.h>

#include "support/random_dataset.h"
#include "support/run_dataset.h"
#include "support/two_routes.h"

namespace jprim {
namespace {

constexpr double Agreement =
    1e-6;  // of both integrations together, relative to the largest value of the table

Results runFormulation(const std::string& text, Formulation formulation) {
    constexpr double End = 0.02, Accuracy = 1e-9;
    return testing::run(testing::buildOrFail(text, {formulation}), End, 2, Accuracy).results;
}

class UnequalMasses : public ::testing::TestWithParam<int> {};

TEST_P(UnequalMasses, AreSolvedForInBothFormulations) {
    constexpr int PerGroup = 25;
    int compared = 0;
    for (int k = 0; compared < PerGroup && k < 20 * PerGroup; ++k) {
        const unsigned seed = unsigned(7000 + 1000 * GetParam() + k);
        const testing::DoubledDataset dataset =
            testing::RandomDataset(seed, {4, 7, true}).writeDoubled(2 + k % 7, k % 2);
        if (dataset.doubles.empty() || !testing::isDetermined(dataset.single)) continue;
        ++compared;
        const Results tree = runFormulation(dataset.doubled, Formulation::Tree);
        const Results constraints = runFormulation(dataset.doubled, Formulation::Constraints);
        EXPECT_LE(testing::findDifference(tree.parts, constraints.parts), Agreement);
        ASSERT_FALSE(HasFailure()) << seed << "\n" << dataset.doubled;
    }
    EXPECT_EQ(compared, PerGroup);
}

INSTANTIATE_TEST_SUITE_P(Groups, UnequalMasses, ::testing::Range(0, 8));

}  // namespace
}  // namespace jprim
