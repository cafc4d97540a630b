// SPDX-License-Identifier: Apache-2.0
// A parallelogram linkage: a bench on two hanging arms of equal length. It swings without turning.
//
//     two arms on pins, one free body        +8 freedoms
//     bench - arm 1   INLINE + PARALLEL_AXES   4   a round pin along z
//     bench - arm 2   INLINE                   2   closes the loop
//     bench - ground  INPLANE                  1   a collar: the bench does not slide along the pins
//                                            = 1 freedom, no equation redundant
//
// A hinge at arm 2 instead of INLINE would be redundant by three. The linkage is singular where arms and
// bench are in one line, at 90 deg; released at 60 deg it stays away from there.
//
// Expected: every point of the bench moves on a circle of radius r, with phi_ddot = -(g/L) sin phi where
//     L = (2 J + m r^2) / (2 m_a r/2 + m r)         J, m_a of an arm about its pin; m of the bench
//     period                  T = 2 pi sqrt(L/g) / agm(1, cos(phi0/2))
//     at the bottom           phi_dot^2 = 2 (g/L) (1 - cos phi0)
//     there each arm carries  m (g + r phi_dot^2) / 2
#include <jprim/jprim.h>

#include "compare.h"

using namespace SimTK;

// As compare.h reads it. The integrator's accuracy, 1e-9 per step, adds up over the run.
const Real Tolerance = 1e-6;

// Arithmetic-geometric mean.
Real agm(Real a, Real b) {
    while (std::abs(a - b) > 4 * Eps * a) {
        const Real mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return a;
}

int main() {
    const Real g = 9.80665;              // m/s^2
    const Real r = 0.5, width = 0.8;     // m, arm length, distance of the pins
    const Real armMass = 0.6, mass = 4;  // kg, centres in the middle
    const Real J = armMass * r * r / 3;  // kg m^2, slender arm about its pin
    const Real phi0 = 60 * Pi / 180;     // rad, from hanging
    const Real L = (2 * J + mass * r * r) / (armMass * r + mass * r);
    const Real period = 2 * Pi * std::sqrt(L / g) / agm(1, std::cos(phi0 / 2));
    const Real speed = std::sqrt(2 * g / L * (1 - std::cos(phi0)));

    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    Force::Gravity(forces, matter, -YAxis, g);

    // Arm frames at the upper pins, y upwards when hanging; the bench's frame in its middle.
    const Body::Rigid arm(MassProperties(armMass, Vec3(0, -r / 2, 0), Inertia(J, 1e-3, J)));
    const Body::Rigid seat(MassProperties(mass, Vec3(0), Inertia(0.3)));  // kg m^2; it does not turn
    MobilizedBody::Pin arm1(matter.Ground(), Vec3(-width / 2, 0, 0), arm, Vec3(0));
    MobilizedBody::Pin arm2(matter.Ground(), Vec3(width / 2, 0, 0), arm, Vec3(0));
    MobilizedBody::Free bench(matter.Ground(), seat);

    const jprim::Marker pin1(arm1, Vec3(0, -r, 0)), pin2(arm2, Vec3(0, -r, 0)), ground(matter.Ground());
    const jprim::Marker eye1(bench, Vec3(-width / 2, 0, 0)), eye2(bench, Vec3(width / 2, 0, 0));
    const jprim::InLine hang1(eye1, pin1, "pin 1"), hang2(eye2, pin2, "pin 2");
    jprim::ParallelAxes(eye1, pin1, "pin 1");
    jprim::InPlane(jprim::Marker(bench), ground, "collar");

    State state = system.realizeTopology();
    arm1.setAngle(state, phi0);
    arm2.setAngle(state, phi0);
    bench.setQToFitTransform(state, Vec3(r * std::sin(phi0), -r * std::cos(phi0), 0));
    system.realize(state, Stage::Position);
    const jprim::ConstraintReport report = jprim::analyzeConstraints(matter, state);
    std::printf("freedoms %d, redundant equations %d\n", report.getDegreesOfFreedom(),
                report.getNumRedundant());

    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-9);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    stepper.stepTo(1.25 * period);  // there and back, then down to the bottom
    const State& end = integrator.getState();
    system.realize(end, Stage::Acceleration);

    // The simulated bench passes the bottom at phi = 0, not exactly now.
    const Real passing = end.getTime() - arm1.getAngle(end) / arm1.getRate(end);
    const Vec3 p = bench.getBodyOriginLocation(end);
    const int onI = 0, FY = 3;
    const Real load = mass * (g + r * speed * speed) / 2;
    bool agree = report.getDegreesOfFreedom() == 1 && report.getNumRedundant() == 0;
    agree &= compare("period [s]", passing / 1.25, period, Tolerance);
    agree &= compare("speed of the bench at the bottom [m/s]", bench.getBodyOriginVelocity(end).norm(),
                     r * speed, Tolerance);
    agree &= compare("radius of its circle [m]", p.norm(), r, Tolerance);
    agree &= compare("turn of the bench [rad]", std::asin(bench.getBodyRotation(end).x()[1]), 0, Tolerance);
    agree &= compare("load on pin 1 at the bottom [N]", hang1.JPRIM(end, onI, FY), load, Tolerance);
    agree &= compare("load on pin 2 at the bottom [N]", hang2.JPRIM(end, onI, FY), load, Tolerance);
    return agree ? 0 : 1;
}
