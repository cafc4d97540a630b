// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/equations.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd solveSymmetric(const MatrixXd& A, const VectorXd& b) {
    return A.ldlt().solve(b);
}

std::optional<VectorXd> solveDefinite(const MatrixXd& A, const VectorXd& b) {
    const Eigen::LLT<MatrixXd> factor(A);
    if (factor.info() != Eigen::Success) return std::nullopt;
    return VectorXd(factor.solve(b));
}

bool isPositiveDefinite(const MatrixXd& A) {
    return Eigen::LLT<MatrixXd>(A).info() == Eigen::Success;
}

MatrixXd calcCholeskyFactor(const MatrixXd& A) {
    return Eigen::LLT<MatrixXd>(A).matrixL();
}

MatrixXd calcKernel(const MatrixXd& A, double threshold) {
    Eigen::FullPivLU<MatrixXd> lu;
    lu.setThreshold(threshold);
    lu.compute(A);
    return lu.dimensionOfKernel() > 0 ? MatrixXd(lu.kernel()) : MatrixXd(A.cols(), 0);
}

}  // namespace jprim
