// SPDX-License-Identifier: Apache-2.0
// A parallelogram whose coupler bends. Both cranks turn at W, so that every point of the straight coupler
// has the same acceleration W^2 r towards its crank's bearing; no gravity.
//
//     coupler - crank 1    ATPOINT        3
//     coupler - crank 2    INLINE         2   the coupler's end slides along x
//     coupler - crank 1    PERPENDICULAR  1   it does not roll
//
// Expected: a beam on two pins that are shaken by a = -W^2 r sin(W t). With w_n = (n pi/l)^2 sqrt(E I/(rho A))
// the middle is off the line between the pins by
//
//     w = sin(W t) W^2 r Sum_{n = 1, 3, 5 …} 4/(n pi) (-1)^((n-1)/2) / (w_n^2 - W^2)
//
// Source: S. Timoshenko, Vibration Problems in Engineering, 1955, section 55, forced vibration of beams.
#include "aluminium_rod.h"
#include "compare.h"

using namespace SimTK;

const Real Tolerance = 2e-3;  // as compare.h reads it, on micrometres; damping takes a part of it

int main() {
    const Real r = 0.1, l = 1, W = 15;  // m, m, rad/s: a tenth of the coupler's first frequency

    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    const Body::Rigid light(MassProperties(0.1, Vec3(0), Inertia(1e-3)));  // kg, kg m^2
    MobilizedBody::Pin crank1(matter.Ground(), Transform(), light, Transform());
    MobilizedBody::Pin crank2(matter.Ground(), Transform(Vec3(l, 0, 0)), light, Transform());
    Motion::Steady(crank1, W);
    Motion::Steady(crank2, W);

    const jprim::ModalBasis basis = AluminiumRod::makeBasis();
    jprim::FlexibleBodyOptions options;
    options.dampingRatios.assign(size_t(basis.getNumModes()), 0.1);
    const jprim::FlexibleBody coupler(matter, forces, basis, options);
    const jprim::Marker start(coupler, AluminiumRod::Start), end(coupler, AluminiumRod::End);
    const jprim::Marker pin1(crank1, Transform(Vec3(r, 0, 0)));
    jprim::AtPoint(start, pin1, "first pin");
    // A line along the coupler: its z axis is the coupler's x axis.
    jprim::InLine(jprim::Marker(crank2, Transform(Vec3(r, 0, 0))), end.withPose(Rotation(Pi / 2, YAxis)),
                  "second pin");
    jprim::Perpendicular(start.withPose(Rotation(-Pi / 2, XAxis)), pin1, "no roll");

    State state = system.realizeTopology();
    coupler.getBody().setQToFitTransform(state, Vec3(r, 0, 0));
    for (const auto& crank : {crank1, crank2}) crank.setOneU(state, 0, W);
    coupler.getBody().setU(state, Vec6(0, 0, 0, 0, W * r, 0));
    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-7);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    stepper.stepTo((8 * Pi + Pi / 2) / W);  // four times round and to the top
    const State& now = integrator.getState();
    system.realize(now, Stage::Position);

    Real sum = 0;
    for (int n = 1; n < 20; n += 2) {
        const Real square = std::pow(n * Pi / l, 4) * AluminiumRod::getStiffness();
        sum += (n % 4 == 1 ? 4 : -4) / (n * Pi) / (square - W * W);
    }
    const Real expected = std::sin(W * now.getTime()) * W * W * r * sum;
    const Real deflection = AluminiumRod::findDeflection(coupler, now);
    const bool agree =
        compare("deflection of the coupler's middle [um]", 1e6 * deflection, 1e6 * expected, Tolerance);
    return agree ? 0 : 1;
}
