// SPDX-License-Identifier: Apache-2.0
#include "runs.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "measure.h"
#include "support/four_bars.h"

namespace jprim::benchmarks {

Mechanism buildFromText(const std::string& text, Formulation formulation) {
    Diagnostics diagnostics;
    const Dataset dataset = readDataset(text, diagnostics);
    std::optional<Mechanism> mechanism;
    if (!hasErrors(diagnostics)) mechanism = buildMechanism(dataset, diagnostics, {formulation});
    if (!mechanism) throw std::runtime_error(formatDiagnostic("dataset", diagnostics.front()));
    return std::move(*mechanism);
}

Mechanism buildFourBars(int n, Formulation formulation) {
    return buildFromText(testing::writeFourBars(n), formulation);
}

SimTK::Vec3 findMarker(const Mechanism& mechanism, int id, const SimTK::State& state) {
    mechanism.getSystem().realize(state, SimTK::Stage::Position);
    return mechanism.getMarker(id).findPoseInGround(state).p();
}

double calcFourBarsError(const Mechanism& mechanism, int n, const SimTK::State& state) {
    constexpr int Top = 2002;  // the marker at the top of the first rocker
    const double second = mechanism.getUnits().time;
    const double angle = testing::calcFourBarsAngle(n, state.getTime() / second);
    const SimTK::Vec3 exact(std::sin(angle), std::cos(angle), 0);
    return (findMarker(mechanism, Top, state) - exact).norm();
}

Run integrate(const Mechanism& mechanism, double end, double accuracy, const std::string& integrator) {
    SimulationOptions options;
    options.end = end;
    options.steps = 1;
    options.accuracy = accuracy;
    options.integrator = integrator;
    options.kind = SimulationKind::Dynamics;
    const AssembledState initial = assemble(mechanism);
    SimulationOutcome outcome;
    const double seconds = measureSeconds([&] { outcome = simulate(mechanism, initial, options); });
    if (!outcome.failure.empty()) throw std::runtime_error(outcome.failure);
    return {outcome.finalState, outcome.summary.stepsTaken, seconds};
}

}  // namespace jprim::benchmarks
