// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "jprim/simulation/linearize.h"
#include "linear_algebra/conversion.h"
#include "linear_algebra/general_eigenvalues.h"
#include "linear_algebra/singular_values.h"

namespace jprim {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

namespace {

std::vector<Complex> toVector(const VectorXcd& x) {
    const VectorXcd unit = x.normalized();
    return {unit.begin(), unit.end()};
}

// Entries that are not told from 0 by their errors are 0.
MatrixXd calcCleanA(const LinearModel& model) {
    const MatrixXd A = toEigen(model.A);
    return (A.cwiseAbs().array() > toEigen(model.errors).array()).select(A, 0);
}

// The directions in which nothing changes, A x = 0, of a matrix with so many eigenvalues 0: half as many where each is
// that of a motion without resistance, and more where the largest gap between singular values says so. Speeds are
// measured by those of a vibration.
std::vector<Eigenmode> makeZeroModes(const LinearModel& model, const MatrixXd& A, int numZero, double error) {
    constexpr double Rounding = 1e-15;
    if (numZero == 0) return {};
    const Index n = A.rows(), p = model.numPositions, s = model.numSpeeds;
    VectorXd scale = VectorXd::Ones(n);
    const double stiffness = A.block(p, 0, s, p).norm();
    if (stiffness > 0) scale.segment(p, s).setConstant(std::sqrt(stiffness));
    const SingularValues svd = decompose(scale.cwiseInverse().asDiagonal() * A * scale.asDiagonal());
    const auto getValue = [&](Index k) { return std::max(svd.values[n - 1 - k], Rounding * svd.values[0]); };
    Index count = (numZero + 1) / 2;
    for (Index k = count; k <= numZero && k < n; ++k)
        if (getValue(k) / getValue(k - 1) > getValue(count) / getValue(count - 1)) count = k;
    std::vector<Eigenmode> modes;
    for (Index k = 0; k < count; ++k) {
        const VectorXd x = scale.cwiseProduct(svd.V.col(n - 1 - k));
        modes.push_back({0, error, true, toVector(x.cast<Complex>())});
    }
    return modes;
}

}  // namespace

double Eigenmode::getFrequency() const {
    return std::abs(eigenvalue) / (2 * SimTK::Pi);
}

double Eigenmode::getDampingRatio() const {
    return eigenvalue == 0. ? 0 : -eigenvalue.real() / std::abs(eigenvalue);
}

bool Eigenmode::isUnstable() const {
    constexpr double Beyond = 10, Rounding = 1e-10;
    return eigenvalue.real() > std::max(Beyond * error, Rounding * std::abs(eigenvalue));
}

Eigenmodes calcEigenmodes(const LinearModel& model) {
    constexpr double Doubtful = 100;
    const MatrixXd A = calcCleanA(model), errors = toEigen(model.errors);
    const GeneralEigenvectors all = calcGeneralEigenvectors(A);
    int numZero = 0;
    std::vector<Eigenmode> modes;
    double errorOfZeros = 0;
    for (Index k = 0; k < all.values.size(); ++k) {
        const Complex value = all.values[k];
        const double error = all.calcShift(k, errors) + all.rounding[k];
        if (std::abs(value) <= Doubtful * error) {
            ++numZero;
            errorOfZeros = std::max(errorOfZeros, std::abs(value));
        } else if (std::abs(value.imag()) <= all.rounding[k]) {
            modes.push_back({value.real(), error, false, toVector(all.right.col(k))});
        } else if (value.imag() > 0) {
            modes.push_back({value, error, false, toVector(all.right.col(k))});
        }
    }
    std::stable_sort(modes.begin(), modes.end(), [](const Eigenmode& a, const Eigenmode& b) {
        return std::abs(a.eigenvalue) < std::abs(b.eigenvalue);
    });
    const std::vector<Eigenmode> zeroModes = makeZeroModes(model, A, numZero, errorOfZeros);
    modes.insert(modes.begin(), zeroModes.begin(), zeroModes.end());
    return {modes, numZero};
}

}  // namespace jprim
