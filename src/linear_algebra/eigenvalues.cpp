// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/eigenvalues.h"

#include <Eigen/Eigenvalues>

namespace jprim {

using Eigen::Matrix3d;
using Eigen::MatrixXd;

Eigenvectors calcEigenvectors(const MatrixXd& A) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(A);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

std::optional<Eigenvectors> calcEigenvectors(const MatrixXd& A, const MatrixXd& B) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(A, B);
    if (solver.info() != Eigen::Success) return std::nullopt;
    return Eigenvectors{solver.eigenvalues(), solver.eigenvectors()};
}

PrincipalAxes calcPrincipalAxes(const Matrix3d& tensor) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(tensor);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::Vector3d calcPrincipalValues(const Matrix3d& tensor) {
    return Eigen::SelfAdjointEigenSolver<Matrix3d>(tensor, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace jprim
