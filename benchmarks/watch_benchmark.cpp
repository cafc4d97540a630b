// SPDX-License-Identifier: Apache-2.0
// What a run's watches cost, in percent of its time: the errors of the constraints, among them the sense of
// parallel axes, and the energy. Each watch is timed alone, on a State in which nothing of it is known yet, and held
// against the time between output times of a run that would have a hundred of them. "Each" is for the energy watched
// after each of the integrator's steps.
#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/format.h"
#include "measure.h"
#include "runs.h"
#include "slider_crank.h"

namespace {

using jprim::Formulation;
using jprim::Mechanism;
using SimTK::Stage;
using SimTK::State;

// A chain of links, pinned to ground and to each other by ATPOINT and PARALLEL_AXES, that starts level.
std::string writeChain(int length) {
    std::string text = "chain\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/2,QP=0,0,0\n";
    for (int k = 1; k <= length; ++k) {
        text += fmt::format(
            "PART/{0},MASS=1,CM={0}0,IP=0.01,0.1,0.1,QG={1},0,0\nMARKER/{0}0,QP=0.5,0,0\n"
            "MARKER/{0}1\nMARKER/{0}2,QP=1,0,0\n",
            k + 1, k - 1);
        const std::string previous = k == 1 ? "2" : fmt::format("{}2", k);
        text += fmt::format("JPRIM/{0},ATPOINT,I={1}1,J={2}\nJPRIM/{3},PARALLEL_AXES,I={1}1,J={2}\n",
                            2 * k - 1, k + 1, previous, 2 * k);
    }
    return text + "END\n";
}

double calcMedian(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

// The median time of a watch where everything was realized anew, as after a step.
template <class Watch>
double measureWatch(const Mechanism& mechanism, Watch watch) {
    using Clock = std::chrono::steady_clock;
    constexpr double Enough = 1;  // s
    State state = assemble(mechanism).state;
    std::vector<double> seconds;
    const double start = jprim::benchmarks::getSeconds();
    while (seconds.size() < 5 ||
           (seconds.size() < 1000 && jprim::benchmarks::getSeconds() < start + Enough)) {
        state.updQ();
        mechanism.getSystem().realize(state, Stage::Acceleration);
        const auto before = Clock::now();
        watch(state);
        seconds.push_back(std::chrono::duration<double>(Clock::now() - before).count());
    }
    return calcMedian(seconds);
}

struct OutputStep {
    double seconds = 0;
    double internalSteps = 0;
};

// Of the first few of a run that would have a hundred.
OutputStep measureOutputStep(const Mechanism& mechanism, double end) {
    constexpr int Steps = 100, Few = 5;
    std::vector<double> times;
    jprim::SimulationOptions options;
    options.end = end * Few / Steps;
    options.steps = Few;
    options.reportProgress = [&](double) { times.push_back(jprim::benchmarks::getSeconds()); };
    const jprim::SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    if (!outcome.failure.empty()) throw std::runtime_error(outcome.failure);
    return {(times.back() - times.front()) / Few, double(outcome.summary.stepsTaken) / Few};
}

void compare(const char* name, const Mechanism& mechanism, double end) {
    const OutputStep step = measureOutputStep(mechanism, end);
    const auto equations = mechanism.findEquations(assemble(mechanism).state);
    const double errors = measureWatch(
        mechanism, [&](const State& state) { static_cast<void>(calcViolation(equations, state)); });
    volatile double sum = 0;
    const double energy = measureWatch(mechanism, [&](const State& state) {
        sum = sum + mechanism.calcKineticEnergy(state) + mechanism.getSystem().calcPotentialEnergy(state) +
              mechanism.calcEnergyBalance(state);
    });
    fmt::print("{:<34}{:>12.3f}{:>8.1f}{:>12.1f}{:>8.3f}{:>12.1f}{:>8.3f}{:>8.3f}\n", name,
               1e3 * step.seconds, step.internalSteps, 1e6 * errors, 100 * errors / step.seconds,
               1e6 * energy, 100 * energy / step.seconds, 100 * energy * step.internalSteps / step.seconds);
}

}  // namespace

int main() {
    fmt::print("{:<34}{:>20}{:>20}{:>28}\n{:<34}{:>12}{:>8}{:>12}{:>8}{:>12}{:>8}{:>8}\n", "",
               "an output step", "errors", "energy", "", "[ms]", "steps", "[us]", "[%]", "[us]", "[%]",
               "[% each]");
    const auto fourBars = [](Formulation f) { return jprim::benchmarks::buildFourBars(10, f); };
    const auto chain = [](Formulation f) { return jprim::benchmarks::buildFromText(writeChain(100), f); };
    compare("10 four-bars, tree", fourBars(Formulation::Tree), jprim::benchmarks::FourBarsEnd);
    compare("10 four-bars, constraints", fourBars(Formulation::Constraints), jprim::benchmarks::FourBarsEnd);
    compare("flexible slider-crank", jprim::benchmarks::buildSliderCrank(), 1);
    compare("100 links, tree", chain(Formulation::Tree), 1);
    compare("100 links, constraints", chain(Formulation::Constraints), 1);
    return 0;
}
