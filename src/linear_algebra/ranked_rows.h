// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_LINEAR_ALGEBRA_RANKED_ROWS_H_
#define JPRIM_SRC_LINEAR_ALGEBRA_RANKED_ROWS_H_

#include <Eigen/Core>

namespace jprim {

/// A matrix whose ordinary rows are of size one, and its rank, decided as by Decomposition but on the pivots of an
/// elimination: for much less work.
class RankedRows {
public:
    explicit RankedRows(const Eigen::MatrixXd& A);

    /// An orthonormal basis.
    Eigen::MatrixXd calcNullSpace() const;
    /// The smallest of the x that come nearest to A x = b.
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    /// The matrix of solve().
    Eigen::MatrixXd calcPseudoInverse() const;
    /// The smallest of the y that come nearest to ~A y = f.
    Eigen::VectorXd solveTransposed(const Eigen::VectorXd& f) const;

private:
    Eigen::MatrixXd m_Q,
        m_L;  // A = L ~Q, where Q's first columns span the rows and the others the null space
};

}  // namespace jprim

#endif
