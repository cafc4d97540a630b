// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/rank.h"

#include <gtest/gtest.h>

namespace jprim {
namespace {

using Eigen::MatrixXd;

// Where the widest gap is, there is the rank, at whatever size.
TEST(RankDecision, CutsAtTheWidestGap) {
    EXPECT_EQ(decideRank({}).rank, 0);
    EXPECT_EQ(decideRank({1.3, 0.2}).rank, 2);
    EXPECT_EQ(decideRank({1.3, 0.2, 1e-9}).rank, 2);    // an assembly to 1e-9
    EXPECT_EQ(decideRank({1.3, 1e-5}).rank, 2);         // small, alone, and well above rounding
    EXPECT_EQ(decideRank({1.3, 1e-5, 1e-13}).rank, 2);  // small beside what is smaller by far
    EXPECT_EQ(decideRank({1.3, 1e-5, 3e-6, 1e-16}).rank, 3);
    EXPECT_EQ(decideRank({1.3, 1e-3, 2e-4}).rank, 3);  // a gap among large values is none
    const RankDecision decision = decideRank({1.3, 0.2, 1e-9, 1e-12});
    EXPECT_EQ(decision.smallestKept, 0.2);
    EXPECT_EQ(decision.largestDropped, 1e-9);
}

// Any single tolerance errs on one of these two.
TEST(RankDecision, NoToleranceWouldDo) {
    const std::vector<double> loose = {1, 0.1, 1e-9, 1e-11},
                              stretched = {1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-16};
    EXPECT_EQ(decideRank(loose).rank, 2);
    EXPECT_EQ(decideRank(stretched).rank, 6);
}

TEST(Blocks, HangTogetherByEntries) {
    MatrixXd A = MatrixXd::Zero(4, 5);
    A(0, 1) = A(2, 1) = A(2, 4) = 1;
    A(1, 0) = 2;
    const std::vector<Block> blocks = findBlocks(A);
    ASSERT_EQ(blocks.size(), 3u);
    EXPECT_EQ(blocks[0].rows, (std::vector<int>{0, 2}));
    EXPECT_EQ(blocks[0].columns, (std::vector<int>{1, 4}));
    EXPECT_EQ(blocks[1].rows, std::vector<int>{1});
    EXPECT_EQ(blocks[2].rows, std::vector<int>{3});
    EXPECT_TRUE(blocks[2].columns.empty());
}

// Rows 2 = 2 (row 0) - (row 1), 4 = (row 1) + 3 (row 3), 5 = 0, 6 = row 2 + row 4.
TEST(DependentRows, AreTheLaterOnesAndSayOnWhat) {
    MatrixXd A = MatrixXd::Zero(7, 4);
    A.row(0) << 1, 2, 0.5, 0;
    A.row(1) << 0, 1, -1, 0.3;
    A.row(3) << 2, 0, 0, 1;
    A.row(2) = 2 * A.row(0) - A.row(1);
    A.row(4) = A.row(1) + 3 * A.row(3);
    A.row(6) = A.row(2) + A.row(4);
    const Decomposition decomposition(A, Decomposition::Vectors::Both);
    EXPECT_EQ(decomposition.getRank(), 3);
    const std::vector<DependentRow> dependent = findDependentRows(decomposition.calcLeftNullSpace());
    ASSERT_EQ(dependent.size(), 4u);
    const std::vector<std::pair<int, std::vector<int>>> expected = {
        {2, {0, 1}}, {4, {1, 3}}, {5, {}}, {6, {0, 3}}};
    for (size_t k = 0; k < expected.size(); ++k) {
        EXPECT_EQ(dependent[k].row, expected[k].first);
        EXPECT_EQ(dependent[k].on, expected[k].second);
    }
    EXPECT_LT((A * decomposition.calcRandomNullVector(3)).norm(), 1e-14);
    EXPECT_GT(decomposition.calcRandomNullVector(3).norm(), 0.99);
}

}  // namespace
}  // namespace jprim
