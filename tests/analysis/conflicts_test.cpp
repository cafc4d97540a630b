// SPDX-License-Identifier: Apache-2.0
#include "jprim/analysis/conflicts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/free_bodies.h"

namespace jprim {
namespace {

using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;
using testing::FreeBodies;
using testing::getTexts;
using testing::makeHinge;
using testing::makePrimitive;
constexpr int Ground = FreeBodies::Ground;
constexpr double Converged = 1e-6;  // of a search that stops at a relative gradient of 1e-10

ConflictReport analyze(FreeBodies& bodies) {
    const SimTK::State state = bodies.draw();
    return findConflicts(bodies.matter, state, nameElements(bodies.joints));
}

// A rod of 1 between balls 3 apart, on a slant: it ends up in the middle, in line with them, a gap of 1 left at
// each end. Nothing but the translations along the line are in conflict.
TEST(Conflicts, RodTooShort) {
    for (const double unit : {1e-3, 1.}) {
        FreeBodies rod(unit);
        rod.addBody(Transform(Rotation(0.7, SimTK::ZAxis), Vec3(0.3, 0.2, -0.1)));
        const auto addBall = [&](const Vec3& onRod, const Vec3& onGround) {
            rod.addJoint(
                makePrimitive<AtPoint>,
                rod.mark(0, Transform(Rotation(0.7, SimTK::ZAxis), Vec3(0.3, 0.2, -0.1)) * Transform(onRod)),
                rod.mark(Ground, onGround));
        };
        addBall(Vec3(0), Vec3(0));
        addBall(Vec3(1, 0, 0), Vec3(3, 0, 0));
        const ConflictReport report = analyze(rod);
        ASSERT_EQ(report.conflicts.size(), 1u);
        EXPECT_FALSE(report.isAssembled());
        const Conflict& conflict = report.conflicts[0];
        EXPECT_EQ(getTexts(report, conflict.equations),
                  (std::set<std::string>{"JOINT/1 ATPOINT: translation of I along Xj",
                                         "JOINT/2 ATPOINT: translation of I along Xj"}));
        ASSERT_EQ(conflict.errors.size(), 2u);
        EXPECT_NEAR(conflict.errors[0], unit, Converged * unit);
        EXPECT_NEAR(conflict.errors[1], -unit, Converged * unit);
    }
}

// Links of 1, 2 and 3 do not close a loop over a base of 10: stretched, all four hinges share a gap of 4. A
// pendulum in the same system has nothing to do with it.
TEST(Conflicts, FourBarThatCannotClose) {
    FreeBodies loop;
    const Vec3 normal(0, 0, 1);
    const int pendulum = loop.addBody(), crank = loop.addBody(), coupler = loop.addBody(Vec3(1, 0.3, 0)),
              rocker = loop.addBody(Vec3(2, -0.4, 0));
    loop.addJoint(Joint::Revolute, pendulum, Ground, makeHinge(Vec3(1, 2, 3), Vec3(1, 2, -1)));
    const auto addPin = [&](int I, const Vec3& onI, int J, const Vec3& onJ) {
        loop.addJoint(Joint::Revolute, loop.mark(I, makeHinge(onI, normal)),
                      loop.mark(J, makeHinge(onJ, normal)));
    };
    addPin(crank, Vec3(0), Ground, Vec3(0));
    addPin(coupler, Vec3(1, 0.3, 0), crank, Vec3(1, 0, 0));
    addPin(rocker, Vec3(2, -0.4, 0), coupler, Vec3(3, 0.3, 0));
    addPin(Ground, Vec3(10, 0, 0), rocker, Vec3(5, -0.4, 0));
    const ConflictReport report = analyze(loop);
    ASSERT_EQ(report.conflicts.size(), 1u);
    std::map<std::string, double> gaps;
    for (size_t k = 0; k < report.conflicts[0].equations.size(); ++k) {
        const ConstraintEquation& equation = report.equations[size_t(report.conflicts[0].equations[k])];
        EXPECT_EQ(equation.dimension, Dimension::Length) << equation.getText();
        double& gap = gaps[equation.element];
        gap = std::hypot(gap, report.conflicts[0].errors[k]);
    }
    double sum = 0;
    for (const auto& [element, gap] : gaps) sum += gap;
    EXPECT_EQ(gaps.size(), 4u);
    EXPECT_EQ(gaps.count("JOINT/1 REVOLUTE"), 0u);
    EXPECT_NEAR(sum, 10 - 1 - 2 - 3, Converged);
}

// Drawn in line and folded back, by symmetry no motion makes the gap less to first order; any to the side does.
TEST(Conflicts, AStationaryPointIsNotTheLeast) {
    FreeBodies rod;
    rod.addBody(Transform(Rotation(SimTK::Pi, SimTK::ZAxis)));
    rod.addJoint(Joint::Spherical, rod.mark(0, Vec3(0)), rod.mark(Ground, Vec3(0)));
    rod.addJoint(Joint::Spherical, rod.mark(0, Vec3(-1, 0, 0)), rod.mark(Ground, Vec3(3, 0, 0)));
    const ConflictReport report = analyze(rod);
    ASSERT_EQ(report.conflicts.size(), 1u);
    double sum = 0;
    for (const double error : report.conflicts[0].errors) sum += std::abs(error);
    EXPECT_NEAR(sum, 3 - 1, Converged);
}

// Two mechanisms apart, two conflicts.
TEST(Conflicts, WhatDoesNotHangTogetherIsToldApart) {
    FreeBodies rods;
    for (const double y : {0., 5.}) {
        const int rod = rods.addBody(Vec3(0, y, 0));
        rods.addJoint(Joint::Spherical, rods.mark(rod, Vec3(0, y, 0)), rods.mark(Ground, Vec3(0, y, 0)));
        rods.addJoint(Joint::Spherical, rods.mark(rod, Vec3(1, y, 0)), rods.mark(Ground, Vec3(3 + y, y, 0)));
    }
    EXPECT_EQ(analyze(rods).conflicts.size(), 2u);
}

// What can be assembled is no conflict, from however far it starts.
TEST(Conflicts, NoneWhereTheEquationsCanBeMet) {
    FreeBodies door;
    door.addBody();
    door.addJoint(Joint::Revolute, door.mark(0, makeHinge(Vec3(1, 2, 3), Vec3(1, 1, 0))),
                  door.mark(Ground, makeHinge(Vec3(-1, 0, 2), Vec3(0, 0.2, 1))));
    const ConflictReport report = analyze(door);
    EXPECT_TRUE(report.isAssembled());
    door.system.realize(report.state, SimTK::Stage::Position);
    EXPECT_LT(report.state.getQErr().normInf(), 1e-9);
    EXPECT_TRUE(analyze(*std::make_unique<FreeBodies>()).isAssembled());
}

//---------------------------------------------------------------------------------------- flipped
std::vector<FlippedAxes> findFlipped(FreeBodies::Make make, double angle) {
    FreeBodies door;
    door.addBody();
    const Transform X = makeHinge(Vec3(0.1, 0.2, 0.3), Vec3(0.4, 0.5, -0.6));
    door.addJoint(make, door.mark(0, X * Transform(Rotation(angle, SimTK::UnitVec3(0.6, 0.8, 0)))),
                  door.mark(Ground, X));
    const SimTK::State state = door.draw();
    return findFlippedAxes(door.matter, state, nameElements(door.joints));
}

TEST(FlippedAxes, AreNamedWithTheirAngle) {
    // Of an arc sine near 1; at half a turn PARALLEL_AXES looks a little to the side of its singularity.
    constexpr double Rounding = 1e-7, BesideHalfATurn = 2e-4;
    for (const double degrees : {95., 130., 180.}) {
        const double angle = degrees * SimTK_DEGREE_TO_RADIAN;
        const std::vector<FlippedAxes> hinge = findFlipped(Joint::Revolute, angle);
        ASSERT_EQ(hinge.size(), 1u);
        EXPECT_EQ(hinge[0].element, "JOINT/1 REVOLUTE");
        EXPECT_EQ(hinge[0].axes, "z axes");
        EXPECT_NEAR(hinge[0].angle, angle, degrees < 180 ? Rounding : BesideHalfATurn);
        const std::vector<FlippedAxes> weld = findFlipped(Joint::Fixed, angle);
        ASSERT_EQ(weld.size(), 1u);
        EXPECT_EQ(weld[0].axes, "axes");
        EXPECT_NEAR(weld[0].angle, angle, Rounding);
    }
}

TEST(FlippedAxes, LessThanARightAngleIsNotFlipped) {
    EXPECT_TRUE(findFlipped(Joint::Revolute, 1.5).empty());
    EXPECT_TRUE(findFlipped(Joint::Fixed, 1.5).empty());
    // A PERPENDICULAR has two right positions, a ball no axes.
    EXPECT_TRUE(findFlipped(Joint::Universal, 3).empty());
}

}  // namespace
}  // namespace jprim
