// SPDX-License-Identifier: Apache-2.0
// A rod clamped to a hub that turns at W about z, swung out until only its stretch is left; no gravity.
//
// Expected, with u the displacement along the rod:
//
//     u(l) = rho W^2 l^3 / (3 E)          of the tip
//     F    = m W^2 l / 2                  with which the hub holds the rod
#include "aluminium_rod.h"
#include "compare.h"

using namespace SimTK;

const Real Tolerance = 5e-3;  // as compare.h reads it

int main() {
    const Real W = 10;  // rad/s

    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    const Body::Rigid light(MassProperties(0.1, Vec3(0), Inertia(1e-3)));  // kg, kg m^2
    MobilizedBody::Pin hub(matter.Ground(), Transform(), light, Transform());
    Motion::Steady(hub, W);

    const jprim::UniformBeam beam = AluminiumRod::makeBeam();
    const jprim::ModalBasis basis =
        jprim::reduceToModes(jprim::makeFiniteElementModel(beam), {{{AluminiumRod::Start}, 0, {}}}, 30);
    jprim::FlexibleBodyOptions options;
    options.dampingRatios.assign(size_t(basis.getNumModes()), 1);
    const jprim::FlexibleBody rod(matter, forces, basis, options);
    const jprim::Joint clamp =
        jprim::Joint::Fixed(jprim::Marker(rod, AluminiumRod::Start), jprim::Marker(hub), "clamp");

    State state = system.realizeTopology();
    hub.setOneU(state, 0, W);
    rod.getBody().setU(state, Vec6(0, 0, W, 0, 0, 0));
    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-6);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    stepper.stepTo(0.5);  // s
    const State& now = integrator.getState();
    system.realize(now, Stage::Acceleration);

    const Real l = beam.length,
               tip = jprim::Marker(rod, AluminiumRod::End).findPoseInGround(now).p().norm() - l;
    const Real stretch = beam.density * W * W * l * l * l / (3 * beam.youngsModulus);
    const Real force = clamp.calcReactionOnI(now)[1].norm();
    bool agree = compare("stretch of the rod [um]", 1e6 * tip, 1e6 * stretch, Tolerance);
    agree &= compare("force of the hub [N]", force, beam.density * beam.area * l * W * W * l / 2, Tolerance);
    return agree ? 0 : 1;
}
