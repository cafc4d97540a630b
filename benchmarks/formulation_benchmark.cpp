// SPDX-License-Identifier: Apache-2.0
// What joint coordinates save: rows of four-bars, run by a tree and by constraints, compared where both come as
// near to the exact motion.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "measure.h"
#include "runs.h"

namespace {

using jprim::Formulation;
using jprim::Mechanism;
using jprim::benchmarks::Run;

constexpr double Errors[] = {1e-5, 1e-6};  // m

// The time at the loosest accuracy from which on each of the errors is met, over accuracies a factor of 2 apart. A
// single loose run may come near by chance: errors change sign from one accuracy to the next.
std::vector<double> findTimes(int n, Formulation formulation) {
    constexpr int MetInARow = 3, Runs = 3;  // by the tightest error; of which the shortest counts
    const Mechanism mechanism = jprim::benchmarks::buildFourBars(n, formulation);
    std::vector<double> times(std::size(Errors), SimTK::NaN);
    int met = 0;
    for (double accuracy = 1e-2; met < MetInARow; accuracy /= 2) {
        Run run = jprim::benchmarks::integrate(mechanism, jprim::benchmarks::FourBarsEnd, accuracy);
        for (int k = 1; k < Runs; ++k) {
            const Run again =
                jprim::benchmarks::integrate(mechanism, jprim::benchmarks::FourBarsEnd, accuracy);
            run.seconds = std::min(run.seconds, again.seconds);
        }
        const double error = jprim::benchmarks::calcFourBarsError(mechanism, n, run.finalState);
        for (size_t k = 0; k < times.size(); ++k) {
            if (error > Errors[k])
                times[k] = SimTK::NaN;
            else if (std::isnan(times[k]))
                times[k] = run.seconds;
        }
        met = error <= Errors[std::size(Errors) - 1] ? met + 1 : 0;
    }
    return times;
}

// Seconds for one realization to Stage::Acceleration, the shortest of many.
double measureRealization(int n, Formulation formulation) {
    constexpr double Enough = 0.5;  // s
    const Mechanism mechanism = jprim::benchmarks::buildFourBars(n, formulation);
    SimTK::State state = assemble(mechanism).state;
    double shortest = SimTK::Infinity;
    for (double passed = 0; passed < Enough;) {
        const double seconds = jprim::benchmarks::measureSeconds([&] {
            state.updQ();  // forgets all that depends on positions
            mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
        });
        passed += seconds;
        shortest = std::min(shortest, seconds);
    }
    return shortest;
}

}  // namespace

int main() {
    fmt::print("    N  error [m]   tree [s]  constraints [s]  ratio\n");
    for (const int n : {2, 10, 40, 80}) {
        const std::vector<double> tree = findTimes(n, Formulation::Tree);
        std::vector<double> constraints;
        if (n <= 10) constraints = findTimes(n, Formulation::Constraints);  // beyond, minutes
        for (size_t k = 0; k < tree.size(); ++k) {
            fmt::print("{:>5}{:>11.0e}{:>11.4f}", n, Errors[k], tree[k]);
            if (!constraints.empty())
                fmt::print("{:>17.4f}{:>7.1f}", constraints[k], constraints[k] / tree[k]);
            fmt::print("\n");
        }
    }
    fmt::print("    N  a realization: tree [ms]  constraints [ms]  ratio\n");
    for (const int n : {2, 10, 20, 40, 80}) {
        const double tree = measureRealization(n, Formulation::Tree);
        const double constraints = measureRealization(n, Formulation::Constraints);
        fmt::print("{:>5}{:>26.3f}{:>18.3f}{:>7.1f}\n", n, 1e3 * tree, 1e3 * constraints, constraints / tree);
    }
    return 0;
}
