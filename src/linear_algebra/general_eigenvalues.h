// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_LINEAR_ALGEBRA_GENERAL_EIGENVALUES_H_
#define JPRIM_SRC_LINEAR_ALGEBRA_GENERAL_EIGENVALUES_H_

#include <Eigen/Core>

namespace jprim {

/// A x = lambda x and y* A = lambda y* of a real matrix, which need not have as many eigenvectors as eigenvalues: of one
/// that is defective those of a matrix nearby.
struct GeneralEigenvectors {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd right;    ///< x as columns
    Eigen::MatrixXcd left;     ///< y as columns
    Eigen::VectorXd products;  ///< |y* x|, and at least the smallest number there is
    Eigen::VectorXd rounding;  ///< how far rounding errors may have moved each eigenvalue, to first order

    /// How far errors of A's entries, up to the given ones, may move an eigenvalue, to first order.
    double calcShift(Eigen::Index k, const Eigen::MatrixXd& errors) const;
};
GeneralEigenvectors calcGeneralEigenvectors(const Eigen::MatrixXd& A);

}  // namespace jprim

#endif
