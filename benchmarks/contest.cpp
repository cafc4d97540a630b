// SPDX-License-Identifier: Apache-2.0
#include "contest.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/format.h"

namespace jprim::benchmarks {

using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

enum class Bodies { Free, Pinned };

const char* getName(Bodies bodies) {
    return bodies == Bodies::Free ? "free" : "pinned";
}

// A row of `length` bodies in a general position, gravity acting.
struct Chain {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    SimTK::State state;

    Chain(Bodies bodies, int length, const AddConstraint& add) {
        SimTK::Force::Gravity(forces, matter, -SimTK::YAxis, 9.81);
        const SimTK::Body::Rigid body(SimTK::MassProperties(1.3, Vec3(0), SimTK::Inertia(0.02, 0.11, 0.1)));
        const Transform X_BJ(Rotation(0.3, SimTK::XAxis), Vec3(0.5, 0.01, -0.04));
        MobilizedBody previous = matter.Ground();
        for (int k = 0; k < length; ++k) {
            const Transform X_GF(Rotation(0.2 * k, SimTK::YAxis), Vec3(1.1 * k, 0.1, 0));
            MobilizedBody next;
            if (bodies == Bodies::Free)
                next = MobilizedBody::Free(matter.Ground(), X_GF, body, Transform());
            else
                next = MobilizedBody::Pin(matter.Ground(), X_GF, body, Transform());
            add(previous, next, X_BJ);
            previous = next;
        }
        state = system.realizeTopology();
        for (int u = 0; u < state.getNU(); ++u) state.updU()[u] = 0.1 * std::sin(1.7 * u);
    }
};

void realizeAcceleration(benchmark::State& benchmarkState, Bodies bodies, const AddConstraint& add) {
    Chain chain(bodies, int(benchmarkState.range(0)), add);
    for (auto _ : benchmarkState) {
        chain.state.invalidateAllCacheAtOrAbove(SimTK::Stage::Position);
        chain.system.realize(chain.state, SimTK::Stage::Acceleration);
    }
}

// Console output as usual, and of all repetitions the shortest kept for the table: what else runs on a machine only
// makes times longer.
class ShortestKeeper : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration) continue;
            const double time = run.GetAdjustedCPUTime();
            double& kept = shortest.emplace(run.run_name.str(), time).first->second;
            kept = std::min(kept, time);
        }
    }

    std::map<std::string, double> shortest;
};

constexpr int ChainLengths[] = {1, 5, 20, 80};

std::string makeName(const Contest& contest, const char* side, Bodies bodies) {
    return fmt::format("{}/{}/{}", contest.name, side, getName(bodies));
}

void printRatios(const std::vector<Contest>& contests, const std::map<std::string, double>& shortest,
                 Bodies bodies) {
    fmt::print("\n{:<54}",
               fmt::format("jprim / Simbody, {} bodies, number of constraints:", getName(bodies)));
    for (const int n : ChainLengths) fmt::print("{:>8}", n);
    fmt::print("\n");
    for (const Contest& contest : contests) {
        fmt::print("{:<54}", fmt::format("{} / {}", contest.name, contest.builtInName));
        for (const int n : ChainLengths) {
            const auto ours = shortest.find(fmt::format("{}/{}", makeName(contest, "jprim", bodies), n));
            const auto builtIn = shortest.find(fmt::format("{}/{}", makeName(contest, "Simbody", bodies), n));
            if (ours == shortest.end() || builtIn == shortest.end())
                fmt::print("{:>8}", "-");
            else
                fmt::print("{:>8.2f}", ours->second / builtIn->second);
        }
        fmt::print("\n");
    }
}

void registerContest(const Contest& contest, Bodies bodies) {
    for (const auto& [side, add] :
         {std::pair("jprim", contest.ours), std::pair("Simbody", contest.builtIn)}) {
        const auto run = [bodies, add = add](benchmark::State& s) { realizeAcceleration(s, bodies, add); };
        auto* entry = benchmark::RegisterBenchmark(makeName(contest, side, bodies).c_str(), run);
        for (const int n : ChainLengths) entry->Arg(n);
    }
}

}  // namespace

void addPointInPlane(MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
    SimTK::Constraint::PointInPlane(J, X_BJ.z(), SimTK::dot(X_BJ.z(), X_BJ.p()), I, StationOnI);
}

void addRightAngle(MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
    SimTK::Constraint::ConstantAngle(J, X_BJ.z(), I, SimTK::UnitVec3(SimTK::ZAxis), SimTK::Pi / 2);
}

void runContests(const std::vector<Contest>& contests, int argc, char** argv) {
    for (const Contest& contest : contests)
        for (const Bodies bodies : {Bodies::Free, Bodies::Pinned}) registerContest(contest, bodies);
    benchmark::Initialize(&argc, argv);
    ShortestKeeper reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    for (const Bodies bodies : {Bodies::Free, Bodies::Pinned})
        printRatios(contests, reporter.shortest, bodies);
}

}  // namespace jprim::benchmarks
