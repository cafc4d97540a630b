// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/orthogonal.h"

#include <Eigen/QR>

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd solveLeastNorm(const MatrixXd& A, const VectorXd& b, double threshold) {
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
    decomposition.setThreshold(threshold);
    return decomposition.compute(A).solve(b);
}

Eigen::Matrix3d calcPseudoInverse(const Eigen::Matrix3d& A) {
    return Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d>(A).pseudoInverse();
}

MatrixXd completeBasis(const MatrixXd& A) {
    return Eigen::HouseholderQR<MatrixXd>(A).householderQ();
}

MatrixXd calcOrthonormalizer(const MatrixXd& A) {
    const Eigen::HouseholderQR<MatrixXd> qr(A);
    MatrixXd inverse = MatrixXd::Identity(A.cols(), A.cols());
    qr.matrixQR().topRows(A.cols()).triangularView<Eigen::Upper>().solveInPlace(inverse);
    return inverse;
}

Eigen::VectorXi orderByIndependence(const MatrixXd& A) {
    return Eigen::ColPivHouseholderQR<MatrixXd>(A.transpose()).colsPermutation().indices();
}

}  // namespace jprim
