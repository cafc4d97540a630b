// SPDX-License-Identifier: Apache-2.0
// What a primitive offers besides its equations: reactions, markers in the State, names, geometry, errors.
#include <gtest/gtest.h>

#include "jprim/base/error.h"
#include "jprim/primitive/primitives.h"
#include "support/conformance.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::Constraint;
using SimTK::MobilizedBody;
using SimTK::Random;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

// Sums of a few dozen products of numbers of order ten.
constexpr double Rounding = 1e-11;

// Two free bodies under gravity, moving, with one primitive of each kind between them: a state that violates
// everything, where each primitive has its own load.
struct Violated {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    SimTK::Force::Gravity gravity{forces, matter, SimTK::UnitVec3(0.2, -1, 0.1), 9.81};
    Body::Rigid body{SimTK::MassProperties(2, Vec3(0.1, 0, -0.2), SimTK::Inertia(1, 2, 1.5))};
    MobilizedBody::Free base{matter.Ground(), body};
    MobilizedBody::Free first{base, body};
    MobilizedBody::Free second{base, body};
    Marker I{first, Transform(Rotation(0.3, Vec3(1, 2, 3)), Vec3(0.1, 0.2, 0.3))};
    Marker J{second, Transform(Rotation(0.8, Vec3(-1, 0, 2)), Vec3(0.5, 0, -0.3))};
    Marker other{base, Transform(Rotation(-0.9, Vec3(0, 1, 2)), Vec3(1, 1, 1))};
    State state;

    void start(int seed) {
        state = system.realizeTopology();
        Random::Uniform random(-1, 1);
        random.setSeed(seed);
        for (MobilizedBody* b : std::initializer_list<MobilizedBody*>{&base, &first, &second})
            b->setQToFitTransform(
                state, Transform(testing::makeRandomRotation(random), testing::makeRandomVec3(random)));
        for (int u = 0; u < state.getNU(); ++u) state.updU()[u] = random.getValue();
        system.realize(state, Stage::Acceleration);
    }

    // A load at one marker, moved to the origin of a body.
    static SpatialVec moveTo(const Vec3& to, const SpatialVec& load, const Vec3& from) {
        return SimTK::shiftForceBy(load, to - from);
    }
};

template <class Type>
class EachPrimitive : public ::testing::Test {};
using AllSix = ::testing::Types<AtPoint, InLine, InPlane, Orientation, ParallelAxes, Perpendicular>;
TYPED_TEST_SUITE(EachPrimitive, AllSix);

// The reactions of our accessors against what Simbody itself makes of the multipliers.
TYPED_TEST(EachPrimitive, ReactionsAgreeWithSimbodysBodyForces) {
    Violated model;
    const TypeParam primitive(model.I, model.J);
    model.start(7);
    const State& state = model.state;

    SimTK::Vector_<SpatialVec> bodyForces;
    SimTK::Vector mobilityForces;
    primitive.calcConstraintForcesFromMultipliers(state, primitive.getMultipliersAsVector(state), bodyForces,
                                                  mobilityForces);
    const Rotation R_GA = model.base.getBodyRotation(state);
    const Vec3 p_GI = model.I.findPoseInGround(state).p(), p_GJ = model.J.findPoseInGround(state).p();
    const SpatialVec onI = -(R_GA * bodyForces[0]), onJ = -(R_GA * bodyForces[1]);
    const SpatialVec expectedI = Violated::moveTo(p_GI, onI, model.first.getBodyOriginLocation(state));
    const SpatialVec expectedJ = Violated::moveTo(p_GJ, onJ, model.second.getBodyOriginLocation(state));

    EXPECT_GT(primitive.calcReactionOnI(state).norm(), 0.01) << "nothing to compare";
    EXPECT_LT((primitive.calcReactionOnI(state) - expectedI).norm(), Rounding);
    EXPECT_LT((primitive.calcReactionOnJ(state) - expectedJ).norm(), Rounding);
}

// M_J = -M_I - r x F_I, and the same wrench at I's origin.
TYPED_TEST(EachPrimitive, ReactionOnJCarriesTheLever) {
    Violated model;
    const TypeParam primitive(model.I, model.J);
    model.start(8);
    const SpatialVec onI = primitive.calcReactionOnI(model.state),
                     onJ = primitive.calcReactionOnJ(model.state);
    const Vec3 r = model.I.findPoseInGround(model.state).p() - model.J.findPoseInGround(model.state).p();
    EXPECT_LT((onJ[1] + onI[1]).norm(), Rounding);
    EXPECT_LT((onJ[0] + onI[0] + r % onI[1]).norm(), Rounding);
    EXPECT_LT((primitive.calcReactionOnJAtI(model.state) + onI).norm(), Rounding);
}

TYPED_TEST(EachPrimitive, ReactionsInTheAxesOfAnyMarker) {
    Violated model;
    const TypeParam primitive(model.I, model.J);
    model.start(9);
    const Rotation R = model.other.findPoseInGround(model.state).R();
    EXPECT_LT(
        (R * primitive.calcReactionOnI(model.state, model.other) - primitive.calcReactionOnI(model.state))
            .norm(),
        Rounding);
    EXPECT_LT(
        (R * primitive.calcReactionOnJ(model.state, model.other) - primitive.calcReactionOnJ(model.state))
            .norm(),
        Rounding);
    EXPECT_LT((R * primitive.calcReactionOnJAtI(model.state, model.other) -
               primitive.calcReactionOnJAtI(model.state))
                  .norm(),
              Rounding);
}

TYPED_TEST(EachPrimitive, AdamsFunctionPicksTheComponent) {
    Violated model;
    const TypeParam primitive(model.I, model.J);
    model.start(10);
    const SpatialVec onI = primitive.calcReactionOnI(model.state);
    const SpatialVec onJ = primitive.calcReactionOnJ(model.state, model.other);
    EXPECT_DOUBLE_EQ(primitive.JPRIM(model.state, 0, 1), onI[1].norm());
    EXPECT_DOUBLE_EQ(primitive.JPRIM(model.state, 0, 3), onI[1][1]);
    EXPECT_DOUBLE_EQ(primitive.JPRIM(model.state, 1, 5, model.other), onJ[0].norm());
    EXPECT_DOUBLE_EQ(primitive.JPRIM(model.state, 1, 6, model.other), onJ[0][0]);
    EXPECT_DOUBLE_EQ(primitive.JPRIM(model.state, 1, 8, model.other), onJ[0][2]);
}

TYPED_TEST(EachPrimitive, DisabledCarriesNothing) {
    Violated model;
    const TypeParam primitive(model.I, model.J);
    model.start(11);
    primitive.disable(model.state);
    model.system.realize(model.state, Stage::Acceleration);
    EXPECT_EQ(primitive.calcReactionOnI(model.state).norm(), 0);
    EXPECT_EQ(primitive.calcReactionOnJ(model.state).norm(), 0);
    EXPECT_EQ(model.state.getNMultipliers(), 0);
    primitive.enable(model.state);
    model.system.realize(model.state, Stage::Acceleration);
    EXPECT_GT(primitive.calcReactionOnI(model.state).norm(), 0.01);
}

// A marker moved in a State gives the same errors and loads as one built there, without a new topology.
TYPED_TEST(EachPrimitive, MarkersCanBeMovedInAState) {
    const Transform X_BI(Rotation(1.1, Vec3(3, 1, -2)), Vec3(-0.3, 0.1, 0.6));
    const Transform X_BJ(Rotation(0.4, Vec3(1, 1, 0)), Vec3(0.2, -0.7, 0.1));
    Violated moved, built;
    const TypeParam movedPrimitive(moved.I, moved.J);
    const TypeParam builtPrimitive(Marker(built.first, X_BI), Marker(built.second, X_BJ));
    moved.start(12);
    built.start(12);
    movedPrimitive.setMarkerI(moved.state, X_BI);
    movedPrimitive.setMarkerJ(moved.state, X_BJ);
    EXPECT_LT(moved.state.getSystemStage(), Stage::Position);
    moved.system.realize(moved.state, Stage::Acceleration);

    EXPECT_EQ((moved.state.getQErr() - built.state.getQErr()).norm(), 0);
    EXPECT_EQ((moved.state.getUErr() - built.state.getUErr()).norm(), 0);
    EXPECT_LT(
        (movedPrimitive.calcReactionOnJ(moved.state) - builtPrimitive.calcReactionOnJ(built.state)).norm(),
        Rounding);
    EXPECT_EQ(movedPrimitive.getMarkerI(moved.state).getPose().p(), X_BI.p());
    EXPECT_EQ(movedPrimitive.getDefaultMarkerI().getPose().p(), moved.I.getPose().p());
}

TYPED_TEST(EachPrimitive, ChangingADefaultMarkerNeedsANewTopology) {
    Violated model;
    TypeParam primitive(model.I, model.J);
    model.start(13);
    primitive.setDefaultMarkerJ(Transform(Vec3(1, 2, 3)));
    EXPECT_FALSE(model.system.systemTopologyHasBeenRealized());
    model.start(13);
    EXPECT_EQ(primitive.getMarkerJ(model.state).getPose().p(), Vec3(1, 2, 3));
}

TYPED_TEST(EachPrimitive, DrawsItself) {
    Violated model;
    const TypeParam primitive(model.I, model.J);
    model.start(14);
    SimTK::Array_<SimTK::DecorativeGeometry> geometry;
    model.system.calcDecorativeGeometryAndAppend(model.state, Stage::Position, geometry);
    const int equations = primitive.getMultipliersAsVector(model.state).size();
    EXPECT_EQ(int(geometry.size()), 2 + equations);  // two triads, one line an equation
}

// Handles carry no data: a copy as plain SimTK::Constraint and back loses nothing.
TYPED_TEST(EachPrimitive, HandlesAreCheap) {
    static_assert(sizeof(TypeParam) == sizeof(Constraint));
    Violated model;
    TypeParam primitive(model.I, model.J, "JPRIM/12");
    const Primitive copy = primitive;
    primitive.setName("JPRIM/13");
    EXPECT_EQ(copy.getName(), "JPRIM/13");
    EXPECT_STREQ(copy.getAdamsType(), primitive.getAdamsType());
}

//----------------------------------------------------------------------------------------- errors
template <class Action>
void expectError(Action action, const std::string& text) {
    EXPECT_EQ(testing::catchError(action), text);
}

TYPED_TEST(EachPrimitive, RefusesMarkersWithoutBody) {
    Violated model;
    expectError([&] { TypeParam(Marker(), model.J, "JPRIM/7"); },
                "JPRIM/7 " + std::string(TypeParam(model.I, model.J).getAdamsType()) +
                    ": marker I is not on a body; construct it with a MobilizedBody that has been added to a "
                    "matter subsystem");
}

TEST(PrimitiveErrors, NameTheElementAndTheRemedy) {
    Violated model, elsewhere;
    expectError([&] { InLine(model.I, Marker(), "JPRIM/7"); },
                "JPRIM/7 INLINE: marker J is not on a body; construct it with a MobilizedBody that has been "
                "added to a matter subsystem");
    expectError([&] { AtPoint(model.I, Marker(model.first), "JPRIM/8"); },
                "JPRIM/8 ATPOINT: markers I and J are both on body 2; it acts between two different "
                "bodies");
    expectError([&] { Perpendicular(model.I, elsewhere.J); },
                "PERPENDICULAR: markers I and J belong to different systems; put both bodies into one");
}

TEST(PrimitiveErrors, AdamsFunctionChecksItsArguments) {
    Violated model;
    const InPlane primitive(model.I, model.J, "JPRIM/9");
    model.start(3);
    expectError([&] { primitive.JPRIM(model.state, 2, 1); },
                "JPRIM/9 INPLANE: jflag 2 does not exist; use 0 for the load on I, 1 for the load on J");
    expectError(
        [&] { primitive.JPRIM(model.state, 0, 9); },
        "JPRIM/9 INPLANE: component 9 of a reaction does not exist; use 1 to 8 for FM FX FY FZ TM TX TY "
        "TZ");
}

// A refused primitive leaves nothing behind in the system.
TEST(PrimitiveErrors, NothingIsAddedToTheSystem) {
    Violated model;
    EXPECT_THROW(AtPoint(model.I, Marker(model.first)), Error);
    EXPECT_EQ(model.matter.getNumConstraints(), 0);
    model.start(1);
}

TEST(Primitive, GroundMayBeOnEitherSide) {
    Violated model;
    const InLine onI(Marker(model.matter.Ground(), Transform(Vec3(1, 0, 0))), model.J);
    const InLine onJ(model.I, Marker(model.matter.Ground()));
    model.start(4);
    EXPECT_GT(onI.calcReactionOnI(model.state).norm(), 0.01);
    EXPECT_GT(onJ.calcReactionOnJ(model.state).norm(), 0.01);
}

}  // namespace
}  // namespace jprim
