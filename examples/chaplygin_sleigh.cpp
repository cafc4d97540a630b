// SPDX-License-Identifier: Apache-2.0
// Chaplygin's sleigh: a sledge on a plane, with a blade that does not slip sideways. One GeneralConstraint holds it,
// an equation of velocities written as Adams' GCON is:
//
//     VY(1,0,1) = 0          marker 1 is the blade; 0 is Ground; the component along the blade's own y axis
//
// The mass centre is a distance a ahead of the blade. Pushed into a turn on the spot the sleigh straightens its way:
// turning becomes gliding, and no energy is lost, because the blade's force is across its way.
//
// Expected, with b^2 = J/m + a^2, J about the mass centre, V = b w(0) and tau = a V t / b^2:
//     speed of the blade      v = V tanh tau
//     rate of turn            w = (V/b) / cosh tau
//     heading                 (b/a) gd tau,  gd tau = 2 atan tanh(tau/2)
//     force across the blade  J v w / b^2
// Source: the equations dv/dt = a w^2, b^2 dw/dt = -a v w of S. A. Chaplygin (1911), solved by v^2 + b^2 w^2 = V^2.
#include <jprim/jprim.h>

#include "compare.h"

using namespace SimTK;

// As compare.h reads it. The integrator's accuracy, 1e-9 per step, adds up over the run.
const Real Tolerance = 1e-7;

int main() {
    const Real m = 3, J = 0.4;                 // kg, kg m^2
    const Real a = 0.25, w0 = 5, time = 0.35;  // m, rad/s, s
    const Real b = std::sqrt(J / m + a * a), V = b * w0, tau = a * V * time / (b * b);

    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    MobilizedBody::Planar sleigh(matter.Ground(), Body::Rigid(MassProperties(m, Vec3(0), Inertia(1, 1, J))));

    const jprim::Marker blade(sleigh, Vec3(-a, 0, 0));
    const jprim::GeneralConstraint edge(jprim::Expression("VY(1,0,1)", {{1, blade}}), "edge");

    State state = system.realizeTopology();
    sleigh.setU(state, Vec3(w0, 0, a * w0));  // about the blade: the mass centre moves sideways

    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-9);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    stepper.stepTo(time);
    const State& end = integrator.getState();
    system.realize(end, Stage::Acceleration);

    const Vec3 velocity = blade.findVelocityInGround(end)[1], ahead(sleigh.getBodyRotation(end).x());
    const SpatialVec load = edge.calcReactionOn(end, 1, blade);  // [moment, force] on the blade, in its axes
    const Real v = V * std::tanh(tau), w = V / b / std::cosh(tau);
    bool agree = compare("speed of the blade [m/s]", dot(velocity, ahead), v, Tolerance);
    agree &= compare("rate of turn [rad/s]", sleigh.getU(end)[0], w, Tolerance);
    agree &=
        compare("heading [rad]", sleigh.getQ(end)[0], b / a * 2 * std::atan(std::tanh(tau / 2)), Tolerance);
    agree &= compare("force across the blade [N]", load[1][1], J * v * w / (b * b), Tolerance);
    agree &= compare("force along the blade [N]", load[1][0], 0, Tolerance);
    return agree ? 0 : 1;
}
