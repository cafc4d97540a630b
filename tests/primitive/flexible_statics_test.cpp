// SPDX-License-Identifier: Apache-2.0
// A cantilever under its own weight and under a load that a primitive puts on it, against beam theory.
#include <gtest/gtest.h>

#include <cmath>

#include "jprim/jprim.h"
#include "support/linearize.h"
#include "support/marker_load.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using namespace testing;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

// Beam theory is linear; deflections here are 1e-3 of the length and turn the loads by as much squared.
constexpr double Tolerance = 1e-3;
constexpr int Elements = 10;

/// Clamped at node 1 to Ground by an ATPOINT and an ORIENTATION.
struct Cantilever : FlexibleSystem {
    Cantilever()
        : beam(
              matter, forces,
              reduceToModes(makeFiniteElementModel(properties), {{{1}, 0, {}}, {{Elements + 1}, 0, {}}}, 12)),
          clamp(Joint::Fixed(Marker(matter.Ground()), Marker(beam, 1), "clamp")) {}

    State solve() {
        State state = system.realizeTopology();
        findEquilibrium(*this, state);
        return state;
    }

    UniformBeam properties = makeSteelBeam(Elements);
    FlexibleBody beam;
    Joint clamp;
};

void expectNear(const Vec3& value, const Vec3& expected) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(value[k], expected[k], Tolerance * expected.norm()) << k;
}

// Tip: rho A g L^4/(8 E I); root: weight and weight times L/2. Gravity in both planes of bending.
TEST(FlexibleStatics, CantileverUnderItsWeight) {
    Cantilever c;
    const Vec3 g(0, -0.3, -0.5);
    SimTK::Force::Gravity(c.forces, c.matter, g);
    const State state = c.solve();
    const UniformBeam& b = c.properties;
    const double rhoA = b.density * b.area, L = b.length;
    const Vec3 tip = Marker(c.beam, Elements + 1).findPoseInGround(state).p();
    const double common = rhoA * std::pow(L, 4) / (8 * b.youngsModulus);
    EXPECT_NEAR(tip[1] / (common * g[1] / b.secondMomentZ), 1, Tolerance);
    EXPECT_NEAR(tip[2] / (common * g[2] / b.secondMomentY), 1, Tolerance);
    const SpatialVec onBeam = c.clamp.calcReactionOnJ(state);
    expectNear(onBeam[1], -rhoA * L * g);
    expectNear(onBeam[0], -(Vec3(L / 2, 0, 0) % (rhoA * L * g)));
}

// J, the plane, is on the beam's tip and I on a heavy ball beside it, guided along z, that rests on the plane
// at an offset: the tip carries the ball's weight P and its moment P d.
// Tip: P L^3/(3 E I) + P d L^2/(2 E I) down, slope P L^2/(2 E I) + P d L/(E I).
TEST(FlexibleStatics, OffsetLoadThroughAnInPlane) {
    Cantilever c;
    const double m = 0.03, g = 9.81, P = m * g, d = 0.35;
    SimTK::MobilizedBody::Slider ball(
        c.matter.Ground(), Transform(Rotation(-SimTK::Pi / 2, SimTK::YAxis), Vec3(2 + d, 0, 0)),
        SimTK::Body::Rigid(SimTK::MassProperties(m, Vec3(0), SimTK::Inertia(1))),
        Transform(Rotation(-SimTK::Pi / 2, SimTK::YAxis)));
    SimTK::Force::ConstantForce(c.forces, ball, Vec3(0), Vec3(0, 0, -P));
    const InPlane rest(Marker(ball), Marker(c.beam, Elements + 1), "rest");
    const State state = c.solve();
    const UniformBeam& b = c.properties;
    const double L = b.length, EI = b.youngsModulus * b.secondMomentY;
    const Transform tip = Marker(c.beam, Elements + 1).findPoseInGround(state);
    EXPECT_NEAR(tip.p()[2] / (-P * L * L * L / (3 * EI) - P * d * L * L / (2 * EI)), 1, Tolerance);
    EXPECT_NEAR(-tip.x()[2] / (P * L * L / (2 * EI) + P * d * L / EI), 1, Tolerance);
    const SpatialVec onTip = rest.calcReactionOnJ(state), atRoot = c.clamp.calcReactionOnJ(state);
    expectNear(onTip[1], Vec3(0, 0, -P));
    expectNear(onTip[0], Vec3(0, P * d, 0));
    expectNear(atRoot[1], Vec3(0, 0, P));
    expectNear(atRoot[0], Vec3(0, -P * (L + d), 0));
}

// The same load put on the tip by hand gives the same tip; without the lever it does not.
TEST(FlexibleStatics, TheLeverCounts) {
    const double P = 0.3, d = 0.35;
    const UniformBeam b = makeSteelBeam(1);
    const double L = b.length, EI = b.youngsModulus * b.secondMomentY;
    const auto calcTip = [&](double moment) {
        Cantilever c;
        const Marker tip(c.beam, Elements + 1);
        SimTK::Force::Custom(c.forces, new MarkerLoad(tip, SpatialVec(Vec3(0, moment, 0), Vec3(0, 0, -P))));
        return tip.findPoseInGround(c.solve()).p()[2];
    };
    const double expected = -P * L * L * L / (3 * EI) - P * d * L * L / (2 * EI);
    EXPECT_NEAR(calcTip(P * d) / expected, 1, Tolerance);
    EXPECT_GT(std::abs(calcTip(0) / expected - 1), 100 * Tolerance);
}

}  // namespace
}  // namespace jprim
