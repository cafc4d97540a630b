// SPDX-License-Identifier: Apache-2.0
// A slider-crank of three free bodies and seven primitives, started at rest under gravity.
//
//     3 bodies                                    +18 freedoms
//     crank - ground    ATPOINT + PARALLEL_AXES     5   the bearing O: a hinge about z
//     rod - crank       ATPOINT + PARALLEL_AXES     5   the crank pin A: a hinge about z
//     rod - slider      INLINE                      2   the rod's eye stays on the wrist pin P, along z
//     slider - ground   INLINE + ORIENTATION        5   the guide: slides along x, does not turn
//                                                 = 1 freedom, no equation redundant
//
// A hinge at P instead of INLINE would hold rod and slider in the plane of motion a second time: three
// redundant equations.
//
// Expected (exact_slider_crank.h): with phi the crank angle that is reached,
//     slider position  x = r cos phi + sqrt(l^2 - r^2 sin^2 phi)
//     slider speed     |x' phi_dot|, phi_dot from energy conservation
//     force of the guide on the slider  N = m (g + x_ddot tan theta), m the slider and half the rod
#include <jprim/jprim.h>

#include "compare.h"
#include "exact_slider_crank.h"

using namespace SimTK;

// As compare.h reads it. The integrator's accuracy, 1e-9 per step, adds up over the run.
const Real Tolerance = 1e-6;

int main() {
    const ExactSliderCrank exact;
    const Real r = exact.r, l = exact.l;  // m

    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralForceSubsystem forces(system);
    Force::Gravity(forces, matter, -YAxis, exact.g);

    // Body frames: the crank's at O and the rod's at A, each with x along the link; the slider's at P.
    const Real slim = 1e-3;  // kg m^2, about the links' own axes; has no effect on a planar motion
    const Real rodInertia = exact.rodMass / 2 * l * l;
    const MassProperties crankMass(exact.crankMass, Vec3(r / 2, 0, 0),
                                   Inertia(slim, exact.crankInertia, exact.crankInertia));
    const MassProperties rodMass(exact.rodMass, Vec3(l / 2, 0, 0), Inertia(slim, rodInertia, rodInertia));
    const MassProperties sliderMass(exact.sliderMass, Vec3(0), Inertia(1e-3));  // kg m^2
    MobilizedBody::Free crank(matter.Ground(), Body::Rigid(crankMass));
    MobilizedBody::Free rod(matter.Ground(), Body::Rigid(rodMass));
    MobilizedBody::Free slider(matter.Ground(), Body::Rigid(sliderMass));

    const jprim::Marker ground(matter.Ground()), rodA(rod), sliderP(slider);
    const jprim::Marker crankO(crank), crankA(crank, Vec3(r, 0, 0)), rodP(rod, Vec3(l, 0, 0));
    const jprim::Marker guideway(matter.Ground(), Rotation(Pi / 2, YAxis));  // its z axis is ground's x axis

    jprim::AtPoint(crankO, ground, "bearing");
    jprim::ParallelAxes(crankO, ground, "bearing");
    jprim::AtPoint(rodA, crankA, "crank pin");
    jprim::ParallelAxes(rodA, crankA, "crank pin");
    jprim::InLine(rodP, sliderP, "wrist pin");
    const jprim::InLine guide(sliderP, guideway, "guide");
    jprim::Orientation(sliderP, ground, "guide");

    State state = system.realizeTopology();
    const Vec3 A(r * std::cos(exact.phi0), r * std::sin(exact.phi0), 0), P(exact.getX(exact.phi0), 0, 0);
    crank.setQToFitTransform(state, Rotation(exact.phi0, ZAxis));
    rod.setQToFitTransform(state, Transform(Rotation(-std::atan(exact.getTanTheta(exact.phi0)), ZAxis), A));
    slider.setQToFitTransform(state, P);
    system.realize(state, Stage::Position);
    const jprim::ConstraintReport report = jprim::analyzeConstraints(matter, state);
    std::printf("freedoms %d, redundant equations %d\n", report.getDegreesOfFreedom(),
                report.getNumRedundant());

    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-9);
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    stepper.stepTo(1.0);  // s
    const State& end = integrator.getState();
    system.realize(end, Stage::Acceleration);

    const Vec3 pin = crankA.findPoseInGround(end).p();
    const Real phi = std::atan2(pin[1], pin[0]);
    const Real x = slider.getBodyOriginLocation(end)[0], v = slider.getBodyOriginVelocity(end)[0];
    const int onI = 0, FY = 3;
    std::printf("crank angle %.6f rad after %.1f s\n", phi, end.getTime());
    bool agree = report.getDegreesOfFreedom() == 1 && report.getNumRedundant() == 0;
    agree &= compare("slider position [m]", x, exact.getX(phi), Tolerance);
    agree &= compare("slider speed [m/s]", std::abs(v), std::abs(exact.getX1(phi)) * exact.getSpeed(phi),
                     Tolerance);
    agree &= compare("force of the guide on the slider [N]", guide.JPRIM(end, onI, FY),
                     exact.getGuideForce(phi), Tolerance);
    return agree ? 0 : 1;
}
