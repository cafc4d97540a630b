// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_LINEAR_ALGEBRA_EQUATIONS_H_
#define JPRIM_SRC_LINEAR_ALGEBRA_EQUATIONS_H_

#include <Eigen/Core>
#include <optional>

namespace jprim {

/// A x = b of a symmetric matrix that is definite, or nearly.
Eigen::VectorXd solveSymmetric(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// A x = b of a symmetric matrix; nothing if it is not positive definite.
std::optional<Eigen::VectorXd> solveDefinite(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

bool isPositiveDefinite(const Eigen::MatrixXd& A);

/// F with F ~F = A and nothing above the diagonal, of a positive definite matrix.
Eigen::MatrixXd calcCholeskyFactor(const Eigen::MatrixXd& A);

/// Some basis of the x with A x = 0, by columns.
/// @param threshold  of the largest pivot: smaller ones are zero
Eigen::MatrixXd calcKernel(const Eigen::MatrixXd& A, double threshold);

}  // namespace jprim

#endif
