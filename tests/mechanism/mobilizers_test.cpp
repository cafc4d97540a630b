// SPDX-License-Identifier: Apache-2.0
// Mobilizers in the place of joints: they start where the dataset has the parts, and their coordinates are those
// of I relative to J, whichever of the two is on the part that moves.
#include <gtest/gtest.h>

#include "base/format.h"
#include "jprim/marker/angles.h"
#include "jprim/marker/marker_pair.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::Transform;
using SimTK::Vec3;

constexpr double Rounding = 1e-13;  // of a few rotations of numbers of order 1

const Vec3 None(0);
const Rotation AboutZ(0.7, SimTK::ZAxis);

struct Case {
    const char* statement;
    Transform X_JI;                  // a place that the joint allows
    std::vector<SpatialVec> speeds;  // what each coordinate's speed of 1 is: [w, v] of I in J
};

// Shafts at an angle, with z_I across z_J; and with x_I across y_J.
const Rotation Crossed = Rotation(0.4, SimTK::ZAxis) * Rotation(SimTK::Pi / 2, SimTK::XAxis) * AboutZ;
const Rotation Bars = Rotation(0.4, SimTK::YAxis) * Rotation(-0.6, SimTK::XAxis);
const Rotation Any(SimTK::BodyRotationSequence, 0.3, SimTK::XAxis, -0.5, SimTK::YAxis, 1.1, SimTK::ZAxis);

const Vec3 X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);
const Case Cases[] = {{"REVOLUTE", AboutZ, {{Z, None}}},
                      {"TRANSLATIONAL", Vec3(0, 0, 0.8), {{None, Z}}},
                      {"CYLINDRICAL", Transform(AboutZ, Vec3(0, 0, -0.3)), {{Z, None}, {None, Z}}},
                      {"PLANAR", Transform(AboutZ, Vec3(0.2, -0.9, 0)), {{Z, None}, {None, X}, {None, Y}}},
                      {"SPHERICAL", Any, {{X, None}, {Y, None}, {Z, None}}},
                      {"UNIVERSAL", Crossed, {{Z, None}, {Vec3(Crossed.z()), None}}},
                      {"HOOKE", Bars, {{Y, None}, {Vec3(Bars.x()), None}}},
                      {"FIXED", Transform(), {}},
                      {"ORIENTATION", Vec3(0.3, 0.2, 0.1), {{None, X}, {None, Y}, {None, Z}}}};

std::string format(const Transform& X) {
    const Vec3 angles = calcAngles313(X.R());
    return fmt::format("{},{},{},REULER={},{},{}", X.p()[0], X.p()[1], X.p()[2], angles[0], angles[1],
                       angles[2]);
}

class Mobilizers : public ::testing::TestWithParam<std::tuple<Case, bool>> {
protected:
    // The part lies so that the joint fits; J is on ground, or with `reversed` I.
    static Mechanism build(const Case& c, bool reversed) {
        const Transform onGround(~Any * AboutZ, Vec3(1, 2, 3)), onPart(Any * Bars, Vec3(-0.2, 0.3, 0.5));
        const Transform X_GP = onGround * (reversed ? ~c.X_JI : c.X_JI) * ~onPart;
        const bool isJprim = std::string(c.statement) == "ORIENTATION";
        return testing::buildOrFail(
            fmt::format("t\nPART/1,GROUND\nMARKER/10,QP={}\nPART/2,MASS=2,CM=20,IP=2,3,4,QG={}\n"
                        "MARKER/20,QP=0.4,0.1,-0.2\nMARKER/21,QP={}\n{}/1,{},I={},J={}\nEND\n",
                        format(onGround), format(X_GP), format(onPart), isJprim ? "JPRIM" : "JOINT",
                        c.statement, reversed ? 10 : 21, reversed ? 21 : 10),
            {Formulation::Tree});
    }
};

TEST_P(Mobilizers, StartWhereThePartIs) {
    const auto& [c, reversed] = GetParam();
    const Mechanism mechanism = build(c, reversed);
    const MechanismPart& part = mechanism.getParts()[1];
    EXPECT_EQ(part.attachment.elements.size(), 1u);
    EXPECT_EQ(part.attachment.reversed, reversed);
    const SimTK::State state = mechanism.makeGivenState();
    mechanism.getSystem().realize(state, SimTK::Stage::Position);
    const Transform miss = ~part.calcGivenBodyPose() * part.body.getBodyTransform(state);
    EXPECT_LT(miss.p().norm(), Rounding);
    EXPECT_LT((Rotation().asMat33() - miss.R().asMat33()).norm(), Rounding);
    EXPECT_EQ(state.getNQErr(), std::string(c.statement) == "SPHERICAL" ? 1 : 0);  // of the quaternion
}

TEST_P(Mobilizers, SpeedsAreThoseOfIInJ) {
    const auto& [c, reversed] = GetParam();
    const Mechanism mechanism = build(c, reversed);
    SimTK::State state = mechanism.makeGivenState();
    ASSERT_EQ(state.getNU(), int(c.speeds.size()));
    const Marker &I = mechanism.getMarker(reversed ? 10 : 21), &J = mechanism.getMarker(reversed ? 21 : 10);
    for (int k = 0; k < state.getNU(); ++k) {
        state.updU() = 0;
        state.updU()[k] = 1;
        mechanism.getSystem().realize(state, SimTK::Stage::Velocity);
        const MarkerPair pair(I.findPoseInGround(state), J.findPoseInGround(state));
        const SpatialVec V = pair.calcVelocity(I.findVelocityInGround(state), J.findVelocityInGround(state));
        EXPECT_LT((V - c.speeds[size_t(k)]).norm(), Rounding) << k << V;
    }
}

INSTANTIATE_TEST_SUITE_P(Joints, Mobilizers,
                         ::testing::Combine(::testing::ValuesIn(Cases), ::testing::Bool()),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param).statement) +
                                    (std::get<1>(info.param) ? "Reversed" : "");
                         });

// A joint's value is Adams' too: an angle from x_J to x_I, a distance along z_J.
TEST(Mobilizer, CoordinatesAreAdams) {
    const Mechanism mechanism = testing::buildOrFail(
        "t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=2,3,4,QG=0,0,0.25,REULER=0.5,0,0\n"
        "MARKER/20\nMARKER/21\nJOINT/1,CYLINDRICAL,I=10,J=21\nEND\n",
        {Formulation::Tree});
    const SimTK::State state = mechanism.makeGivenState();
    EXPECT_NEAR(state.getQ()[0], -0.5, Rounding);
    EXPECT_NEAR(state.getQ()[1], -0.25, Rounding);
}

}  // namespace
}  // namespace jprim
