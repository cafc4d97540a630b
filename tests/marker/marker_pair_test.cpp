// SPDX-License-Identifier: Apache-2.0
// What MarkerPair promises by itself; its derivatives are tested with the primitives that use them.
#include "jprim/marker/marker_pair.h"

#include <gtest/gtest.h>

#include "jprim/marker/marker.h"
#include "support/conformance.h"

namespace jprim {
namespace {

using SimTK::Random;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::Transform;
using SimTK::Vec3;

constexpr double Rounding = 1e-13;

struct RandomMotion {
    explicit RandomMotion(Random& random)
        : X(testing::makeRandomRotation(random), testing::makeRandomVec3(random)),
          V(testing::makeRandomVec3(random), testing::makeRandomVec3(random)),
          A(testing::makeRandomVec3(random), testing::makeRandomVec3(random)) {}

    Transform X;
    SpatialVec V, A;
};

// The same motion seen from a frame in which A itself moves: X_GA with velocity V_GA and acceleration A_GA.
RandomMotion compose(const RandomMotion& frame, const RandomMotion& inFrame) {
    RandomMotion result = inFrame;
    const Rotation& R = frame.X.R();
    const Vec3 w = frame.V[0], b = frame.A[0];
    const Vec3 p = R * inFrame.X.p(), v = R * inFrame.V[1], wRel = R * inFrame.V[0];
    result.X = frame.X * inFrame.X;
    result.V = SpatialVec(w + wRel, frame.V[1] + w % p + v);
    result.A = SpatialVec(b + w % wRel + R * inFrame.A[0],
                          frame.A[1] + b % p + w % (w % p) + 2. * (w % v) + R * inFrame.A[1]);
    return result;
}

// Nothing that J sees changes when everything is carried along by a moving frame.
TEST(MarkerPair, DoesNotSeeTheFrameItIsMeasuredIn) {
    Random::Uniform random(-1, 1);
    random.setSeed(5);
    for (int n = 0; n < 20; ++n) {
        const RandomMotion I(random), J(random), frame(random);
        const RandomMotion movedI = compose(frame, I), movedJ = compose(frame, J);
        const MarkerPair pair(I.X, J.X), moved(movedI.X, movedJ.X);
        EXPECT_LT((pair.getPosition() - moved.getPosition()).norm(), Rounding);
        EXPECT_LT((pair.getRotation().asMat33() - moved.getRotation().asMat33()).norm(), Rounding);
        EXPECT_LT((pair.calcVelocity(I.V, J.V) - moved.calcVelocity(movedI.V, movedJ.V)).norm(), Rounding);
        EXPECT_LT((pair.calcAcceleration(I.V, J.V, I.A, J.A) -
                   moved.calcAcceleration(movedI.V, movedJ.V, movedI.A, movedJ.A))
                      .norm(),
                  10 * Rounding);
    }
}

// Two random motions and a load between them.
struct RandomPair {
    explicit RandomPair(Random& random)
        : I(random), J(random), load(testing::makeRandomVec3(random), testing::makeRandomVec3(random)) {}

    RandomMotion I, J;
    SpatialVec load;
    MarkerPair pair{I.X, J.X};
};

// Equal and opposite as a wrench about any point.
TEST(MarkerPair, LoadsCancel) {
    Random::Uniform random(-1, 1);
    random.setSeed(6);
    const RandomPair r(random);
    const Vec3 point(3, -4, 5);
    const SpatialVec sum = SimTK::shiftForceBy(r.pair.calcLoadOnI(r.load), point - r.I.X.p()) +
                           SimTK::shiftForceBy(r.pair.calcLoadOnJ(r.load), point - r.J.X.p());
    EXPECT_LT(sum.norm(), Rounding);
}

// Power of a load is the load times the relative velocity, in J: force and motion are dual.
TEST(MarkerPair, PowerIsThatOfTheRelativeMotion) {
    Random::Uniform random(-1, 1);
    random.setSeed(7);
    const RandomPair r(random);
    const auto power = [](const SpatialVec& F, const SpatialVec& V) {
        return SimTK::dot(F[0], V[0]) + SimTK::dot(F[1], V[1]);
    };
    EXPECT_NEAR(power(r.pair.calcLoadOnI(r.load), r.I.V) + power(r.pair.calcLoadOnJ(r.load), r.J.V),
                power(r.load, r.pair.calcVelocity(r.I.V, r.J.V)), Rounding);
}

TEST(Marker, MovesWithItsBody) {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter(system);
    const SimTK::Body::Rigid rigid(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(1)));
    SimTK::MobilizedBody::Pin arm(matter.Ground(), rigid);
    const Marker tip(arm, Transform(Rotation(0.3, SimTK::XAxis), Vec3(2, 0, 0)));
    SimTK::State state = system.realizeTopology();
    arm.setRate(state, 3);
    system.realize(state, SimTK::Stage::Acceleration);
    EXPECT_LT((tip.findPoseInGround(state).p() - Vec3(2, 0, 0)).norm(), Rounding);
    EXPECT_LT((tip.findVelocityInGround(state) - SpatialVec(Vec3(0, 0, 3), Vec3(0, 6, 0))).norm(), Rounding);
    EXPECT_LT((tip.findAccelerationInGround(state) - SpatialVec(Vec3(0), Vec3(-18, 0, 0))).norm(), Rounding);
    EXPECT_TRUE(tip.isOnBody());
    EXPECT_FALSE(Marker().isOnBody());
}

}  // namespace
}  // namespace jprim
