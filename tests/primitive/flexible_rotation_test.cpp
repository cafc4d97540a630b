// SPDX-License-Identifier: Apache-2.0
// Deformation and rotation together: what Partial inertia coupling gives, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "jprim/jprim.h"
#include "support/linearize.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using namespace testing;
using SimTK::Pi;
using SimTK::Real;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vec6;

constexpr int Elements = 20;

// As stiff about y as about z, and soft: the first bending pair is at some 30 rad/s.
UniformBeam makeSoftBeam(Real softness = 1000) {
    UniformBeam beam = makeSteelBeam(Elements);
    beam.youngsModulus /= softness;
    beam.shearModulus /= softness;
    beam.secondMomentZ = beam.secondMomentY;
    return beam;
}

FlexibleBody makeFreeBeam(FlexibleSystem& s, int modes, Real damping, Real softness = 1000) {
    const ModalBasis basis = reduceToModes(makeFiniteElementModel(makeSoftBeam(softness)), {}, modes);
    return FlexibleBody(s.matter, s.forces, basis,
                        {InertiaCoupling::Partial, std::vector<Real>(size_t(modes), damping)});
}

//-------------------------------------------------------------------------------------- stretching
// Free and turning about its middle across its axis at W: u(x) = rho W^2 (L^2 x/8 - x^3/6)/E from the middle,
// at the tip rho W^2 (L/2)^3/(3 E): that of a bar of half the length held at a hub.
TEST(FlexibleRotation, StretchesATurningBar) {
    constexpr Real Tolerance = 5e-3, W = 0.5;
    FlexibleSystem s;
    const FlexibleBody beam = makeFreeBeam(s, 60, 1);
    State state = s.system.realizeTopology();
    beam.getBody().setU(state, Vec6(0, 0, W, 0, 1 * W, 0));
    s.system.realize(state, SimTK::Stage::Acceleration);
    // q_k = (load on mode k)/w_k^2: at rest in the modes, their accelerations are those loads.
    SimTK::Vector q = beam.getModalAccelerations(state);
    for (int k = 0; k < q.size(); ++k) q[k] /= SimTK::square(beam.getBasis().frequencies[k]);
    beam.setModalCoordinates(state, q);
    s.system.realize(state, SimTK::Stage::Acceleration);
    EXPECT_LT(beam.getModalAccelerations(state).norm(), 1e-9);
    const UniformBeam b = makeSoftBeam();
    const Real half = b.length / 2;
    const Real extension = b.density * W * W * half * half * half / (3 * b.youngsModulus);
    const Real tip = Marker(beam, Elements + 1).findPoseInBody(state).p()[0] - b.length;
    EXPECT_NEAR(tip / extension, 1, Tolerance);
}

// Held at a hub that turns at W, and damped until nothing moves in turning axes: the tip is out by
// rho W^2 L^3/(3 E), and the hub holds the bar with m W^2 L/2.
TEST(FlexibleRotation, StretchesABarOnAHub) {
    constexpr Real Tolerance = 5e-3, W = 0.5;
    FlexibleSystem s;
    const UniformBeam b = makeSoftBeam();
    const ModalBasis basis = reduceToModes(makeFiniteElementModel(b), {{{1}, 0, {}}}, 40);
    const FlexibleBody beam(s.matter, s.forces, basis,
                            {InertiaCoupling::Partial, std::vector<Real>(size_t(basis.getNumModes()), 1.)});
    SimTK::MobilizedBody::Pin hub(s.matter.Ground(), SimTK::Transform(),
                                  SimTK::Body::Rigid(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(1))),
                                  SimTK::Transform());
    SimTK::Motion::Steady(hub, W);
    const Joint clamp = Joint::Fixed(Marker(beam, 1), Marker(hub));
    State state = s.system.realizeTopology();
    beam.getBody().setU(state, Vec6(0, 0, W, 0, 0, 0));
    hub.setOneU(state, 0, W);
    const State end = integrate(s, state, 2, 1e-6, [](const State&) {});
    const Real L = b.length;
    const Real extension = b.density * W * W * L * L * L / (3 * b.youngsModulus);
    const Real tip = Marker(beam, Elements + 1).findPoseInGround(end).p().norm() - L;
    EXPECT_NEAR(tip / extension, 1, Tolerance);
    const Real force = clamp.calcReactionOnI(end)[1].norm();
    EXPECT_NEAR(force / (b.density * b.area * L * W * W * L / 2), 1, Tolerance);
}

//------------------------------------------------------------------------------------ pair of modes
// Spinning about its axis at W, a beam with equal bending modes q1, q2 has, in axes that turn with it,
// q1" - 2 W q2' + w^2 q1 = 0 and its mirror image: two frequencies that differ by 2 W.
TEST(FlexibleRotation, SplitsAPairOfModes) {
    constexpr Real Tolerance = 1e-2, W = 3;
    FlexibleSystem s;
    const FlexibleBody beam = makeFreeBeam(s, 2, 0);
    State state = s.system.realizeTopology();
    beam.getBody().setU(state, Vec6(W, 0, 0, 0, 0, 0));
    const auto calcAccelerations = [&](Real q1, Real q2, Real v1, Real v2) {
        beam.setModalCoordinates(state, SimTK::Vector(SimTK::Vec2(q1, q2)));
        beam.setModalVelocities(state, SimTK::Vector(SimTK::Vec2(v1, v2)));
        s.system.realize(state, SimTK::Stage::Acceleration);
        return beam.getModalAccelerations(state);
    };
    const Real k = -calcAccelerations(1, 0, 0, 0)[0], g = calcAccelerations(0, 0, 0, 1)[0];
    EXPECT_NEAR(calcAccelerations(0, 0, 1, 0)[1], -g, 1e-9 * std::abs(g));
    // z^2 - g z - k = 0 for circular motions q1 + i q2 ~ exp(i z t).
    const Real root = std::sqrt(g * g / 4 + k), high = root + std::abs(g) / 2, low = root - std::abs(g) / 2;
    EXPECT_NEAR((high - low) / (2 * W), 1, Tolerance);
    const UniformBeam b = makeSoftBeam();
    const Real still = SimTK::square(4.730040744862704 / b.length) *
                       std::sqrt(b.youngsModulus * b.secondMomentY / (b.density * b.area));
    EXPECT_NEAR(std::sqrt(k) / still, 1, 1e-3);
}

//------------------------------------------------------------------------------------------- energy
// calcEnergy() + calcCouplingEnergy() of a free tumbling beam changes at the rate ~w (Sum J_k q_k) dw/dt, the
// part that is left out, and at no other.
TEST(FlexibleRotation, TumblingBeamLosesOnlyTheEnergyItIsSaidTo) {
    FlexibleSystem s;
    const FlexibleBody beam = makeFreeBeam(s, 40, 0, 2e4);
    State state = s.system.realizeTopology();
    beam.getBody().setU(state, Vec6(9, 6, -7, 0.1, 0, 0.2));
    s.system.realize(state, SimTK::Stage::Acceleration);
    const auto calcEnergy = [&](const State& now) {
        return s.system.calcEnergy(now) + beam.calcCouplingEnergy(now);
    };
    const auto calcRate = [&](const State& now) {
        const SimTK::Rotation& R = beam.getBody().getBodyRotation(now);
        const Vec3 w = ~R * beam.getBody().getBodyAngularVelocity(now);
        const Vec3 b = ~R * beam.getBody().getBodyAngularAcceleration(now);
        const SimTK::Vector q = beam.getModalCoordinates(now);
        Vec3 momentum(0);
        for (int k = 0; k < q.size(); ++k) momentum += q[k] * (beam.getBasis().inertiaChange[k] * w);
        return SimTK::dot(momentum, b);
    };
    const Real start = calcEnergy(state);
    Real expected = 0, largest = 0, time = 0, rate = calcRate(state), error = 0;
    integrate(s, state, 0.5, 1e-12, [&](const State& now) {
        const Real next = calcRate(now);
        expected += (now.getTime() - time) * (rate + next) / 2;
        time = now.getTime();
        rate = next;
        largest = std::max(largest, std::abs(expected));
        error = std::max(error, std::abs(calcEnergy(now) - start - expected));
    });
    EXPECT_LT(error, 1e-2 * largest);  // the trapezoidal rule over the integrator's steps
    EXPECT_LT(largest, 1e-2 * start);  // of first order in the deformation
    EXPECT_GT(largest, 1e-12 * start);
}

}  // namespace
}  // namespace jprim
