// SPDX-License-Identifier: Apache-2.0
// Each primitive beside Simbody's nearest built-in: time per realize(Stage::Acceleration) of one system with
// 1, 5, 20 and 80 constraints, each between one body and the next. The bodies are free, as a dataset builds
// them, or pinned to Ground, so that the bodies cost little and the constraints more of the whole.
//
// Run primitives_benchmark with
//     --benchmark_enable_random_interleaving=true --benchmark_repetitions=9 --benchmark_min_time=0.05
// The tables at the end give the ratio of medians, jprim / Simbody; below 1 jprim is faster.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <functional>
#include <map>
#include <memory>

#include "jprim/jprim.h"

namespace {

using jprim::Marker;
using SimTK::Body;
using SimTK::Constraint;
using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;

using AddConstraint = std::function<void(MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ)>;

struct Contest {
    const char* name;
    const char* builtInName;
    AddConstraint ours;
    AddConstraint builtIn;
};

const Vec3 StationOnI(-0.5, 0.03, 0.02);

// The markers J and I of every contest: J somewhere on its body, I at StationOnI with I's axes.
template <class Primitive>
void addPrimitive(MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
    Primitive(Marker(I, Transform(StationOnI)), Marker(J, X_BJ));
}

const std::vector<Contest>& getContests() {
    static const std::vector<Contest> contests = {
        {"AtPoint", "Ball", addPrimitive<jprim::AtPoint>,
         [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
             Constraint::Ball(J, X_BJ.p(), I, StationOnI);
         }},
        {"InLine", "PointOnLine", addPrimitive<jprim::InLine>,
         [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
             Constraint::PointOnLine(J, X_BJ.z(), X_BJ.p(), I, StationOnI);
         }},
        {"InPlane", "PointInPlane", addPrimitive<jprim::InPlane>,
         [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
             Constraint::PointInPlane(J, X_BJ.z(), SimTK::dot(X_BJ.z(), X_BJ.p()), I, StationOnI);
         }},
        {"Orientation", "ConstantOrientation", addPrimitive<jprim::Orientation>,
         [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
             Constraint::ConstantOrientation(J, X_BJ.R(), I, Rotation());
         }},
        {"ParallelAxes", "2 ConstantAngle", addPrimitive<jprim::ParallelAxes>,
         [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
             Constraint::ConstantAngle(J, X_BJ.x(), I, SimTK::UnitVec3(SimTK::ZAxis), SimTK::Pi / 2);
             Constraint::ConstantAngle(J, X_BJ.y(), I, SimTK::UnitVec3(SimTK::ZAxis), SimTK::Pi / 2);
         }},
        {"Perpendicular", "ConstantAngle", addPrimitive<jprim::Perpendicular>,
         [](MobilizedBody& J, MobilizedBody& I, const Transform& X_BJ) {
             Constraint::ConstantAngle(J, X_BJ.z(), I, SimTK::UnitVec3(SimTK::ZAxis), SimTK::Pi / 2);
         }}};
    return contests;
}

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
        const Body::Rigid body(SimTK::MassProperties(1.3, Vec3(0), SimTK::Inertia(0.02, 0.11, 0.1)));
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

// Console output as usual, and the medians kept for the table.
class MedianKeeper : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs)
            if (run.aggregate_name == "median" || run.repetitions == 1)
                medians[run.run_name.str()] = run.GetAdjustedCPUTime();
    }

    std::map<std::string, double> medians;
};

constexpr int ChainLengths[] = {1, 5, 20, 80};

std::string makeName(const Contest& contest, const char* side, Bodies bodies) {
    return fmt::format("{}/{}/{}", contest.name, side, getName(bodies));
}

void printRatios(const std::map<std::string, double>& medians, Bodies bodies) {
    fmt::print("\n{:<54}",
               fmt::format("jprim / Simbody, {} bodies, number of constraints:", getName(bodies)));
    for (const int n : ChainLengths) fmt::print("{:>8}", n);
    fmt::print("\n");
    for (const Contest& contest : getContests()) {
        fmt::print("{:<54}", fmt::format("{} / {}", contest.name, contest.builtInName));
        for (const int n : ChainLengths) {
            const auto ours = medians.find(fmt::format("{}/{}", makeName(contest, "jprim", bodies), n));
            const auto builtIn = medians.find(fmt::format("{}/{}", makeName(contest, "Simbody", bodies), n));
            if (ours == medians.end() || builtIn == medians.end())
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

int main(int argc, char** argv) {
    for (const Contest& contest : getContests())
        for (const Bodies bodies : {Bodies::Free, Bodies::Pinned}) registerContest(contest, bodies);
    benchmark::Initialize(&argc, argv);
    MedianKeeper reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    for (const Bodies bodies : {Bodies::Free, Bodies::Pinned}) printRatios(reporter.medians, bodies);
    return 0;
}
