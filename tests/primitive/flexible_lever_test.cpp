// SPDX-License-Identifier: Apache-2.0
// The load of a primitive enters a flexible J at J's attachment, with the offset r from J to I as a rigid
// lever: M_J = -M_I - r x F_I.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "jprim/jprim.h"
#include "support/linearize.h"
#include "support/marker_load.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using namespace testing;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

constexpr int Elements = 6;

// Soft enough that a second shows the beam swing, with modes up to some 100 Hz.
const ModalBasis& getBasis() {
    static const ModalBasis basis = [] {
        UniformBeam beam = makeSteelBeam(Elements);
        beam.youngsModulus /= 1000;
        beam.shearModulus /= 1000;
        return reduceToModes(makeFiniteElementModel(beam), {{{1}, 0, {}}, {{Elements + 1}, 0, {}}}, 4);
    }();
    return basis;
}

std::vector<double> makeUndamped() {
    return std::vector<double>(size_t(getBasis().getNumModes()), 0.);
}

/// A free beam without gravity and a body that a primitive holds to J at the beam's tip, where z_J points
/// away from the beam and the body is 0.4 m off.
struct TipAndBody : FlexibleSystem {
    TipAndBody()
        : beam(matter, forces, getBasis(), {InertiaCoupling::Constant, makeUndamped()}),
          body(matter.Ground(), SimTK::Body::Rigid(SimTK::MassProperties(1.3, Vec3(0.02, -0.03, 0.01),
                                                                         SimTK::Inertia(0.04, 0.05, 0.03)))),
          I(body, Transform(Rotation(0.3, SimTK::XAxis), Vec3(0.02, 0.01, -0.03))),
          J(beam, Elements + 1, Transform(Rotation(SimTK::Pi / 2.5, SimTK::YAxis), Vec3(0.05, 0.02, 0))) {}

    // I at p_JI in J, the two bodies thrown and turned against each other.
    void start(State& state, const Vec3& p_JI = Vec3(0, 0, 0.4)) const {
        system.realize(state, SimTK::Stage::Position);
        const Transform X_GJ = J.findPoseInGround(state);
        const Transform X_GI(X_GJ.R(), X_GJ * p_JI);
        body.setQToFitTransform(state, X_GI * ~I.getPose());
        beam.getBody().setU(state, SimTK::Vec6(0.2, -0.5, 0.9, 0, 0.1, -0.1));
        body.setU(state, SimTK::Vec6(0.4, 0.6, -0.3, 0.5, -0.2, 0.3));
        system.realize(state, SimTK::Stage::Velocity);
        system.project(state, 1e-12);
        system.realize(state, SimTK::Stage::Acceleration);
    }

    FlexibleBody beam;
    SimTK::MobilizedBody::Free body;
    Marker I, J;
};

//------------------------------------------------------------------------------------ conservation
// Between two free bodies an INLINE keeps energy, momentum and angular momentum while I slides along z_J. With
// Constant coupling that is exact; what is left is the integrator's error.
TEST(SlidingInLine, KeepsEnergyAndMomentum) {
    constexpr Real Accuracy = 1e-9, Tolerance = 1e-7;
    TipAndBody s;
    const InLine guide(s.I, s.J);
    State state = s.system.realizeTopology();
    s.start(state);
    const Real energy = s.system.calcEnergy(state);
    const SpatialVec momentum = s.matter.calcSystemMomentumAboutGroundOrigin(state);
    const auto getPlace = [&](const State& now) {
        return (~s.J.findPoseInGround(now) * s.I.findPoseInGround(now).p())[2];
    };
    const Real place = getPlace(state);
    Real elastic = 0;
    const State end = integrate(s, state, 1, Accuracy, [&](const State& now) {
        elastic = std::max(elastic, s.beam.calcElasticEnergy(now));
        EXPECT_NEAR(s.system.calcEnergy(now), energy, Tolerance * energy);
    });
    const SpatialVec after = s.matter.calcSystemMomentumAboutGroundOrigin(end);
    EXPECT_LT((after - momentum).norm(), Tolerance * momentum.norm());
    EXPECT_GT(elastic, 1e-3 * energy);                 // the beam did swing
    EXPECT_GT(std::abs(getPlace(end) - place), 0.05);  // and the body slide
}

// The modes answer to the primitive as to its reaction on J, [M_J, F_J], put on the beam at J by hand.
TEST(SlidingInLine, LoadsTheModesThroughTheLever) {
    constexpr Real Tolerance = 1e-9;
    TipAndBody s;
    const InLine guide(s.I, s.J);
    State state = s.system.realizeTopology();
    s.start(state);
    const SpatialVec onJ = guide.calcReactionOnJ(state), onI = guide.calcReactionOnI(state);
    const Vec3 r = s.I.findPoseInGround(state).p() - s.J.findPoseInGround(state).p();
    EXPECT_LT((onJ[0] + onI[0] + r % onI[1]).norm(), Tolerance * onJ[0].norm());
    EXPECT_GT(onJ[0].norm(), 0.3 * onJ[1].norm());

    const auto calcModalAccelerations = [&](const SpatialVec& load) {
        TipAndBody other;
        SimTK::Force::Custom(other.forces, new MarkerLoad(other.J, load));
        State free = other.system.realizeTopology();
        free.updQ() = state.getQ();
        free.updU() = state.getU();
        other.system.realize(free, SimTK::Stage::Acceleration);
        return other.beam.getModalAccelerations(free);
    };
    const SimTK::Vector expected = s.beam.getModalAccelerations(state);
    EXPECT_LT((calcModalAccelerations(onJ) - expected).norm(), Tolerance * expected.norm());
    EXPECT_GT((calcModalAccelerations(SpatialVec(Vec3(0), onJ[1])) - expected).norm(), 0.1 * expected.norm());
}

//--------------------------------------------------------------------------------------- identity 5
/// Where I is after half a second, and the load that then enters the beam at J.
struct Outcome {
    Vec3 place;
    SpatialVec onJ;
};

constexpr Real Duration = 0.2, Accuracy = 1e-11;

template <class Type>
Outcome runDirect(const Vec3& p_JI) {
    TipAndBody s;
    const Type primitive(s.I, s.J);
    State state = s.system.realizeTopology();
    s.start(state, p_JI);
    const State end = integrate(s, state, Duration, Accuracy, [](const State&) {});
    return {s.I.findPoseInGround(end).p(), primitive.calcReactionOnJ(end)};
}

// The state in which runDirect() starts, with the rod moving as J does. The rod's coordinates are the last.
template <class Type>
void startWithRod(const TipAndBody& s, const SimTK::MobilizedBody::Free& rod, const Vec3& p_JI,
                  State& state) {
    TipAndBody direct;
    const Type primitive(direct.I, direct.J);
    State first = direct.system.realizeTopology();
    direct.start(first, p_JI);
    state.updQ()(0, first.getNQ()) = first.getQ();
    state.updU()(0, first.getNU()) = first.getU();
    s.system.realize(state, SimTK::Stage::Velocity);
    rod.setQToFitTransform(state, s.J.findPoseInGround(state));
    s.system.realize(state, SimTK::Stage::Velocity);
    rod.setUToFitVelocity(state, s.J.findVelocityInGround(state));
}

// The same primitive on a rod of little mass, welded to the beam at J.
template <class Type>
Outcome runOnRod(Real mass, const Vec3& p_JI) {
    TipAndBody s;
    const SimTK::Body::Rigid light(
        SimTK::MassProperties(mass, Vec3(0, 0, 0.2), mass * SimTK::Inertia(0.06, 0.06, 0.03)));
    const SimTK::MobilizedBody::Free rod(s.matter.Ground(), light);
    const Joint weld = Joint::Fixed(Marker(rod), s.J);
    const Type primitive(s.I, Marker(rod));
    State state = s.system.realizeTopology();
    startWithRod<Type>(s, rod, p_JI, state);
    const State end = integrate(s, state, Duration, Accuracy, [](const State&) {});
    return {s.I.findPoseInGround(end).p(), weld.calcReactionOnJ(end)};
}

// The differences shrink with the rod's mass, by a hundred each time, to below the tolerances.
template <class Type>
void expectRodConverges(const Vec3& p_JI) {
    constexpr Real MotionTolerance = 1e-6, ReactionTolerance = 1e-5;
    const Outcome direct = runDirect<Type>(p_JI);
    Real previous = SimTK::Infinity, motion = 0, reaction = 0;
    for (const Real mass : {1e-4, 1e-6, 1e-8}) {
        const Outcome rod = runOnRod<Type>(mass, p_JI);
        motion = (rod.place - direct.place).norm() / direct.place.norm();
        reaction = (rod.onJ - direct.onJ).norm() / direct.onJ.norm();
        std::printf("rod of %.0e kg: motion %.1e, reaction %.1e\n", mass, motion, reaction);
        EXPECT_LT(motion, previous / 50) << mass;
        previous = motion;
    }
    EXPECT_LT(motion, MotionTolerance);
    EXPECT_LT(reaction, ReactionTolerance);
}

TEST(RigidLever, InLineEqualsARodWeldedToJ) {
    expectRodConverges<InLine>(Vec3(0, 0, 0.4));
}

TEST(RigidLever, InPlaneEqualsARodWeldedToJ) {
    expectRodConverges<InPlane>(Vec3(0.3, -0.25, 0));
}

}  // namespace
}  // namespace jprim
