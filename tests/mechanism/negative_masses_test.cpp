// SPDX-License-Identifier: Apache-2.0
// Inertia that no body has, at the level of Simbody: what is added and taken away again leaves no trace, and what is
// left is the inertia asked for.
#include "mechanism/negative_masses.h"

#include <gtest/gtest.h>

#include "support/random_part.h"

namespace jprim {
namespace {

using SimTK::Mat33;
using SimTK::MobilizedBody;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Transform;
using SimTK::Vec3;
using SimTK::Vector;
using testing::makeInertia;
using testing::RandomPart;

// Of sums that are rounded, relative to the largest term.
constexpr Real Rounding = 1e-12;

/// Three bodies in a row, of which the middle one has masses taken away, or not.
struct Chain {
    Chain(unsigned seed, Real added, bool isTaken = true) {
        RandomPart random(seed);
        SimTK::Force::Gravity(forces, matter, 9 * random.drawVec3());
        MobilizedBody parent = matter.Ground();
        for (int k = 0; k < 3; ++k) {
            const Real mass = random.draw(0.1, 3), a = random.draw(0, 1), b = random.draw(0, 1),
                       c = random.draw(0, 1);
            const Mat33 inertia = makeInertia({a + b, b + c, c + a}, random.drawRotation());
            const NegativeMasses negative = makeNegativeMasses(mass, k == 1 ? added : 0);
            const SimTK::Body::Rigid body(makeMassProperties(mass, inertia, negative));
            const Transform X_PF = random.drawTransform(), X_BM = random.drawTransform();
            if (k == 1)
                parent = MobilizedBody::Universal(parent, X_PF, body, X_BM);
            else
                parent = MobilizedBody::Ball(parent, X_PF, body, X_BM);
            if (isTaken) weldNegativeMasses(parent, negative);
            bodies.push_back(parent);
        }
        state = system.realizeTopology();
        system.realizeModel(state);
        for (Real& q : state.updQ()) q += random.draw(-1, 1);
        for (Real& u : state.updU()) u = random.draw(-3, 3);
        system.realize(state, SimTK::Stage::Acceleration);
    }

    /// Everything that may be seen, one below the other.
    Vector observe() const {
        SimTK::Matrix M;
        matter.calcM(state, M);
        std::vector<Real> seen(&M(0, 0), &M(0, 0) + M.nelt());
        for (int i = 0; i < state.getNU(); ++i) seen.push_back(state.getUDot()[i]);
        const SpatialVec momentum = matter.calcSystemMomentumAboutGroundOrigin(state);
        std::vector<SpatialVec> loads = {momentum};
        for (const MobilizedBody& body : bodies)
            loads.push_back(body.findMobilizerReactionOnBodyAtMInGround(state));
        for (const SpatialVec& load : loads)
            for (int k = 0; k < 6; ++k) seen.push_back(load[k / 3][k % 3]);
        seen.push_back(system.calcKineticEnergy(state));
        seen.push_back(matter.calcSystemMass(state));
        return Vector(int(seen.size()), seen.data());
    }

    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    std::vector<MobilizedBody> bodies;
    SimTK::State state;
};

Real compareChains(unsigned seed, Real added, bool isTaken) {
    const Vector with = Chain(seed, added, isTaken).observe(), without = Chain(seed, 0).observe();
    return Vector(with - without).normInf() / (1 + without.normInf());
}

TEST(NegativeMasses, LeaveNoTraceOfWhatTheyTakeBack) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        const Real added = std::pow(10, Real(seed % 7) - 4);
        EXPECT_LT(compareChains(seed, added, true), Rounding * (1 + added)) << seed;
    }
}

TEST(NegativeMassesMutant, WhatIsNotTakenBackIsNoticed) {
    EXPECT_GT(compareChains(1, 1e-4, false), 1e3 * Rounding);
}

// Nothing is added to a body, thin as a rod or a sheet.
TEST(NegativeMasses, BodiesNeedNone) {
    RandomPart random(1);
    for (const Vec3& moments : {Vec3(1, 1, 1), Vec3(1e-9, 1, 1), Vec3(1, 2, 3), Vec3(4e-11, 4e-11, 4e-11)})
        EXPECT_EQ(findMissingInertia(makeInertia(moments, random.drawRotation())), 0) << moments;
}

// Simbody looks at them in any orientation and of any size, and finds nothing to complain of.
TEST(NegativeMasses, MakeAnythingAcceptable) {
    RandomPart random(2);
    for (int k = 0; k < 200; ++k) {
        const Real size = random.drawOverDecades(1e-9, 1e9);
        const Mat33 inertia = makeInertia(size * random.drawVec3(), random.drawRotation());
        const Real added = findMissingInertia(inertia);
        const NegativeMasses negative = makeNegativeMasses(1, added);
        for (int turn = 0; turn < 20; ++turn)
            EXPECT_NO_THROW(
                makeMassProperties(1, inertia, negative).getUnitInertia().reexpress(random.drawRotation()))
                << inertia;
        EXPECT_NEAR(8 * negative.each * SimTK::square(negative.coordinate), added, Rounding * added);
    }
}

TEST(NegativeMasses, WithoutThemSimbodyRefuses) {
    const Mat33 inertia(1, 0, 0, 0, 1, 0, 0, 0, 2.1);
    EXPECT_GT(findMissingInertia(inertia), 0.1);
    EXPECT_THROW(makeMassProperties(1, inertia, {}), std::exception);
}

}  // namespace
}  // namespace jprim
