// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_BENCHMARKS_CONTEST_H_
#define JPRIM_BENCHMARKS_CONTEST_H_

#include <functional>
#include <string>
#include <vector>

#include "SimTKsimbody.h"

/// @file
/// Constraints of jprim beside Simbody's built-in ones: time per realize(Stage::Acceleration) of one system with 1,
/// 5, 20 and 80 constraints, each between one body and the next. The bodies are free, as a dataset builds them,
/// or pinned to Ground, so that the bodies cost little and the constraints more of the whole.
namespace jprim::benchmarks {

/// Adds one constraint between a marker J somewhere on its body and a marker I at StationOnI with its body's axes.
using AddConstraint =
    std::function<void(SimTK::MobilizedBody& J, SimTK::MobilizedBody& I, const SimTK::Transform& X_BJ)>;

struct Contest {
    std::string name;
    std::string builtInName;
    AddConstraint ours;
    AddConstraint builtIn;
};

const SimTK::Vec3 StationOnI(-0.5, 0.03, 0.02);

/// Simbody's constraints that more than one contest is against: I's station stays on J's xy plane; the z axes stay at
/// right angles.
void addPointInPlane(SimTK::MobilizedBody& J, SimTK::MobilizedBody& I, const SimTK::Transform& X_BJ);
void addRightAngle(SimTK::MobilizedBody& J, SimTK::MobilizedBody& I, const SimTK::Transform& X_BJ);

/// Runs all contests with the command line's options for Google Benchmark, then prints tables of the ratio of
/// the shortest times, jprim / Simbody. Both sides are interleaved with
///     --benchmark_enable_random_interleaving=true --benchmark_repetitions=30 --benchmark_min_time=0.01
void runContests(const std::vector<Contest>& contests, int argc, char** argv);

}  // namespace jprim::benchmarks

#endif
