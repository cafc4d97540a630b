// SPDX-License-Identifier: Apache-2.0
// A slider-crank whose rod bends under its own inertia. The crank turns at W; no gravity.
//
//     rod - crank pin    ATPOINT + PARALLEL_AXES   5
//     rod - slider       INLINE                    2   the rod's eye stays on the wrist pin, along z
//
// Expected: the rod's points accelerate across it in a straight line from end to end, a1 to a2. A beam on two
// pins under such a load bends in its middle as under the mean of it:
//
//     w = -5 a l^4 / (384 E I/(rho A)),   a the acceleration of the middle across the rigid rod
//
// up to (W/w1)^2 = 4e-4, w1 the first frequency of the rod.
#include "aluminium_rod.h"
#include "compare.h"

using namespace SimTK;

const Real Tolerance = 2e-3;  // as compare.h reads it, on micrometres

int main() {
    const Real r = 0.2, l = 1, W = 3;  // m, m, rad/s

    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    const Body::Rigid light(MassProperties(0.1, Vec3(0), Inertia(1e-3)));  // kg, kg m^2
    MobilizedBody::Pin crank(matter.Ground(), Transform(), light, Transform());
    MobilizedBody::Slider slider(matter.Ground(), Transform(), light, Transform());
    Motion::Steady(crank, W);

    const jprim::ModalBasis basis = AluminiumRod::makeBasis();
    jprim::FlexibleBodyOptions options;
    options.dampingRatios.assign(size_t(basis.getNumModes()), 0.2);
    const jprim::FlexibleBody rod(matter, forces, basis, options);
    const jprim::Marker start(rod, AluminiumRod::Start), end(rod, AluminiumRod::End);
    const jprim::Marker crankPin(crank, Transform(Vec3(r, 0, 0)));
    jprim::Joint::Revolute(start, crankPin, "crank pin");
    jprim::InLine(end, jprim::Marker(slider), "wrist pin");

    State state = system.realizeTopology();
    rod.getBody().setQToFitTransform(state, Vec3(r, 0, 0));
    slider.setOneQ(state, 0, r + l);
    crank.setOneU(state, 0, W);
    rod.getBody().setU(state, Vec6(0, 0, -W * r / l, 0, W * r, 0));
    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-7);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    stepper.stepTo((2 * Pi + 1) / W);  // once round and 1 rad
    const State& now = integrator.getState();
    system.realize(now, Stage::Acceleration);

    // The rigid rod: sin(theta) = r/l sin(phi), theta its angle below the x axis.
    const Real phi = W * now.getTime(), s = r / l * std::sin(phi), c = std::sqrt(1 - s * s);
    const Real thetaDot = W * r / l * std::cos(phi) / c;
    const Real thetaDDot = (thetaDot * thetaDot * s - W * W * s) / c;
    const Vec3 along(c, -s, 0), across(s, c, 0);
    const Vec3 pin = -W * W * r * Vec3(std::cos(phi), std::sin(phi), 0);
    const Vec3 middle = pin + l / 2 * (-thetaDDot * across - thetaDot * thetaDot * along);
    const Real expected = -5 * dot(middle, across) * std::pow(l, 4) / (384 * AluminiumRod::getStiffness());

    const Real deflection = AluminiumRod::findDeflection(rod, now);
    const bool agree =
        compare("deflection of the rod's middle [um]", 1e6 * deflection, 1e6 * expected, Tolerance);
    return agree ? 0 : 1;
}
