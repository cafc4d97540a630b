// SPDX-License-Identifier: Apache-2.0
// What joint coordinates save: rows of four-bars, run by a tree and by constraints, compared where both come as
// near to the exact motion.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <vector>

#include "base/format.h"
#include "measure.h"
#include "runs.h"

namespace {

using jprim::Formulation;
using jprim::Mechanism;
using jprim::benchmarks::Run;

constexpr double Errors[] = {1e-5, 1e-6};  // m

// The loosest accuracies from which on each of the errors is met, in steps of a factor of 2. A single loose run may
// come near by chance: errors change sign from one accuracy to the next.
std::vector<double> findAccuracies(const Mechanism& mechanism, int n) {
    constexpr int MetInARow = 3;  // the tightest error
    std::vector<double> accuracies(std::size(Errors), SimTK::NaN);
    int met = 0;
    for (double accuracy = 1e-2; met < MetInARow; accuracy /= 2) {
        const Run run = jprim::benchmarks::integrate(mechanism, jprim::benchmarks::FourBarsEnd, accuracy);
        const double error = jprim::benchmarks::calcFourBarsError(mechanism, n, run.finalState);
        for (size_t k = 0; k < accuracies.size(); ++k) {
            if (error > Errors[k])
                accuracies[k] = SimTK::NaN;
            else if (std::isnan(accuracies[k]))
                accuracies[k] = accuracy;
        }
        met = error <= Errors[std::size(Errors) - 1] ? met + 1 : 0;
    }
    return accuracies;
}

// Each measurement in turn, many times; of each the shortest time, which what else runs on the machine disturbs least.
std::vector<double> measureInTurn(int rounds, const std::vector<std::function<double()>>& measurements) {
    std::vector<double> shortest(measurements.size(), SimTK::Infinity);
    for (int round = 0; round < rounds; ++round)
        for (size_t k = 0; k < measurements.size(); ++k)
            shortest[k] = std::min(shortest[k], measurements[k]());
    return shortest;
}

void compareRuns(int n) {
    constexpr int MostByConstraints = 10;  // beyond, minutes
    const int rounds = n <= 10 ? 25 : 7;
    std::vector<Mechanism> mechanisms;
    mechanisms.push_back(jprim::benchmarks::buildFourBars(n, Formulation::Tree));
    if (n <= MostByConstraints)
        mechanisms.push_back(jprim::benchmarks::buildFourBars(n, Formulation::Constraints));
    std::vector<std::function<double()>> runs;
    for (const Mechanism& mechanism : mechanisms)
        for (const double accuracy : findAccuracies(mechanism, n))
            runs.push_back([&mechanism, accuracy] {
                return jprim::benchmarks::integrate(mechanism, jprim::benchmarks::FourBarsEnd, accuracy)
                    .seconds;
            });
    const std::vector<double> seconds = measureInTurn(rounds, runs);
    const size_t count = std::size(Errors);
    for (size_t k = 0; k < count; ++k) {
        fmt::print("{:>5}{:>11.0e}{:>11.4f}", n, Errors[k], seconds[k]);
        if (mechanisms.size() > 1)
            fmt::print("{:>17.4f}{:>7.1f}", seconds[count + k], seconds[count + k] / seconds[k]);
        fmt::print("\n");
    }
}

// To Stage::Acceleration, of all that depends on positions.
void compareRealizations(int n) {
    const int rounds = std::clamp(20000 / (n * n), 10, 1000);
    const Mechanism tree = jprim::benchmarks::buildFourBars(n, Formulation::Tree);
    const Mechanism constraints = jprim::benchmarks::buildFourBars(n, Formulation::Constraints);
    const auto realizeAgain = [](const Mechanism& mechanism) {
        return [&mechanism, state = assemble(mechanism).state]() mutable {
            state.updQ();
            return jprim::benchmarks::measureSeconds(
                [&] { mechanism.getSystem().realize(state, SimTK::Stage::Acceleration); });
        };
    };
    const std::vector<double> seconds =
        measureInTurn(rounds, {realizeAgain(tree), realizeAgain(constraints)});
    fmt::print("{:>5}{:>26.3f}{:>18.3f}{:>7.1f}\n", n, 1e3 * seconds[0], 1e3 * seconds[1],
               seconds[1] / seconds[0]);
}

}  // namespace

int main() {
    fmt::print("    N  error [m]   tree [s]  constraints [s]  ratio\n");
    for (const int n : {2, 10, 40, 80}) compareRuns(n);
    fmt::print("    N  a realization: tree [ms]  constraints [ms]  ratio\n");
    for (const int n : {2, 10, 20, 40, 80}) compareRealizations(n);
    return 0;
}
