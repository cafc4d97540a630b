// SPDX-License-Identifier: Apache-2.0
// A user's program against the installed package: a pendulum hanging from a hinge, released from horizontal.
// At the lowest point the hinge carries m g (1 + 2 m l^2 / (I + m l^2)): the weight and the centripetal
// force.
#include <jprim/jprim.h>

#include <cmath>
#include <cstdio>

using namespace SimTK;

int main() {
    const Real m = 2, l = 0.5, I = 0.1, g = 9.81;  // kg, m, kg m^2, m/s^2
    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    Force::Gravity gravity(forces, matter, -YAxis, g);

    Body::Rigid body(MassProperties(m, Vec3(0), Inertia(0.01, I, I)));
    MobilizedBody::Free rod(matter.Ground(), body);
    const jprim::Marker end(rod, Transform(Vec3(-l, 0, 0)));
    const jprim::Marker frame(matter.Ground());
    const jprim::Joint hinge = jprim::Joint::Revolute(end, frame, "hinge");

    State state = system.realizeTopology();
    rod.setQToFitTranslation(state, Vec3(l, 0, 0));
    const Real K = 1.8540746773013719;  // complete elliptic integral K(sin 45 deg)
    const Real quarterPeriod = K / std::sqrt(m * g * l / (I + m * l * l));

    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-8);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    stepper.stepTo(quarterPeriod);
    state = stepper.getState();
    system.realize(state, Stage::Acceleration);

    const Real carried = hinge.calcReactionOnI(state)[1][1];
    const Real expected = m * g * (1 + 2 * m * l * l / (I + m * l * l));
    std::printf("force on the rod %.9g N, expected %.9g N\n", carried, expected);
    return std::abs(carried - expected) < 1e-5 * expected ? 0 : 1;
}
