// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/singular_values.h"

#include <Eigen/SVD>

namespace jprim {

using Eigen::MatrixXd;

namespace {

// Compiled once: no other template of Eigen takes the compiler as long.
Eigen::BDCSVD<MatrixXd> solve(const MatrixXd& A, int options) {
    return Eigen::BDCSVD<MatrixXd>(A, options);
}

}  // namespace

SingularValues decompose(const MatrixXd& A) {
    const Eigen::BDCSVD<MatrixXd> svd = solve(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {svd.singularValues(), svd.matrixU(), svd.matrixV()};
}

Eigen::VectorXd calcSingularValues(const MatrixXd& A) {
    return solve(A, 0).singularValues();
}

}  // namespace jprim
