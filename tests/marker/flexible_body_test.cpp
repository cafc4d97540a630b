// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/flexible_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "jprim/flexible/reduce_to_modes.h"
#include "jprim/marker/marker.h"
#include "support/expect_error.h"
#include "support/linearize.h"
#include "support/marker_load.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;
using SimTK::Vec6;
using SimTK::Vector;
using testing::FlexibleSystem;

const ModalBasis& getBasis() {
    static const ModalBasis basis =
        reduceToModes(makeFiniteElementModel(testing::makeSteelBeam(4)), {{{5}, 0, {}}}, 7);
    return basis;
}

Vector makeValues(Real size) {
    Vector values(getBasis().getNumModes());
    for (int k = 0; k < values.size(); ++k) values[k] = size * std::sin(1.7 * k + 0.4);
    return values;
}

//------------------------------------------------------------------------------------------ totals
// Mass and mass centre are the body's; momentum is that of the rigid motion, however the modes move: they
// have none themselves. What the carriers add is 2^-40 of the modal velocities.
TEST(FlexibleBody, ModesHaveEnergyButNoMassAndNoMomentum) {
    constexpr Real Rounding = 1e-12;
    FlexibleSystem s;
    const FlexibleBody body(s.matter, s.forces, getBasis(), {InertiaCoupling::Constant, {}});
    State state = s.system.realizeTopology();
    body.getBody().setQToFitTransform(state,
                                      Transform(SimTK::Rotation(0.3, Vec3(1, 2, 3)), Vec3(0.5, -1, 2)));
    body.getBody().setU(state, Vec6(0.4, -0.3, 0.9, 1, 2, -1));
    s.system.realize(state, SimTK::Stage::Velocity);
    const Real rigidEnergy = s.system.calcKineticEnergy(state);
    const SpatialVec rigid = s.matter.calcSystemMomentumAboutGroundOrigin(state);
    const Vec3 center = s.matter.calcSystemMassCenterLocationInGround(state);

    const Vector q = makeValues(0.01), qdot = makeValues(2);
    body.setModalCoordinates(state, q);
    body.setModalVelocities(state, qdot);
    s.system.realize(state, SimTK::Stage::Velocity);
    const SpatialVec momentum = s.matter.calcSystemMomentumAboutGroundOrigin(state);
    EXPECT_NEAR(s.matter.calcSystemMass(state), getBasis().rigid.mass, Rounding);
    EXPECT_LT((s.matter.calcSystemMassCenterLocationInGround(state) - center).norm(), Rounding);
    EXPECT_LT((momentum[1] - rigid[1]).norm(), Rounding * rigid[1].norm());
    EXPECT_LT((momentum[0] - rigid[0]).norm(), Rounding * rigid[0].norm());
    EXPECT_NEAR(s.system.calcKineticEnergy(state), rigidEnergy + qdot.normSqr() / 2, Rounding * rigidEnergy);
    EXPECT_LT((body.getModalCoordinates(state) - q).norm(), Rounding * q.norm());
}

// In free fall nothing bends, with any coupling: gravity acts on mass, and modes have none.
TEST(FlexibleBody, FallsWithoutBending) {
    FlexibleSystem s;
    const Vec3 g(1, -9, 3);
    SimTK::Force::Gravity(s.forces, s.matter, g);
    const FlexibleBody body(s.matter, s.forces, getBasis());
    const State state = s.system.realizeTopology();
    s.system.realize(state, SimTK::Stage::Acceleration);
    EXPECT_LT(body.getModalAccelerations(state).norm(), 1e-12);
    EXPECT_LT((body.getBody().getBodyOriginAcceleration(state) - g).norm(), 1e-12);
}

// d2q/dt2 = -w^2 q - 2 zeta w dq/dt, energy w^2 q^2/2, power 2 zeta w qdot^2.
TEST(FlexibleBody, ModesAreDampedOscillators) {
    FlexibleSystem s;
    const std::vector<Real> ratios(size_t(getBasis().getNumModes()), 0.07);
    const FlexibleBody body(s.matter, s.forces, getBasis(), {InertiaCoupling::Partial, ratios});
    State state = s.system.realizeTopology();
    const Vector q = makeValues(1e-3), qdot = makeValues(0.5);
    body.setModalCoordinates(state, q);
    body.setModalVelocities(state, qdot);
    s.system.realize(state, SimTK::Stage::Acceleration);
    const Vector accelerations = body.getModalAccelerations(state);
    Real energy = 0, power = 0;
    for (int k = 0; k < q.size(); ++k) {
        const Real w = getBasis().frequencies[k];
        const Real expected = -w * w * q[k] - 2 * 0.07 * w * qdot[k];
        EXPECT_NEAR(accelerations[k] / expected, 1, 1e-10);
        energy += SimTK::square(w * q[k]) / 2;
        power += 2 * 0.07 * w * qdot[k] * qdot[k];
    }
    EXPECT_NEAR(s.system.calcPotentialEnergy(state) / energy, 1, 1e-12);
    EXPECT_NEAR(body.calcElasticEnergy(state) / energy, 1, 1e-12);
    EXPECT_NEAR(body.calcDissipation(state) / power, 1, 1e-12);
}

TEST(FlexibleBody, DampingRatiosByFrequency) {
    const Real Turn = 2 * SimTK::Pi;
    EXPECT_EQ(calcDefaultDampingRatio(99 * Turn), 0.01);
    EXPECT_EQ(calcDefaultDampingRatio(101 * Turn), 0.1);
    EXPECT_EQ(calcDefaultDampingRatio(999 * Turn), 0.1);
    EXPECT_EQ(calcDefaultDampingRatio(1001 * Turn), 1);
}

//----------------------------------------------------------------------------------------- markers
// Velocity and acceleration of a flexible marker in Ground against differences of its pose along the motion
// that a load makes.
TEST(FlexibleMarker, VelocityAndAccelerationAreDerivativesOfThePose) {
    constexpr Real Step = 1e-7, Tolerance = 1e-5;  // the fastest mode turns by 1e-3 rad in a step
    FlexibleSystem s;
    const FlexibleBody body(s.matter, s.forces, getBasis());
    const Marker marker(body, 5, Transform(SimTK::Rotation(0.5, Vec3(1, -1, 2)), Vec3(0.1, 0.2, -0.1)));
    SimTK::Force::Custom(s.forces,
                         new testing::MarkerLoad(marker, SpatialVec(Vec3(3, -5, 2), Vec3(20, 30, -10))));
    State start = s.system.realizeTopology();
    body.getBody().setU(start, Vec6(0.5, -0.7, 0.9, 0.3, 0.2, -0.1));
    body.setModalCoordinates(start, makeValues(0.01));
    body.setModalVelocities(start, makeValues(0.3));
    s.system.realize(start, SimTK::Stage::Acceleration);
    // q(t) to second order, u(t) to first.
    const auto findAt = [&](Real t) {
        State state = start;
        state.updQ() = start.getQ() + t * start.getQDot() + (t * t / 2) * start.getQDotDot();
        state.updU() = start.getU() + t * start.getUDot();
        s.system.realize(state, SimTK::Stage::Velocity);
        return std::pair(marker.findPoseInGround(state).p(), marker.findVelocityInGround(state));
    };
    const auto [p1, V1] = findAt(Step);
    const auto [p0, V0] = findAt(-Step);
    const SpatialVec V = marker.findVelocityInGround(start), A = marker.findAccelerationInGround(start);
    EXPECT_LT(((p1 - p0) / (2 * Step) - V[1]).norm(), Tolerance * V[1].norm());
    EXPECT_LT(((V1 - V0) / (2 * Step) - A).norm(), Tolerance * A.norm());
}

//---------------------------------------------------------------------------------------- refusals
TEST(FlexibleBody, RefusesWhatCannotMove) {
    const auto make = [](const ModalBasis& basis, const std::vector<Real>& damping) {
        return testing::catchError([&] {
            FlexibleSystem s;
            FlexibleBody(s.matter, s.forces, basis, {InertiaCoupling::Partial, damping});
        });
    };
    EXPECT_EQ(make(getBasis(), {0.1, 0.2}), "beam: 2 damping ratios for 7 modes");
    EXPECT_EQ(make(getBasis(), std::vector<Real>(7, -1.)), "beam: a damping ratio is -1");
    ModalBasis none = getBasis();
    none.frequencies.clear();
    EXPECT_EQ(make(none, {}), "beam: has no modes; use a rigid body");
    ModalBasis light = getBasis();
    light.rigid.mass = 0;
    EXPECT_EQ(make(light, {}).substr(0, 35), "beam: has mass 0 and moments of ine");
    EXPECT_EQ(make(getBasis(), std::vector<Real>(7, SimTK::Infinity)), "beam: a damping ratio is inf");
    ModalBasis unfinished = getBasis();
    unfinished.frequencies[2] = SimTK::NaN;
    EXPECT_EQ(make(unfinished, {}), "beam: the frequency of mode 3 is nan; it must be positive and finite");
    unfinished = getBasis();
    unfinished.rigid.center[1] = SimTK::NaN;
    EXPECT_EQ(make(unfinished, {}), "beam: its mass, mass centre or inertia is not finite");
    FlexibleSystem s, elsewhere;
    EXPECT_EQ(testing::catchError([&] { FlexibleBody(s.matter, elsewhere.forces, getBasis()); }),
              "beam: its matter and its forces belong to different systems");
    const FlexibleBody body(s.matter, s.forces, getBasis());
    EXPECT_EQ(testing::catchError([&] { Marker(body, 99); }), "beam: has no node 99");
    State state = s.system.realizeTopology();
    EXPECT_EQ(testing::catchError([&] { body.setModalCoordinates(state, Vector(3, 0.)); }),
              "beam: 3 values for 7 modal coordinates");
    EXPECT_EQ(testing::catchError([&] { body.setModalVelocities(state, Vector(7, SimTK::NaN)); }),
              "beam: a value for a modal coordinate is not finite");
}

}  // namespace
}  // namespace jprim
