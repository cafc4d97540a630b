// SPDX-License-Identifier: Apache-2.0
// What joint coordinates save: rows of four-bars, run by a tree and by constraints, compared where both come as
// near to the exact motion.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <vector>

#include "jprim/jprim.h"
#include "support/four_bars.h"

namespace {

using jprim::Formulation;
using jprim::Mechanism;

constexpr double End = 0.6;  // s; before the first singular position
constexpr int Top = 2002;    // the marker at the top of the first rocker

Mechanism build(int n, Formulation formulation) {
    jprim::Diagnostics diagnostics;
    const jprim::Dataset dataset = jprim::readDataset(jprim::testing::writeFourBars(n), diagnostics);
    return std::move(*jprim::buildMechanism(dataset, diagnostics, {formulation}));
}

struct Run {
    double error = 0;    // m, of the top
    double seconds = 0;  // of the integration
};

Run integrate(const Mechanism& mechanism, int n, double accuracy) {
    jprim::SimulationOptions options;
    options.end = End;
    options.steps = 1;
    options.accuracy = accuracy;
    options.kind = jprim::SimulationKind::Dynamics;
    const jprim::SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    mechanism.getSystem().realize(outcome.finalState, SimTK::Stage::Position);
    const double angle = jprim::testing::calcFourBarsAngle(n, End);
    const SimTK::Vec3 exact(std::sin(angle), std::cos(angle), 0);
    const SimTK::Vec3 top = mechanism.getMarker(Top).findPoseInGround(outcome.finalState).p();
    return {(top - exact).norm(), outcome.summary.wallSeconds};
}

// The shortest time in which the error is met, over accuracies a factor of 2 apart.
double findTime(const Mechanism& mechanism, int n, double error) {
    double best = SimTK::Infinity;
    for (double accuracy = 1e-2; accuracy > 1e-9; accuracy /= 2) {
        const Run run = integrate(mechanism, n, accuracy);
        if (run.error <= error) best = std::min(best, run.seconds);
        if (run.error <= error / 10) break;
    }
    return best;
}

// Seconds for one realization to Stage::Acceleration.
double measureRealization(const Mechanism& mechanism) {
    SimTK::State state = assemble(mechanism).state;
    int count = 0;
    const auto start = std::chrono::steady_clock::now();
    std::chrono::duration<double> passed{};
    for (; passed.count() < 0.2; ++count) {
        state.updQ();  // forgets all that depends on positions
        mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
        passed = std::chrono::steady_clock::now() - start;
    }
    return passed.count() / count;
}

}  // namespace

int main() {
    fmt::print("    N  error [m]   tree [s]  constraints [s]  ratio\n");
    for (const int n : {2, 10, 40})
        for (const double error : {1e-5, 1e-6}) {
            const double tree = findTime(build(n, Formulation::Tree), n, error);
            fmt::print("{:>5}{:>11.0e}{:>11.4f}", n, error, tree);
            if (n <= 10) {  // beyond, minutes
                const double constraints = findTime(build(n, Formulation::Constraints), n, error);
                fmt::print("{:>17.4f}{:>7.1f}", constraints, constraints / tree);
            }
            fmt::print("\n");
        }
    fmt::print("    N  a realization: tree [ms]  constraints [ms]  ratio\n");
    for (const int n : {2, 10, 20, 40, 80}) {
        const double tree = measureRealization(build(n, Formulation::Tree));
        const double constraints = measureRealization(build(n, Formulation::Constraints));
        fmt::print("{:>5}{:>26.3f}{:>18.3f}{:>7.1f}\n", n, 1e3 * tree, 1e3 * constraints, constraints / tree);
    }
    return 0;
}
