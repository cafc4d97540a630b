// SPDX-License-Identifier: Apache-2.0
#include "support/linearize.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace jprim::testing {

using namespace SimTK;

namespace {

// d(udot)/dq along each generalized speed, at rest.
Eigen::MatrixXd calcTangent(const FlexibleSystem& s, const State& at) {
    constexpr Real Step = 1e-5;
    const int n = at.getNU();
    Eigen::MatrixXd tangent(n, n);
    State state = at;
    for (int i = 0; i < n; ++i) {
        Vector u(n, Real(0)), qdot;
        u[i] = 1;
        s.system.realize(at, Stage::Position);
        s.matter.multiplyByN(at, false, u, qdot);
        tangent.col(i).setZero();
        for (const Real sign : {-1., 1.}) {
            state.updQ() = at.getQ() + sign * Step * qdot;
            s.system.realize(state, Stage::Acceleration);
            for (int k = 0; k < n; ++k) tangent(k, i) += sign * state.getUDot()[k] / (2 * Step);
        }
    }
    return tangent;
}

}  // namespace

namespace {

constexpr double Nothing = 1e-9;  // of the largest: what differences leave of zero

// Squared frequencies are the eigenvalues of minus the tangent; constraints' reactions are in it.
struct Vibrations {
    explicit Vibrations(const Eigen::MatrixXd& tangent)
        : solver(-tangent), squares(solver.eigenvalues().real()) {}
    bool isVibration(Eigen::Index i) const { return squares[i] > Nothing * squares.maxCoeff(); }
    Eigen::EigenSolver<Eigen::MatrixXd> solver;
    Eigen::VectorXd squares;
};

}  // namespace

std::vector<double> calcFrequencies(const FlexibleSystem& s, const State& state) {
    const Vibrations vibrations(calcTangent(s, state));
    std::vector<double> frequencies;
    for (Eigen::Index i = 0; i < vibrations.squares.size(); ++i)
        if (vibrations.isVibration(i)) frequencies.push_back(std::sqrt(vibrations.squares[i]));
    std::sort(frequencies.begin(), frequencies.end());
    return frequencies;
}

Vector calcFirstMode(const FlexibleSystem& s, const State& state) {
    const Vibrations vibrations(calcTangent(s, state));
    Eigen::Index first = -1;
    for (Eigen::Index i = 0; i < vibrations.squares.size(); ++i)
        if (vibrations.isVibration(i) && (first < 0 || vibrations.squares[i] < vibrations.squares[first]))
            first = i;
    const Eigen::VectorXd mode = vibrations.solver.eigenvectors().col(first).real();
    return Vector(int(mode.size()), mode.data());
}

// The step du satisfies tangent du = -udot and, weighed as heavily, G du = -perr.
void findEquilibrium(const FlexibleSystem& s, State& state) {
    for (int iteration = 0; iteration < 6; ++iteration) {
        s.system.realize(state, Stage::Acceleration);
        const int n = state.getNU();
        Matrix G;
        s.matter.calcG(state, G);
        const Eigen::MatrixXd tangent = calcTangent(s, state);
        Eigen::MatrixXd A(n + G.nrow(), n);
        Eigen::VectorXd b(n + G.nrow());
        const double weight = tangent.cwiseAbs().maxCoeff();
        A.topRows(n) = tangent;
        for (int k = 0; k < n; ++k) b[k] = -state.getUDot()[k];
        for (int k = 0; k < G.nrow(); ++k) {
            for (int j = 0; j < n; ++j) A(n + k, j) = weight * G(k, j);
            b[n + k] = -weight * state.getQErr()[k];
        }
        const Eigen::VectorXd step = A.colPivHouseholderQr().solve(b);
        Vector qdot;
        s.matter.multiplyByN(state, false, Vector(n, step.data()), qdot);
        state.updQ() += qdot;
    }
    s.system.realize(state, Stage::Acceleration);
}

void expectFrequency(const std::vector<double>& frequencies, double expected, double tolerance) {
    ASSERT_FALSE(frequencies.empty());
    const auto nearest = std::min_element(
        frequencies.begin(), frequencies.end(),
        [expected](double a, double b) { return std::abs(a - expected) < std::abs(b - expected); });
    EXPECT_NEAR(*nearest / expected, 1, tolerance);
}

}  // namespace jprim::testing
