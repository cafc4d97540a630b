// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_LINEAR_ALGEBRA_RANK_H_
#define JPRIM_SRC_LINEAR_ALGEBRA_RANK_H_

#include <Eigen/Core>
#include <vector>

namespace jprim {

/// Rows and columns of a matrix that hang together by nonzero entries, and with no others. A row of zeros is
/// a block without columns; columns of zeros are in none.
struct Block {
    std::vector<int> rows;
    std::vector<int> columns;
};
std::vector<Block> findBlocks(const Eigen::MatrixXd& A);

/// How many singular values count.
struct RankDecision {
    int rank = 0;
    double smallestKept = 0;    ///< 0 if none is
    double largestDropped = 0;  ///< 0 if none is
};
/// Cuts where the ratio of a singular value to the next is largest; before the first stands 1, the size of an equation
/// that does something.
/// @param values       in descending order
/// @param uncertainty  up to which they are zero; 0: up to rounding
RankDecision decideRank(const std::vector<double>& values, double uncertainty = 0);

/// Singular values and null spaces of a matrix, found block by block.
class Decomposition {
public:
    enum class Vectors { None, Both };
    Decomposition(const Eigen::MatrixXd& A, Vectors vectors, double uncertainty = 0);

    const RankDecision& getDecision() const { return m_decision; }
    int getRank() const { return m_decision.rank; }

    const std::vector<Block>& getBlocks() const { return m_blocks; }
    /// Dimension of a block's right null space. Vectors::Both.
    int getNullity(int block) const { return int(m_rightNull[size_t(block)].cols()); }
    /// Orthonormal x with ~x A = 0, by columns. Vectors::Both.
    Eigen::MatrixXd calcLeftNullSpace() const;
    /// Orthonormal y with A y = 0 of some of the blocks, by columns. Vectors::Both.
    Eigen::MatrixXd calcRightNullSpace(const std::vector<int>& blocks) const;
    /// A vector y with A y = 0 that has a random part in every block, with largest entry 1 there, and 0 in
    /// columns of zeros. The same for the same seed. Vectors::Both.
    Eigen::VectorXd calcRandomNullVector(unsigned seed) const;

private:
    void keepNullSpaces();

    int m_numRows, m_numColumns;
    std::vector<Block> m_blocks;
    RankDecision m_decision;
    std::vector<Eigen::VectorXd> m_values;                 // singular values of each block
    std::vector<Eigen::MatrixXd> m_leftNull, m_rightNull;  // of each block; at first all singular vectors
};

/// A row that is a combination of others.
struct DependentRow {
    int row = 0;
    std::vector<int> on;  ///< the others with a coefficient that is not zero
};

/// From an orthonormal basis of the left null space: which rows depend on rows before them and are not needed,
/// and each one's unique combination of those that are. Rows ascend.
/// @param uncertainty  of the basis's entries; 0: rounding
std::vector<DependentRow> findDependentRows(Eigen::MatrixXd leftNullSpace, double uncertainty = 0);

}  // namespace jprim

#endif
