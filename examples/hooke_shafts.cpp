// SPDX-License-Identifier: Apache-2.0
// Two shafts at an angle beta, joined by a Hooke joint. The input shaft turns steadily, the output shaft
// does not: it leads and lags twice per turn.
//
//     input shaft: a pin                  +1 freedom, turned by a motion
//     output shaft: a free body           +6 freedoms
//     HOOKE, input - output                4   ATPOINT + PERPENDICULAR: the cross
//     INLINE, far end of output - ground   2   a bearing that holds a point on the output axis
//                                        = 1 freedom, no equation redundant
//
// A hinge instead of INLINE would hold the near end, which the cross holds, a second time: three redundant
// equations.
//
// Expected, with psi = omega t the turn of the input from where its bar of the cross, y_J, lies in the plane
// of the shafts:
//     output angle    tan eta = tan psi / cos beta
//     output speed    eta_dot = omega cos beta / (1 - sin^2 beta cos^2 psi)
//     input torque    omega T = eta_dot I eta_ddot: the power goes into the output's inertia I alone
#include <jprim/jprim.h>

#include "compare.h"

using namespace SimTK;

// As compare.h reads it. The integrator's accuracy, 1e-9 per step, adds up over the run.
const Real Tolerance = 1e-6;

int main() {
    const Real beta = 35 * Pi / 180;                            // rad
    const Real omega = 10;                                      // rad/s
    const Real duration = 0.9;                                  // s, one turn and a bit
    const Real length = 0.4;                                    // m, of the output shaft
    const Real axial = 0.02;                                    // kg m^2, I of the output shaft
    const MassProperties inputMass(1, Vec3(0), Inertia(0.01));  // kg, m, kg m^2
    const MassProperties outputMass(3, Vec3(0, 0, length / 2), Inertia(0.2, 0.2, axial));

    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);

    // The input turns about ground's z axis, the output about z turned by beta about x. They meet in the
    // origin.
    const Rotation R_GO(beta, XAxis);
    MobilizedBody::Pin input(matter.Ground(), Body::Rigid(inputMass));
    MobilizedBody::Free output(matter.Ground(), Body::Rigid(outputMass));
    Motion::Steady(input, omega);

    // Hooke's bars are x_I and y_J; the z axes lie along the shafts.
    const jprim::Marker I(output), J(input), farEnd(output, Vec3(0, 0, length)),
        outputAxis(matter.Ground(), R_GO);
    const jprim::Joint cross = jprim::Joint::Hooke(I, J, "cross");
    jprim::InLine(farEnd, outputAxis, "bearing");

    State state = system.realizeTopology();
    output.setQToFitTransform(state, R_GO);
    system.realize(state, Stage::Position);
    const jprim::ConstraintReport report = jprim::analyzeConstraints(matter, state);
    std::printf("freedoms %d, redundant equations %d\n", report.getDegreesOfFreedom(),
                report.getNumRedundant());

    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-9);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);  // finds the output's speed as well
    stepper.stepTo(duration);
    const State& end = integrator.getState();
    system.realize(end, Stage::Acceleration);

    const Real psi = omega * duration, s = std::sin(beta), c = std::cos(beta);
    const Real k = 1 - square(s * std::cos(psi));
    const Real etaDot = omega * c / k, etaDDot = -omega * omega * c * s * s * std::sin(2 * psi) / (k * k);

    const Vec3 x_O = ~R_GO * output.getBodyRotation(end).x();  // the output's x axis, seen along its own axis
    const Real speed = dot(output.getBodyAngularVelocity(end), R_GO.z());
    const int onJ = 1, TZ = 8;
    bool agree = report.getDegreesOfFreedom() == 1 && report.getNumRedundant() == 0;
    agree &= compare("output angle, less whole turns [rad]", std::atan2(x_O[1], x_O[0]),
                     std::atan2(std::sin(psi), c * std::cos(psi)), Tolerance);
    agree &= compare("output speed [rad/s]", speed, etaDot, Tolerance);
    agree &= compare("output speed / input speed", speed / omega, c / k, Tolerance);
    agree &= compare("torque of the cross on the input [N m]", cross.JOINT(end, onJ, TZ),
                     -axial * etaDDot * etaDot / omega, Tolerance);
    return agree ? 0 : 1;
}
