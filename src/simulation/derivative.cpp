// SPDX-License-Identifier: Apache-2.0
#include "simulation/derivative.h"

#include <exception>
#include <limits>
#include <optional>

namespace jprim {

using Eigen::VectorXd;
using Function = std::function<VectorXd(double)>;

namespace {

// Of the sums, (f(h) - 2 f0 + f(-h))/h = k + a h + b h^3: what slopes differ by, and what is smooth.
VectorXd calcKink(const VectorXd& c1, const VectorXd& c2, const VectorXd& c4) {
    return (16 * c1 - 10 * c2 + c4) / 7;
}

Derivative differentiateBy(double h, const Function& f, const VectorXd& f0) {
    VectorXd differences[3], sums[3];
    for (int k = 0; k < 3; ++k) {
        const double step = h * double(1 << k);
        const VectorXd ahead = f(step), behind = f(-step);
        differences[k] = (ahead - behind) / (2 * step);
        sums[k] = (ahead - f0 - (f0 - behind)) / step;
    }
    const VectorXd fine = (4 * differences[0] - differences[1]) / 3;
    const VectorXd coarse = (4 * differences[1] - differences[2]) / 3;
    return {fine, (fine - coarse).cwiseAbs() + calcKink(sums[0], sums[1], sums[2]).cwiseAbs() / 2};
}

}  // namespace

Derivative differentiate(const Function& f, const VectorXd& f0) {
    constexpr double Longest = 1e-3, Shortest = 1e-7, Shorter = 0.1, Enough = 1e-10;
    std::optional<Derivative> best;
    std::exception_ptr failure;
    for (double h = Longest; h > Shortest / 2; h *= Shorter) {
        try {
            const Derivative derivative = differentiateBy(h, f, f0);
            if (!derivative.error.allFinite()) continue;
            if (!best || derivative.error.norm() < best->error.norm()) best = derivative;
            if (best->error.norm() <= Enough * best->value.norm()) break;
        } catch (const std::exception&) {
            failure = std::current_exception();
        }
    }
    if (best) return *best;
    if (failure) std::rethrow_exception(failure);
    const VectorXd none = VectorXd::Constant(f0.size(), std::numeric_limits<double>::quiet_NaN());
    return {none, none};
}

}  // namespace jprim
