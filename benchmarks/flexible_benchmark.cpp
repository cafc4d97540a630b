// SPDX-License-Identifier: Apache-2.0
// What flexible bodies cost, as ratios of wall times within one run:
//  - one second of a slider-crank whose rod has 20 modes, beside the same mechanism with a rigid rod and 20
//    oscillators on Ground that have the modes' frequencies, damping and unit mass: the integrator then has
//    as many coordinates and as fast ones;
//  - the same without the oscillators, for what they cost;
//  - reduction of a block of 50,000 freedoms and 30 modes, in seconds and with the peak of memory.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>

#include "jprim/jprim.h"
#include "support/solid_block.h"

namespace {

using jprim::Marker;
using SimTK::Body;
using SimTK::Force;
using SimTK::GeneralForceSubsystem;
using SimTK::Inertia;
using SimTK::MassProperties;
using SimTK::MobilizedBody;
using SimTK::MobilizerQIndex;
using SimTK::MobilizerUIndex;
using SimTK::Motion;
using SimTK::MultibodySystem;
using SimTK::Real;
using SimTK::RungeKuttaMersonIntegrator;
using SimTK::SimbodyMatterSubsystem;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::TimeStepper;
using SimTK::Transform;
using SimTK::Vec3;

constexpr int NumModes = 20;
constexpr Real Radius = 0.2, Length = 1, Speed = 3;  // m, m, rad/s
enum class Rod { Rigid, RigidWithOscillators, Flexible };

const jprim::ModalBasis& getBasis() {
    static const jprim::ModalBasis basis = [] {
        jprim::UniformBeam beam;
        beam.length = Length;
        beam.elements = 20;
        beam.youngsModulus = 7e10;
        beam.shearModulus = 2.6e10;
        beam.density = 2700;
        beam.area = 2e-4;
        beam.secondMomentY = 6.7e-9;
        beam.secondMomentZ = 1.7e-9;
        beam.torsionConstant = 4.6e-9;
        return jprim::reduceToModes(jprim::makeFiniteElementModel(beam), {{{1}, 0, {}}, {{21}, 0, {}}},
                                    NumModes - 6);
    }();
    return basis;
}

struct Timing {
    double seconds = 0;
    int steps = 0;
};

Timing simulate(Rod kind) {
    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    const Body::Rigid light(MassProperties(0.1, Vec3(0), Inertia(1e-3)));
    MobilizedBody::Pin crank(matter.Ground(), Transform(), light, Transform());
    MobilizedBody::Slider slider(matter.Ground(), Transform(), light, Transform());
    Motion::Steady(crank, Speed);

    const jprim::ModalBasis& basis = getBasis();
    const jprim::RigidBodyProperties& r = basis.rigid;
    Marker start, end;
    MobilizedBody rod;
    if (kind == Rod::Flexible) {
        const jprim::FlexibleBody body(matter, forces, basis);
        rod = body.getBody();
        start = Marker(body, 1);
        end = Marker(body, 21);
    } else {
        const Inertia central(r.inertia(0, 0), r.inertia(1, 1), r.inertia(2, 2));
        rod = MobilizedBody::Free(
            matter.Ground(),
            Body::Rigid(MassProperties(r.mass, r.center, central.shiftFromMassCenter(r.center, r.mass))));
        start = Marker(rod);
        end = Marker(rod, Transform(Vec3(Length, 0, 0)));
    }
    std::vector<MobilizedBody> oscillators;
    if (kind == Rod::RigidWithOscillators)
        for (const Real w : basis.frequencies) {
            MobilizedBody::Slider body(matter.Ground(), Transform(),
                                       Body::Rigid(MassProperties(1, Vec3(0), Inertia(1))), Transform());
            Force::MobilityLinearSpring(forces, body, MobilizerQIndex(0), w * w, 0);
            Force::MobilityLinearDamper(forces, body, MobilizerUIndex(0),
                                        2 * jprim::calcDefaultDampingRatio(w) * w);
            oscillators.push_back(body);
        }
    jprim::Joint::Revolute(start, Marker(crank, Transform(Vec3(Radius, 0, 0))));
    jprim::InLine(end, Marker(slider));

    State state = system.realizeTopology();
    rod.setQToFitTransform(state, Vec3(Radius, 0, 0));
    slider.setOneQ(state, 0, Radius + Length);
    crank.setOneU(state, 0, Speed);
    rod.setUToFitVelocity(state,
                          SpatialVec(Vec3(0, 0, -Speed * Radius / Length), Vec3(0, Speed * Radius, 0)));
    for (MobilizedBody& body : oscillators) body.setOneU(state, 0, 1e-3);
    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-6);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    const auto before = std::chrono::steady_clock::now();
    stepper.stepTo(1);
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count(),
            integrator.getNumStepsTaken()};
}

// Interleaved, so that a machine whose speed drifts is fair to all.
void compareSliderCranks() {
    constexpr int Repetitions = 5;
    const std::pair<const char*, Rod> kinds[] = {{"rigid rod", Rod::Rigid},
                                                 {"rigid rod and 20 oscillators", Rod::RigidWithOscillators},
                                                 {"flexible rod with 20 modes", Rod::Flexible}};
    std::vector<double> seconds[3];
    int steps[3] = {};
    for (int k = 0; k < Repetitions; ++k)
        for (int i = 0; i < 3; ++i) {
            const Timing timing = simulate(kinds[i].second);
            seconds[i].push_back(timing.seconds);
            steps[i] = timing.steps;
        }
    double medians[3];
    for (int i = 0; i < 3; ++i) {
        std::sort(seconds[i].begin(), seconds[i].end());
        medians[i] = seconds[i][Repetitions / 2];
        fmt::print("{:<30} {:8.3f} s  {:8} steps  {:6.1f} us a step\n", kinds[i].first, medians[i], steps[i],
                   1e6 * medians[i] / steps[i]);
    }
    fmt::print("flexible / oscillators: wall {:.2f}, per step {:.2f}\n\n", medians[2] / medians[1],
               medians[2] / steps[2] / (medians[1] / steps[1]));
}

void measureReduction() {
    const jprim::testing::SolidBlock block = jprim::testing::makeSolidBlock({25, 24, 25}, Vec3(1, 0.9, 1.1));
    const auto before = std::chrono::steady_clock::now();
    const jprim::ModalBasis basis = jprim::reduceToModes(
        block.model, {{block.findFace(0, 0), 0, {}}, {block.findFace(0, 25), 0, {}}}, 30);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print("reduction of {} freedoms to {} modes: {:.1f} s, peak memory {:.2f} GB\n",
               block.model.getNumFreedoms(), basis.getNumModes(), seconds, double(usage.ru_maxrss) / 1e6);
}

}  // namespace

int main() {
    compareSliderCranks();
    measureReduction();
}
