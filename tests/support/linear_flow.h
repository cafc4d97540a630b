// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_LINEAR_FLOW_H_
#define JPRIM_TESTS_SUPPORT_LINEAR_FLOW_H_

#include <Eigen/Dense>
#include <cmath>

namespace jprim::testing {

/// exp(A), by its series for A/2^k and repeated squaring.
inline Eigen::MatrixXd calcExponential(const Eigen::MatrixXd& A) {
    constexpr int Terms = 20;
    int halvings = 0;
    for (double size = A.cwiseAbs().rowwise().sum().maxCoeff(); size > 0.5; size /= 2) ++halvings;
    const Eigen::MatrixXd small = A / std::exp2(halvings);
    Eigen::MatrixXd term = Eigen::MatrixXd::Identity(A.rows(), A.cols()), sum = term;
    for (int k = 1; k <= Terms; ++k) {
        term = term * small / k;
        sum += term;
    }
    for (int k = 0; k < halvings; ++k) sum = sum * sum;
    return sum;
}

/// The state at time t of dx/dt = A x + b.
inline Eigen::VectorXd flow(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, const Eigen::VectorXd& start,
                            double t) {
    const Eigen::Index n = A.rows();
    Eigen::MatrixXd extended = Eigen::MatrixXd::Zero(n + 1, n + 1);
    extended.topLeftCorner(n, n) = A;
    extended.topRightCorner(n, 1) = b;
    Eigen::VectorXd x(n + 1);
    x << start, 1;
    return (calcExponential(t * extended) * x).head(n);
}

}  // namespace jprim::testing

#endif
