// SPDX-License-Identifier: Apache-2.0
//     minimize |e + A y|^2 + mu |y|^2:   y = -~A (A ~A + mu 1)^-1 e
// Where the errors can be met, mu = damping |e| vanishes with them and convergence is quadratic. Dependent
// rows do no harm: mu keeps the matrix definite, and a consistent e has no part in its null space.
#include "analysis/error_minimum.h"

#include <algorithm>

#include "linear_algebra/sparse_factor.h"

namespace jprim {

using Eigen::VectorXd;
using SimTK::State;

namespace {

constexpr double LongestStep = 0.3;  // of a scaled motion's entries: about radians, or sizes of the mechanism

VectorXd calcStep(const SparseMatrix& A, const SparseMatrix& AAt, const VectorXd& errors, double mu) {
    SparseFactor regular;
    regular.compute(AAt + mu * SparseMatrix(VectorXd::Ones(A.rows()).asDiagonal()));
    const VectorXd y = -A.transpose() * regular.solve(errors);
    return y * std::min(1., LongestStep / std::max(calcLargest(y), SimTK::TinyReal));
}

// One step down; false if there is none. The damping is what the next step should start from.
bool descend(const ScaledEquations& equations, double& damping, ErrorMinimum& minimum) {
    constexpr double Stationary = 1e-10, LargestDamping = 1e6, Factor = 10;
    const SparseMatrix A = equations.calcJacobian(minimum.state).sparseView();
    const double size = minimum.errors.norm(), least = calcLeastDamping(size);
    if ((A.transpose() * minimum.errors).norm() <= Stationary * size) return false;
    const SparseMatrix AAt = A * A.transpose();
    for (; damping < LargestDamping; damping *= Factor) {
        const VectorXd u = equations.getColumnScale().cwiseProduct(
            calcStep(A, AAt, minimum.errors, std::max(damping * size, least)));
        const State trial = equations.move(minimum.state, u);
        const VectorXd errors = equations.calcErrors(trial);
        if (!(errors.norm() < size)) continue;
        minimum = {trial, errors, minimum.displacement + u};
        damping /= Factor;
        return true;
    }
    return false;
}

}  // namespace

double calcLargest(const VectorXd& v) {
    return v.size() > 0 ? v.lpNorm<Eigen::Infinity>() : 0;
}

double calcLeastDamping(double size) {
    constexpr double Hardly = 30, Smallest = 1e-13, Largest = 1e-6;
    return std::clamp(Hardly * size * Hardly * size, Smallest, Largest);
}

bool ErrorMinimum::isMet(double uncertainty) const {
    constexpr double Rounding = 1e-11;
    return calcLargest(errors) < std::max(Rounding, uncertainty);
}

ErrorMinimum minimizeErrors(const ScaledEquations& equations, const State& start, int mostSteps) {
    constexpr double Target = 1e-14, FirstDamping = 1e-3;
    ErrorMinimum minimum{start, equations.calcErrors(start), VectorXd::Zero(start.getNU())};
    double damping = FirstDamping;
    for (int k = 0; k < mostSteps && calcLargest(minimum.errors) > Target; ++k)
        if (!descend(equations, damping, minimum)) break;
    return minimum;
}

}  // namespace jprim
