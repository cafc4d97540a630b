// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/orthogonal.h"

#include <Eigen/QR>

#include "linear_algebra/singular_values.h"

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd solveLeastNorm(const MatrixXd& A, const VectorXd& b, double threshold) {
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
    decomposition.setThreshold(threshold);
    return decomposition.compute(A).solve(b);
}

Eigen::Matrix3d calcPseudoInverse(const Eigen::Matrix3d& A) {
    constexpr double Rounding = 1e-15;
    const SingularValues svd = decompose(A);
    VectorXd inverse = VectorXd::Zero(3);
    for (int k = 0; k < 3; ++k)
        if (svd.values[k] > Rounding * svd.values[0]) inverse[k] = 1 / svd.values[k];
    return svd.V * inverse.asDiagonal() * svd.U.transpose();
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
