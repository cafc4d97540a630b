// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_LINEAR_ALGEBRA_EIGENVALUES_H_
#define JPRIM_SRC_LINEAR_ALGEBRA_EIGENVALUES_H_

#include <Eigen/Core>
#include <optional>

namespace jprim {

struct Eigenvectors {
    Eigen::VectorXd values;   ///< ascending
    Eigen::MatrixXd vectors;  ///< as columns
};

/// Of a symmetric matrix.
Eigenvectors calcEigenvectors(const Eigen::MatrixXd& A);

/// A x = lambda B x of symmetric A and positive definite B, ~x B x = 1. Nothing if the iteration does not converge.
std::optional<Eigenvectors> calcEigenvectors(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// A symmetric tensor by its principal axes.
struct PrincipalAxes {
    Eigen::Vector3d values;  ///< ascending
    Eigen::Matrix3d axes;    ///< as columns
};
PrincipalAxes calcPrincipalAxes(const Eigen::Matrix3d& tensor);

/// The values alone.
Eigen::Vector3d calcPrincipalValues(const Eigen::Matrix3d& tensor);

}  // namespace jprim

#endif
