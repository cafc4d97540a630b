// SPDX-License-Identifier: Apache-2.0
#include "jprim/analysis/constraint_report.h"

#include <gtest/gtest.h>

#include "jprim/joint/joint.h"

namespace jprim {
namespace {

using SimTK::Body;
using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;

// One free body, in a length unit of choice, for tests to constrain.
struct OneBody {
    explicit OneBody(double unit_ = 1) : unit(unit_) {}

    Marker onBody(double x, double y, double z) const {
        return Marker(body, Transform(Rotation(0.3, SimTK::XAxis), unit * Vec3(x, y, z)));
    }
    Marker onGround(double x, double y, double z) const {
        return Marker(matter.getGround(), Transform(Rotation(0.3, SimTK::XAxis), unit * Vec3(x, y, z)));
    }
    ConstraintReport analyze() {
        const SimTK::State state = system.realizeTopology();
        system.realize(state, SimTK::Stage::Position);
        return analyzeConstraints(matter, state);
    }

    double unit;
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    Body::Rigid rigid{SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(1))};
    MobilizedBody::Free body{matter.Ground(), rigid};
};

TEST(ConstraintReport, NoConstraints) {
    const ConstraintReport report = OneBody().analyze();
    EXPECT_EQ(report.getGrueblerCount(), 6);
    EXPECT_EQ(report.getDegreesOfFreedom(), 6);
    EXPECT_EQ(report.getNumRedundant(), 0);
}

TEST(ConstraintReport, NothingThatMoves) {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter(system);
    const SimTK::State state = system.realizeTopology();
    system.realize(state, SimTK::Stage::Position);
    EXPECT_EQ(analyzeConstraints(matter, state).getDegreesOfFreedom(), 0);
}

// A door on two hinges: the second repeats five equations.
TEST(ConstraintReport, DoorOnTwoHinges) {
    for (const double unit : {1e-6, 1e-3, 1., 1e3}) {
        SCOPED_TRACE(unit);
        OneBody door(unit);
        // Along the z axis of markers turned by 0.3 about x.
        const Vec3 axis = Rotation(0.3, SimTK::XAxis) * Vec3(0, 0, 2);
        Joint::Revolute(door.onBody(0, 0, 0), door.onGround(0, 0, 0));
        Joint::Revolute(door.onBody(axis[0], axis[1], axis[2]), door.onGround(axis[0], axis[1], axis[2]));
        const ConstraintReport report = door.analyze();
        EXPECT_EQ(report.getGrueblerCount(), -4);
        EXPECT_EQ(report.getDegreesOfFreedom(), 1);
        EXPECT_EQ(report.getNumRedundant(), 5);
    }
}

// Nearly the same is not the same: hinges a hundredth of their distance out of line hold the door.
TEST(ConstraintReport, MisalignedHingesHold) {
    OneBody door;
    const Vec3 axis = Rotation(0.3, SimTK::XAxis) * Vec3(0, 0, 2);
    Joint::Revolute(door.onBody(0, 0, 0), door.onGround(0, 0, 0));
    AtPoint(door.onBody(axis[0] + 0.02, axis[1], axis[2]), door.onGround(axis[0] + 0.02, axis[1], axis[2]));
    EXPECT_EQ(door.analyze().getDegreesOfFreedom(), 0);
}

TEST(ConstraintReport, DisabledEquationsDoNotCount) {
    OneBody door;
    const Joint hinge = Joint::Revolute(door.onBody(0, 0, 0), door.onGround(0, 0, 0));
    SimTK::State state = door.system.realizeTopology();
    hinge.disable(state);
    door.system.realize(state, SimTK::Stage::Position);
    EXPECT_EQ(analyzeConstraints(door.matter, state).equations, 0);
}

}  // namespace
}  // namespace jprim
