// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/general_eigenvalues.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace jprim {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

namespace {

constexpr double Epsilon = std::numeric_limits<double>::epsilon();

// Powers of 2 in D such that rows and columns of D^-1 A D are of like size. Source: B. N. Parlett and C. Reinsch,
// Balancing a matrix for calculation of eigenvalues and eigenvectors, Numer. Math. 13 (1969).
VectorXd balance(MatrixXd& A) {
    constexpr double Enough = 0.95;
    VectorXd D = VectorXd::Ones(A.rows());
    for (bool changed = true; changed;) {
        changed = false;
        for (Index i = 0; i < A.rows(); ++i) {
            const double diagonal = std::abs(A(i, i));
            const double column = A.col(i).lpNorm<1>() - diagonal, row = A.row(i).lpNorm<1>() - diagonal;
            if (!(column > 0 && row > 0)) continue;
            const double factor = std::exp2(std::round(std::log2(row / column) / 2));
            if (factor == 1 || column * factor + row / factor > Enough * (column + row)) continue;
            D[i] *= factor;
            A.col(i) *= factor;
            A.row(i) /= factor;
            changed = true;
        }
    }
    return D;
}

std::complex<double> avoidZero(const std::complex<double>& pivot, double least) {
    return std::abs(pivot) < least ? std::complex<double>(least) : pivot;
}

// (T - T_kk) x = 0 by substitution upwards from x_k = 1.
VectorXcd calcRight(const MatrixXcd& T, Index k, double least) {
    VectorXcd x = VectorXcd::Zero(T.rows());
    x[k] = 1;
    for (Index i = k - 1; i >= 0; --i) {
        const std::complex<double> sum =
            T.row(i).segment(i + 1, k - i).transpose().cwiseProduct(x.segment(i + 1, k - i)).sum();
        x[i] = -sum / avoidZero(T(i, i) - T(k, k), least);
    }
    return x.normalized();
}

// y* (T - T_kk) = 0 downwards.
VectorXcd calcLeft(const MatrixXcd& T, Index k, double least) {
    VectorXcd y = VectorXcd::Zero(T.rows());
    y[k] = 1;
    for (Index i = k + 1; i < T.rows(); ++i) {
        const std::complex<double> sum = y.segment(k, i - k).dot(T.col(i).segment(k, i - k));
        y[i] = -std::conj(sum / avoidZero(T(i, i) - T(k, k), least));
    }
    return y.normalized();
}

}  // namespace

double GeneralEigenvectors::calcShift(Index k, const MatrixXd& errors) const {
    return left.col(k).cwiseAbs().dot(errors * right.col(k).cwiseAbs()) / products[k];
}

GeneralEigenvectors calcGeneralEigenvectors(const MatrixXd& A) {
    const Index n = A.rows();
    GeneralEigenvectors result{VectorXcd(n), MatrixXcd(n, n), MatrixXcd(n, n), VectorXd(n), VectorXd(n)};
    if (n == 0) return result;
    MatrixXd balanced = A;
    const VectorXd D = balance(balanced);
    const Eigen::ComplexSchur<MatrixXcd> schur(balanced.cast<std::complex<double>>());
    const MatrixXcd &T = schur.matrixT(), &Q = schur.matrixU();
    const double size = balanced.norm(), least = std::max(Epsilon * size, std::numeric_limits<double>::min());
    for (Index k = 0; k < n; ++k) {
        const VectorXcd x = calcRight(T, k, least), y = calcLeft(T, k, least);
        result.values[k] = T(k, k);
        result.right.col(k) = D.asDiagonal() * (Q * x);
        result.left.col(k) = D.cwiseInverse().asDiagonal() * (Q * y);
        result.products[k] = std::max(std::abs(y.dot(x)), std::numeric_limits<double>::min());
        result.rounding[k] = Epsilon * double(n) * size / result.products[k];
    }
    return result;
}

}  // namespace jprim
