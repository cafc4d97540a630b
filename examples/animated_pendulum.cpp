// SPDX-License-Identifier: Apache-2.0
// A Simbody program without a dataset that leaves a picture of its motion: a pendulum in an ATPOINT, drawn by Simbody's own
// decorative geometry, as one HTML file.
//
// Expected: the period of small swings, T = 2 pi sqrt((J + m l^2) / (m g l)), J of a sphere.
#include <jprim/jprim.h>

#include "compare.h"

using namespace SimTK;

// The integrator's, 1e-8 per step, and the square of the amplitude over 16.
const Real Tolerance = 1e-5;

int main(int argc, char** argv) {
    const Real mass = 1, radius = 0.05, inertia = 0.4 * mass * radius * radius;  // kg, m
    const Real length = 0.5, g = 9.81, amplitude = 0.01;
    const Real period = 2 * Pi * std::sqrt((inertia + mass * length * length) / (mass * g * length));

    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    Force::Gravity(forces, matter, -YAxis, g);
    Body::Rigid bob(MassProperties(mass, Vec3(0), Inertia(inertia)));
    bob.addDecoration(Vec3(0), DecorativeSphere(radius));
    bob.addDecoration(Vec3(0), DecorativeLine(Vec3(0), Vec3(0, length, 0)));
    MobilizedBody::Free pendulum(matter.Ground(), bob);
    matter.Ground().addBodyDecoration(Vec3(0, 0.01, 0), DecorativeBrick(Vec3(0.1, 0.01, 0.1)));
    const jprim::AtPoint pivot(jprim::Marker(pendulum, Transform(Vec3(0, length, 0))),
                               jprim::Marker(matter.Ground()), "pivot");
    matter.setShowDefaultGeometry(false);
    State state = system.realizeTopology();
    const Rotation swing(amplitude, ZAxis);
    pendulum.setQToFitTransform(state, Transform(swing, swing * Vec3(0, -length, 0)));

    jprim::Animation animation(system, "pendulum");
    animation.addCurve("x", "m", [&](const State& s) { return pendulum.getBodyOriginLocation(s)[0]; });
    animation.addCurve("force of the pivot", "N", [&](const State& s) {
        system.realize(s, Stage::Acceleration);
        return pivot.calcReactionOnI(s)[1].norm();
    });
    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-8);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    const int steps = 100;
    for (int k = 0; k <= steps; ++k) {
        stepper.stepTo(k * period / steps);
        system.realize(integrator.getState(), Stage::Velocity);
        animation.record(integrator.getState());
    }
    if (jprim::canWriteReports()) animation.write(argc > 1 ? argv[1] : "animated_pendulum.html");

    const State& end = integrator.getState();
    bool good = compare("x after a period [m]", pendulum.getBodyOriginLocation(end)[0],
                        length * std::sin(amplitude), Tolerance);
    good &= compare("frames of the animation", animation.getNumFrames(), steps + 1, 0);
    return good ? 0 : 1;
}
