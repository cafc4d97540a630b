// SPDX-License-Identifier: Apache-2.0
// What flexible bodies cost, as ratios of times within one run:
//  - one second of a slider-crank whose rod has 20 modes, beside the same mechanism with a rigid rod and 20
//    oscillators on Ground that have the modes' frequencies, damping and unit mass: the integrator then has
//    as many coordinates and as fast ones;
//  - the same without the oscillators, for what they cost;
//  - reduction of a block of 50,000 freedoms and 30 modes, in seconds and with the peak of memory.
#include <sys/resource.h>

#include <algorithm>

#include "base/format.h"
#include "jprim/jprim.h"
#include "measure.h"
#include "slider_crank.h"
#include "support/solid_block.h"

namespace {

using jprim::Marker;
using jprim::benchmarks::CrankRadius;
using jprim::benchmarks::CrankSpeed;
using jprim::benchmarks::measureSeconds;
using jprim::benchmarks::RodEnd;
using jprim::benchmarks::RodLength;
using jprim::benchmarks::SmallInertia;
using jprim::benchmarks::SmallMass;
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

enum class Rod { Rigid, RigidWithOscillators, Flexible };

struct Timing {
    double seconds = 0;
    int steps = 0;
};

Timing simulate(Rod kind) {
    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    const Body::Rigid light(MassProperties(SmallMass, Vec3(0), Inertia(SmallInertia)));
    MobilizedBody::Pin crank(matter.Ground(), Transform(), light, Transform());
    MobilizedBody::Slider slider(matter.Ground(), Transform(), light, Transform());
    Motion::Steady(crank, CrankSpeed);

    const jprim::ModalBasis& basis = jprim::benchmarks::getRodBasis();
    const jprim::RigidBodyProperties& r = basis.rigid;
    Marker start, end;
    MobilizedBody rod;
    if (kind == Rod::Flexible) {
        const jprim::FlexibleBody body(matter, forces, basis);
        rod = body.getBody();
        start = Marker(body, 1);
        end = Marker(body, RodEnd);
    } else {
        const Inertia central(r.inertia(0, 0), r.inertia(1, 1), r.inertia(2, 2));
        rod = MobilizedBody::Free(
            matter.Ground(),
            Body::Rigid(MassProperties(r.mass, r.center, central.shiftFromMassCenter(r.center, r.mass))));
        start = Marker(rod);
        end = Marker(rod, Transform(Vec3(RodLength, 0, 0)));
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
    jprim::Joint::Revolute(start, Marker(crank, Transform(Vec3(CrankRadius, 0, 0))));
    jprim::InLine(end, Marker(slider));

    State state = system.realizeTopology();
    rod.setQToFitTransform(state, Vec3(CrankRadius, 0, 0));
    slider.setOneQ(state, 0, CrankRadius + RodLength);
    crank.setOneU(state, 0, CrankSpeed);
    rod.setUToFitVelocity(state, SpatialVec(Vec3(0, 0, -CrankSpeed * CrankRadius / RodLength),
                                            Vec3(0, CrankSpeed * CrankRadius, 0)));
    for (MobilizedBody& body : oscillators) body.setOneU(state, 0, 1e-3);
    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-6);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    const double seconds = measureSeconds([&] { stepper.stepTo(1); });
    return {seconds, integrator.getNumStepsTaken()};
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
    fmt::print("flexible / oscillators: time {:.2f}, per step {:.2f}\n\n", medians[2] / medians[1],
               medians[2] / steps[2] / (medians[1] / steps[1]));
}

void measureReduction() {
    const jprim::testing::SolidBlock block = jprim::testing::makeSolidBlock({25, 24, 25}, Vec3(1, 0.9, 1.1));
    jprim::ModalBasis basis;
    const double seconds = measureSeconds([&] {
        basis = jprim::reduceToModes(block.model,
                                     {{block.findFace(0, 0), 0, {}}, {block.findFace(0, 25), 0, {}}}, 30);
    });
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
