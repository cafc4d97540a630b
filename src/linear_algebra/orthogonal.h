// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_LINEAR_ALGEBRA_ORTHOGONAL_H_
#define JPRIM_SRC_LINEAR_ALGEBRA_ORTHOGONAL_H_

#include <Eigen/Core>

/// @file
/// What is done by reflections.
namespace jprim {

/// The smallest of the x that come nearest to A x = b.
/// @param threshold  of the largest pivot: smaller ones are zero
Eigen::VectorXd solveLeastNorm(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double threshold);

/// The same for the columns of the unit matrix.
Eigen::Matrix3d calcPseudoInverse(const Eigen::Matrix3d& A);

/// An orthogonal matrix whose first columns span those of A, which are independent.
Eigen::MatrixXd completeBasis(const Eigen::MatrixXd& A);

/// The upper triangular S with orthonormal columns of A S.
Eigen::MatrixXd calcOrthonormalizer(const Eigen::MatrixXd& A);

/// The rows of A in the order of an elimination that always takes next what is most independent of those before.
Eigen::VectorXi orderByIndependence(const Eigen::MatrixXd& A);

}  // namespace jprim

#endif
