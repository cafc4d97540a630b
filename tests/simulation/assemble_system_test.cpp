// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/assemble_system.h"

#include <gtest/gtest.h>

#include "jprim/base/error.h"
#include "jprim/joint/joint.h"
#include "support/expect_error.h"

namespace jprim {
namespace {

using SimTK::MobilizedBody;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

constexpr Real Met = 1e-9;      // what assemble() promises
constexpr Real Staying = 1e-5;  // by how much goals of weight 1 yield to bodies that stay, at 1e-6

/// A free body on Ground and what may hold it.
class FreeBody : public ::testing::Test {
protected:
    State assemble(const AssemblyGoals& goals = {}, const ElementNames& names = {}) {
        State state = system.realizeTopology();
        body.setQToFitTransform(state, given);
        return jprim::assemble(system, state, goals, names);
    }
    Marker mark(const Vec3& place) { return Marker(body, place); }

    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    MobilizedBody::Free body{matter.updGround(), SimTK::Body::Rigid(SimTK::MassProperties(
                                                     1, Vec3(0), SimTK::UnitInertia(1, 1, 1)))};
    const Transform given{Rotation(0.3, SimTK::UnitVec3(1, 2, -1)), Vec3(0.2, -0.1, 0.4)};
};

// Two hinges on one axis are ten equations on six coordinates; only the turn about it is left.
TEST_F(FreeBody, HangsOnTwoHinges) {
    const Transform X(Rotation(1.1, SimTK::UnitVec3(0.3, 1, 0.2)), Vec3(0.5, 0.2, -0.7));
    const Transform along(Vec3(0, 0, 2));
    Joint::Revolute(Marker(body, X), Marker(matter.updGround(), X));
    Joint::Revolute(Marker(body, X * along), Marker(matter.updGround(), X * along));
    const State state = assemble();
    EXPECT_LT(state.getQErr().normInf(), Met);
    const Transform X_GB = body.getBodyTransform(state);
    EXPECT_LT((X_GB * X.p() - X.p()).norm(), Met);
}

TEST_F(FreeBody, BringsMarkersToTheirPlaces) {
    const Transform wanted(Rotation(-0.8, SimTK::UnitVec3(2, -1, 0.5)), Vec3(1, 2, 3));
    AssemblyGoals goals;
    for (const Vec3& p : {Vec3(0.1, 0, 0), Vec3(0, 0.7, 0), Vec3(0, 0.2, 1.3)})
        goals.markers.push_back({mark(p), wanted * p, 1});
    const Transform X_GB = body.getBodyTransform(assemble(goals));
    EXPECT_LT((X_GB.p() - wanted.p()).norm(), Staying);
    EXPECT_LT((X_GB.R().asMat33() - wanted.R().asMat33()).norm(), Staying);
    // The comparison can fail: a place slightly elsewhere is noticed.
    goals.markers[0].place += Vec3(1e-3, 0, 0);
    EXPECT_GT((body.getBodyTransform(assemble(goals)).p() - wanted.p()).norm(), 10 * Staying);
}

// On a ball at the origin a rod points at the place that its end cannot reach.
TEST_F(FreeBody, ConstraintsComeBeforeGoals) {
    Joint::Spherical(mark(Vec3(0)), Marker(matter.updGround()));
    AssemblyGoals goals;
    const Vec3 place(0.6, -1.7, 2.2);
    goals.markers.push_back({mark(Vec3(1, 0, 0)), place, 1});
    const Transform X_GB = body.getBodyTransform(assemble(goals));
    EXPECT_LT(X_GB.p().norm(), Met);
    EXPECT_LT((X_GB * Vec3(1, 0, 0) - place.normalize()).norm(), Staying);
}

TEST_F(FreeBody, StaysWhereNothingMovesIt) {
    const Transform X_GB = body.getBodyTransform(assemble());
    EXPECT_LT((X_GB.p() - given.p()).norm(), 1e-14);
}

TEST_F(FreeBody, NamesWhatCannotBeMet) {
    const Joint near = Joint::Spherical(mark(Vec3(0)), Marker(matter.updGround())),
                far = Joint::Spherical(mark(Vec3(1, 0, 0)), Marker(matter.updGround(), Vec3(3, 0, 0)), "far");
    const std::string text = testing::catchError([&] { assemble({}, nameElements({near, far})); });
    EXPECT_NE(text.find("the system cannot be assembled from these positions; "), std::string::npos) << text;
    EXPECT_NE(text.find("length units of \"translation of I along Xj\" are left"), std::string::npos) << text;
}

TEST_F(FreeBody, GoalsAreChecked) {
    AssemblyGoals goals;
    goals.staying = 0;
    EXPECT_EQ(testing::catchError([&] { assemble(goals); }),
              "AssemblyGoals: staying is 0; it must be positive");
    goals = {};
    goals.markers.push_back({});
    EXPECT_EQ(testing::catchError([&] { assemble(goals); }),
              "AssemblyGoals: a MarkerGoal's marker is not on a body of the system");
}

// In a tree: a chain of pins whose end is to be brought to a point and whose first pin is locked.
TEST(AssembleSystem, LocksAMobilizerInATree) {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter(system);
    const SimTK::Body::Rigid link(SimTK::MassProperties(1, Vec3(0), SimTK::UnitInertia(1, 1, 1)));
    MobilizedBody::Pin first(matter.updGround(), link), second(first, Vec3(1, 0, 0), link, Vec3(0)),
        third(second, Vec3(1, 0, 0), link, Vec3(0));
    Joint::Spherical(Marker(third, Vec3(1, 0, 0)), Marker(matter.updGround(), Vec3(1.4, 1.1, 0)));
    State state = system.realizeTopology();
    first.setAngle(state, 0.2);
    AssemblyGoals goals;
    goals.locked = {first.getMobilizedBodyIndex()};
    const State assembled = assemble(system, state, goals);
    EXPECT_EQ(first.getAngle(assembled), 0.2);
    EXPECT_LT(assembled.getQErr().normInf(), Met);
}

}  // namespace
}  // namespace jprim
