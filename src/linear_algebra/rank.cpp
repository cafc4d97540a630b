// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/rank.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>

#include "linear_algebra/random_vector.h"
#include "linear_algebra/singular_values.h"

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;

//---------------------------------------------------------------------------------------- blocks
namespace {

// Representatives of sets that are merged one by one.
class Sets {
public:
    explicit Sets(int size) : m_parent(size_t(size)) { std::iota(m_parent.begin(), m_parent.end(), 0); }
    int find(int i) {
        while (m_parent[size_t(i)] != i) i = m_parent[size_t(i)] = m_parent[size_t(m_parent[size_t(i)])];
        return i;
    }
    void merge(int i, int j) { m_parent[size_t(find(i))] = find(j); }

private:
    std::vector<int> m_parent;
};

}  // namespace

std::vector<Block> findBlocks(const MatrixXd& A) {
    const int m = int(A.rows()), n = int(A.cols());
    Sets sets(m + n);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < m; ++i)
            if (A(i, j) != 0) sets.merge(i, m + j);
    std::vector<Block> blocks;
    std::vector<int> blockOf(size_t(m + n), -1);
    for (int i = 0; i < m; ++i) {
        int& block = blockOf[size_t(sets.find(i))];
        if (block < 0) {
            block = int(blocks.size());
            blocks.emplace_back();
        }
        blocks[size_t(block)].rows.push_back(i);
    }
    for (int j = 0; j < n; ++j) {
        const int block = blockOf[size_t(sets.find(m + j))];
        if (block >= 0) blocks[size_t(block)].columns.push_back(j);
    }
    return blocks;
}

//------------------------------------------------------------------------------------------ rank
RankDecision decideRank(const std::vector<double>& values, double uncertainty) {
    // Between these a value counts or not depending on its neighbours. The square root of Zero is thus the
    // size at which a value that stands alone is in doubt: halfway between 1 and what rounding leaves.
    constexpr double Ordinary = 1, AlwaysKept = 1e-4, Zero = 1e-14;
    RankDecision decision;
    double widest = 0;
    for (size_t r = 0; r <= values.size(); ++r) {
        const double kept = r > 0 ? values[r - 1] : Ordinary, dropped = r < values.size() ? values[r] : 0;
        if (kept <= std::max(Zero, uncertainty)) break;
        const double ratio = kept / (dropped > uncertainty ? std::max(dropped, Zero) : Zero);
        if (dropped > std::max(AlwaysKept, uncertainty) || ratio <= widest) continue;
        widest = ratio;
        decision = {int(r), r > 0 ? kept : 0, dropped};
    }
    return decision;
}

Decomposition::Decomposition(const MatrixXd& A, Vectors vectors, double uncertainty)
    : m_numRows(int(A.rows())), m_numColumns(int(A.cols())), m_blocks(findBlocks(A)) {
    std::vector<double> all;
    for (const Block& block : m_blocks) {
        if (block.columns.empty()) {
            m_values.emplace_back();
            m_leftNull.push_back(MatrixXd::Identity(1, 1));
            m_rightNull.emplace_back(0, 0);
            continue;
        }
        const MatrixXd part = A(block.rows, block.columns);
        const SingularValues svd =
            vectors == Vectors::Both ? decompose(part) : SingularValues{calcSingularValues(part), {}, {}};
        m_values.push_back(svd.values);
        all.insert(all.end(), svd.values.begin(), svd.values.end());
        m_leftNull.push_back(svd.U);
        m_rightNull.push_back(svd.V);
    }
    std::sort(all.begin(), all.end(), std::greater<>());
    m_decision = decideRank(all, uncertainty);
    if (vectors == Vectors::Both) keepNullSpaces();
}

void Decomposition::keepNullSpaces() {
    for (size_t b = 0; b < m_blocks.size(); ++b) {
        const VectorXd& values = m_values[b];
        const auto isKept = [this](double value) {
            return m_decision.rank > 0 && value >= m_decision.smallestKept;
        };
        const auto rank = std::count_if(values.begin(), values.end(), isKept);
        m_leftNull[b] = MatrixXd(m_leftNull[b].rightCols(m_leftNull[b].cols() - rank));
        m_rightNull[b] = MatrixXd(m_rightNull[b].rightCols(m_rightNull[b].cols() - rank));
    }
}

MatrixXd Decomposition::calcLeftNullSpace() const {
    MatrixXd space = MatrixXd::Zero(m_numRows, m_numRows - getRank());
    int first = 0;
    for (size_t b = 0; b < m_blocks.size(); ++b) {
        const int count = int(m_leftNull[b].cols());
        space(m_blocks[b].rows, Eigen::seqN(first, count)) = m_leftNull[b];
        first += count;
    }
    return space;
}

MatrixXd Decomposition::calcRightNullSpace(const std::vector<int>& blocks) const {
    int size = 0;
    for (const int b : blocks) size += getNullity(b);
    MatrixXd space = MatrixXd::Zero(m_numColumns, size);
    int first = 0;
    for (const int b : blocks) {
        space(m_blocks[size_t(b)].columns, Eigen::seqN(first, getNullity(b))) = m_rightNull[size_t(b)];
        first += getNullity(b);
    }
    return space;
}

VectorXd Decomposition::calcRandomNullVector(unsigned seed) const {
    std::mt19937 generator(seed);
    VectorXd y = VectorXd::Zero(m_numColumns);
    for (size_t b = 0; b < m_blocks.size(); ++b) {
        if (m_rightNull[b].cols() == 0) continue;
        const VectorXd part = m_rightNull[b] * makeRandomVector(m_rightNull[b].cols(), generator);
        y(m_blocks[b].columns) = part / part.lpNorm<Eigen::Infinity>();
    }
    return y;
}

//---------------------------------------------------------------------------------- dependencies
// The null space is brought to echelon form from its last row upwards: a row whose entries in the columns
// left over are not all zero is the last of some vanishing combination of rows, so it depends on those before
// it. A reflection leaves one column with an entry there. In the end the columns are cleared of each other's
// rows, and each reads: this row plus independent ones is zero.
std::vector<DependentRow> findDependentRows(MatrixXd N, double uncertainty) {
    constexpr double Errors = 1e-6;
    const double negligible = std::max(Errors, uncertainty);  // entries of unit vectors
    std::vector<DependentRow> dependent;
    int left = int(N.cols());
    for (int row = int(N.rows()) - 1; row >= 0 && left > 0; --row) {
        const VectorXd entries = N.row(row).head(left);
        if (entries.norm() < negligible) continue;
        VectorXd normal = entries;
        normal[left - 1] += std::copysign(entries.norm(), entries[left - 1]);
        normal.normalize();
        const VectorXd image = N.leftCols(left) * normal;
        N.leftCols(left) -= 2 * image * normal.transpose();
        N.row(row).head(left - 1).setZero();
        dependent.push_back({row, {}});
        --left;
    }
    // Rows were found from last to first, and the k-th found owns the k-th column from the end.
    std::reverse(dependent.begin(), dependent.end());
    N = MatrixXd(N.rightCols(int(dependent.size())));
    for (int k = 0; k < int(dependent.size()); ++k) {
        for (int earlier = 0; earlier < k; ++earlier) {
            const int row = dependent[size_t(earlier)].row;
            N.col(k) -= N.col(earlier) * (N(row, k) / N(row, earlier));
            N(row, k) = 0;
        }
        const double largest = N.col(k).lpNorm<Eigen::Infinity>();
        for (int i = 0; i < dependent[size_t(k)].row; ++i)
            if (std::abs(N(i, k)) > negligible * largest) dependent[size_t(k)].on.push_back(i);
    }
    return dependent;
}

}  // namespace jprim
