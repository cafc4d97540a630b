// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_BENCHMARKS_RUNS_H_
#define JPRIM_BENCHMARKS_RUNS_H_

#include <string>

#include "jprim/jprim.h"

/// @file
/// Mechanisms from datasets, and runs of them.
namespace jprim::benchmarks {

/// @throws std::runtime_error if the dataset has errors
Mechanism buildFromText(const std::string& text, Formulation formulation = Formulation::Tree);

/// The row of N four-bars of tests/support/four_bars.h, which passes no singular position until FourBarsEnd.
Mechanism buildFourBars(int n, Formulation formulation);
constexpr double FourBarsEnd = 0.6;  // s

/// Where a marker is in Ground; realizes the State's positions.
SimTK::Vec3 findMarker(const Mechanism& mechanism, int id, const SimTK::State& state);

/// How far the top of the first rocker is from its exact place [m].
double calcFourBarsError(const Mechanism& mechanism, int n, const SimTK::State& state);

struct Run {
    SimTK::State finalState;
    int steps = 0;  ///< of the integrator
    double seconds = 0;
};

/// Integrates in one output step.
/// @throws std::runtime_error if the simulation fails
Run integrate(const Mechanism& mechanism, double end, double accuracy,
              const std::string& integrator = SimulationOptions().integrator);

}  // namespace jprim::benchmarks

#endif
