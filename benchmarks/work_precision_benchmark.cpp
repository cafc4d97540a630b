// SPDX-License-Identifier: Apache-2.0
// What each integrator needs for how much precision: error, steps and time of two mechanisms, a row of ten
// four-bars in a tree and a slider-crank with a flexible rod, for accuracies 1e-3 to 1e-8. After a run that took
// longer than TooLong the tighter ones are left out.
#include <functional>
#include <string>
#include <utility>

#include "base/format.h"
#include "runs.h"
#include "slider_crank.h"

namespace {

using jprim::Mechanism;
using jprim::benchmarks::Run;
using SimTK::State;
using SimTK::Vec3;

constexpr double TooLong = 3;  // s

struct Problem {
    Mechanism mechanism;
    double end;                                                         // s
    std::function<double(const Mechanism&, const State&)> calcError{};  // m
};

Problem makeFourBars() {
    constexpr int N = 10;
    return {jprim::benchmarks::buildFourBars(N, jprim::Formulation::Tree), jprim::benchmarks::FourBarsEnd,
            [](const Mechanism& mechanism, const State& state) {
                return jprim::benchmarks::calcFourBarsError(mechanism, N, state);
            }};
}

// The error is that of the middle of the rod, beside a run with an accuracy a hundred times tighter than any other.
Problem makeSliderCrank() {
    constexpr double Tightest = 1e-10;
    const auto findMiddle = [](const Mechanism& mechanism, const State& state) {
        return jprim::benchmarks::findMarker(mechanism, jprim::benchmarks::MiddleOfRod, state);
    };
    Problem problem{jprim::benchmarks::buildSliderCrank(), 0.1};
    const Run best = jprim::benchmarks::integrate(problem.mechanism, problem.end, Tightest);
    const Vec3 exact = findMiddle(problem.mechanism, best.finalState);
    problem.calcError = [=](const Mechanism& mechanism, const State& state) {
        return (findMiddle(mechanism, state) - exact).norm();
    };
    return problem;
}

// Returns false if tighter accuracies are to be left out.
bool printRun(const Problem& problem, const std::string& integrator, double accuracy) {
    try {
        const Run run = jprim::benchmarks::integrate(problem.mechanism, problem.end, accuracy, integrator);
        fmt::print("{:>11.0e}{:>9}{:>9.3f}", problem.calcError(problem.mechanism, run.finalState), run.steps,
                   run.seconds);
        return run.seconds < TooLong;
    } catch (const std::exception&) {
        fmt::print("{:>29}", "fails");
        return true;
    }
}

}  // namespace

int main() {
    std::pair<Problem, bool> problems[] = {{makeFourBars(), true}, {makeSliderCrank(), true}};
    fmt::print("{:30}{:>29}{:>29}\n", "", "ten four-bars", "flexible slider-crank");
    fmt::print("{:<20}{:>10}", "integrator", "accuracy");
    for (int k = 0; k < 2; ++k) fmt::print("{:>11}{:>9}{:>9}", "error [m]", "steps", "time [s]");
    fmt::print("\n");
    for (const std::string& integrator : jprim::getIntegratorNames()) {
        for (auto& [problem, goOn] : problems) goOn = true;
        for (const double accuracy : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
            fmt::print("{:<20}{:>10.0e}", integrator, accuracy);
            for (auto& [problem, goOn] : problems) {
                if (goOn)
                    goOn = printRun(problem, integrator, accuracy);
                else
                    fmt::print("{:>29}", "left out");
            }
            fmt::print("\n");
            std::fflush(stdout);
        }
    }
    return 0;
}
