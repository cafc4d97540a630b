// SPDX-License-Identifier: Apache-2.0
// Freedoms and redundant equations of mechanisms for which both are known.
#include "jprim/analysis/constraint_report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/free_bodies.h"
#include "jprim/flexible/reduce_to_modes.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using SimTK::Rotation;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;
using testing::FreeBodies;
using testing::getRedundantTexts;
using testing::getTexts;
using testing::makeHinge;
using testing::makePrimitive;
constexpr int Ground = FreeBodies::Ground;

// A direction and a point with nothing special about them.
const Vec3 Oblique = Vec3(0.3, -0.5, 0.8).normalize();
const Vec3 Corner(0.4, 0.7, -0.2);

TEST(ConstraintReport, NoConstraints) {
    FreeBodies one;
    one.addBody();
    const ConstraintReport report = one.analyze();
    EXPECT_EQ(report.getGrueblerCount(), 6);
    EXPECT_EQ(report.getDegreesOfFreedom(), 6);
    EXPECT_EQ(report.getNumRedundant(), 0);
    EXPECT_FALSE(report.isSingularPosition());
}

TEST(ConstraintReport, NothingThatMoves) {
    EXPECT_EQ(FreeBodies().analyze().getDegreesOfFreedom(), 0);
}

// A door on two hinges a distance of 2 apart: the second repeats the five equations of the first. Where it
// is, a shift across the axis is one at the first hinge and a tilt there.
TEST(ConstraintReport, DoorOnTwoHinges) {
    for (const double unit : {1e-6, 1e-3, 1., 1e3}) {
        SCOPED_TRACE(unit);
        FreeBodies door(unit);
        door.addBody(Transform(Rotation(0.3, SimTK::YAxis), Vec3(0.5, -0.2, 0.1)));
        door.addJoint(Joint::Revolute, 0, Ground, makeHinge(Corner, Oblique));
        door.addJoint(Joint::Revolute, 0, Ground, makeHinge(Corner + 2 * Oblique, Oblique));
        const ConstraintReport report = door.analyze();
        EXPECT_EQ(report.getGrueblerCount(), -4);
        EXPECT_EQ(report.getDegreesOfFreedom(), 1);
        EXPECT_EQ(report.getNumRedundant(), 5);
        EXPECT_FALSE(report.isSingularPosition());

        const std::string first = "JOINT/1 REVOLUTE: ", second = "JOINT/2 REVOLUTE: ";
        const std::map<std::string, std::set<std::string>> expected = {
            {"translation of I along Xj", {"translation of I along Xj", "rotation between Zi and Xj"}},
            {"translation of I along Yj", {"translation of I along Yj", "rotation between Zi and Yj"}},
            {"translation of I along Zj", {"translation of I along Zj"}},
            {"rotation between Zi and Xj", {"rotation between Zi and Xj"}},
            {"rotation between Zi and Yj", {"rotation between Zi and Yj"}}};
        std::map<std::string, std::set<std::string>> found;
        for (const RedundantEquation& r : report.redundant) {
            EXPECT_FALSE(r.onlyHere);
            const ConstraintEquation& equation = report.equations[size_t(r.equation)];
            EXPECT_EQ(equation.element + ": ", second);
            for (const std::string& text : getTexts(report, r.dependsOn)) {
                EXPECT_EQ(text.find(first), 0u) << text;
                found[equation.words].insert(text.substr(first.size()));
            }
        }
        EXPECT_EQ(found, expected);
    }
}

// Nearly the same is not the same: hinges a hundredth of their distance out of line hold the door.
TEST(ConstraintReport, MisalignedHingesHold) {
    FreeBodies door;
    door.addBody();
    door.addJoint(Joint::Revolute, 0, Ground, makeHinge(Corner, Oblique));
    door.addJoint(Joint::Spherical, 0, Ground, Corner + 2 * Oblique + Vec3(0.02, 0, 0));
    EXPECT_EQ(door.analyze().getDegreesOfFreedom(), 0);
}

TEST(ConstraintReport, DisabledEquationsDoNotCount) {
    FreeBodies door;
    door.addBody();
    door.addJoint(Joint::Revolute, 0, Ground, makeHinge(Corner, Oblique));
    State state = door.system.realizeTopology();
    door.joints[0].disable(state);
    door.system.realize(state, Stage::Position);
    EXPECT_EQ(analyzeConstraints(door.matter, state).numEquations, 0);
    EXPECT_EQ(countFreedoms(door.matter, state).numEquations, 0);
}

// Closes a chain of links with hinges at the given points, the last link being Ground.
void addLoop(FreeBodies& loop, const std::vector<Vec3>& points, const std::vector<Vec3>& axes) {
    const int numLinks = int(points.size()) - 1;
    for (int k = 0; k < numLinks; ++k)
        loop.addBody(Transform(Rotation(0.4 * k, SimTK::YAxis), (points[k] + points[k + 1]) / 2));
    for (int k = 0; k <= numLinks; ++k)
        loop.addJoint(Joint::Revolute, k == numLinks ? Ground : k, k == 0 ? Ground : k - 1,
                      makeHinge(points[size_t(k)], axes[size_t(k)]));
}

std::vector<Vec3> rotate(std::vector<Vec3> vectors) {
    const Rotation R = makeHinge(Vec3(0), Oblique).R();
    for (Vec3& v : vectors) v = R * v;
    return vectors;
}

// A plane four-bar in space: three of its 20 equations are not needed, those that keep the last hinge in the
// plane. Grübler: 18 - 20 = -2; freedoms 1.
TEST(ConstraintReport, FourBar) {
    FreeBodies fourBar;
    addLoop(fourBar, rotate({{0, 0, 0}, {0.3, 0.9, 0}, {1.7, 1.4, 0}, {2, 0, 0}}),
            rotate(std::vector<Vec3>(4, Vec3(0, 0, 1))));
    const ConstraintReport report = fourBar.analyze();
    EXPECT_EQ(report.getGrueblerCount(), -2);
    EXPECT_EQ(report.getDegreesOfFreedom(), 1);
    EXPECT_FALSE(report.isSingularPosition());
    EXPECT_EQ(getRedundantTexts(report),
              (std::set<std::string>{"JOINT/4 REVOLUTE: translation of I along Zj",
                                     "JOINT/4 REVOLUTE: rotation between Zi and Yj",
                                     "JOINT/4 REVOLUTE: rotation between Zi and Xj"}));
    // Parallel axes follow from parallel axes.
    for (const RedundantEquation& r : report.redundant) {
        if (report.equations[size_t(r.equation)].words == "translation of I along Zj") continue;
        for (const int k : r.dependsOn)
            EXPECT_EQ(report.equations[size_t(k)].words.find("rotation"), 0u)
                << report.equations[size_t(k)].getText();
    }
}

// R. Bricard, Mémoire sur la théorie de l'octaèdre articulé (1897), the trihedral case: six links along the
// edges of a cube that avoid two opposite corners, hinges at right angles to both neighbours. It moves though
// 5 * 6 - 6 * 5 = 0. Also problem A04 of the IFToMM library of benchmark problems.
TEST(ConstraintReport, Bricard) {
    const std::vector<Vec3> points = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}};
    const std::vector<Vec3> axes = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    FreeBodies bricard;
    addLoop(bricard, rotate(points), rotate(axes));
    const ConstraintReport report = bricard.analyze();
    EXPECT_EQ(report.getGrueblerCount(), 0);
    EXPECT_EQ(report.getDegreesOfFreedom(), 1);
    EXPECT_EQ(report.freedomsNearby, 1);
    ASSERT_EQ(report.redundant.size(), 1u);
    EXPECT_EQ(report.equations[size_t(report.redundant[0].equation)].element, "JOINT/6 REVOLUTE");

    // With one axis tilted it is a frame.
    std::vector<Vec3> tilted = axes;
    tilted[2] = Vec3(0.1, 1, 0.05);
    FreeBodies frame;
    addLoop(frame, rotate(points), rotate(tilted));
    EXPECT_EQ(frame.analyze().getDegreesOfFreedom(), 0);
    EXPECT_EQ(frame.analyze().getNumRedundant(), 0);
}

// A plane platform on three legs of a hinge, a slider and a hinge: 7 parts, 9 joints of 5 equations. It has
// the plane's 3 freedoms; each of the two loops closes 3 times more than needed.
TEST(ConstraintReport, PlanarStewartPlatform) {
    FreeBodies stewart;
    const Vec3 normal(0, 0, 1);
    const std::vector<Vec3> base = rotate({{0, 0, 0}, {3, 0.2, 0}, {1.1, 2.7, 0}});
    const std::vector<Vec3> top = rotate({{1, 0.8, 0}, {1.9, 0.7, 0}, {1.3, 1.6, 0}});
    const Vec3 axis = rotate({normal})[0];
    const int platform = stewart.addBody();
    for (int leg = 0; leg < 3; ++leg) {
        const int lower = stewart.addBody(base[size_t(leg)]), upper = stewart.addBody(top[size_t(leg)]);
        stewart.addJoint(Joint::Revolute, lower, Ground, makeHinge(base[size_t(leg)], axis));
        stewart.addJoint(Joint::Translational, upper, lower,
                         makeHinge(top[size_t(leg)], top[size_t(leg)] - base[size_t(leg)]));
        stewart.addJoint(Joint::Revolute, platform, upper, makeHinge(top[size_t(leg)], axis));
    }
    const ConstraintReport report = stewart.analyze();
    EXPECT_EQ(report.getGrueblerCount(), 42 - 45);
    EXPECT_EQ(report.getDegreesOfFreedom(), 3);
    EXPECT_FALSE(report.isSingularPosition());
    EXPECT_EQ(report.redundant.size(), 6u);
}

// The same figures in metres and millimetres, the singular values too.
TEST(ConstraintReport, UnitsDoNotMatter) {
    const auto analyze = [](double unit) {
        FreeBodies fourBar(unit);
        addLoop(fourBar, {{0, 0, 0}, {0.3, 0.9, 0}, {1.7, 1.4, 0}, {2, 0, 0}},
                std::vector<Vec3>(4, Vec3(0, 0, 1)));
        fourBar.addJoint(makePrimitive<InPlane>, 1, Ground, makeHinge(Vec3(1, 1, 0), Vec3(0, 0, 1)));
        return fourBar.analyze();
    };
    constexpr double Rounding = 1e-9;
    const ConstraintReport metres = analyze(1);
    for (const double unit : {1e-6, 1e-3, 1e3}) {
        const ConstraintReport other = analyze(unit);
        EXPECT_EQ(other.rank, metres.rank);
        EXPECT_NEAR(other.smallestKept, metres.smallestKept, Rounding);
        EXPECT_LT(other.largestDropped, Rounding);
        EXPECT_EQ(getRedundantTexts(other), getRedundantTexts(metres));
    }
}

// What is redundant on a rigid bar is not on one that bends and stretches: with all 6 deformations of its ends
// and one mode inside, two hinges on one axis take 10 of 6 + 7 freedoms.
TEST(ConstraintReport, FlexibleBodies) {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter(system);
    SimTK::GeneralForceSubsystem forces(system);
    const FiniteElementModel mesh = makeFiniteElementModel(testing::makeSteelBeam(4));
    const FlexibleBody beam(matter, forces, reduceToModes(mesh, {{{1}, 0, {}}, {{5}, 0, {}}}, 1));
    const Transform X(Rotation(SimTK::Pi / 2, SimTK::YAxis));  // z along the beam
    Joint::Revolute(Marker(beam, 1, X), Marker(matter.Ground(), X), "JOINT/1");
    Joint::Revolute(Marker(beam, 5, X), Marker(matter.Ground(), Transform(X.R(), Vec3(2, 0, 0))), "JOINT/2");
    Joint::Revolute(Marker(beam, 5, X), Marker(matter.Ground(), Transform(X.R(), Vec3(2, 0, 0))), "JOINT/3");
    const State state = system.realizeTopology();
    system.realize(state, Stage::Position);
    const ConstraintReport report = analyzeConstraints(matter, state);
    EXPECT_EQ(report.getGrueblerCount(), 6 + 7 - 15);
    EXPECT_EQ(report.getDegreesOfFreedom(), 6 + 7 - 10);
    ASSERT_EQ(report.redundant.size(), 5u);
    for (const RedundantEquation& r : report.redundant) {
        EXPECT_EQ(report.equations[size_t(r.equation)].element.find("JOINT/3"), 0u);
        EXPECT_EQ(r.dependsOn, std::vector<int>{r.equation - 5});
    }
}

// A loose assembly: the four-bar's hinges are 1e-5 apart, yet it is judged as assembled.
TEST(ConstraintReport, LooseAssemblyIsJudgedAsTight) {
    FreeBodies fourBar;
    addLoop(fourBar, {{0, 0, 0}, {0.3, 0.9, 0}, {1.7, 1.4, 0}, {2, 0, 0}},
            std::vector<Vec3>(4, Vec3(0, 0, 1)));
    State state = fourBar.draw();
    for (int k = 0; k < state.getNQ(); ++k) state.updQ()[k] += 1e-5 * std::sin(1.3 * k);
    fourBar.system.realize(state, Stage::Position);
    EXPECT_GT(state.getQErr().normInf(), 1e-6);
    EXPECT_EQ(countFreedoms(fourBar.matter, state).getNumRedundant(), 3);
    EXPECT_EQ(analyzeConstraints(fourBar.matter, state).redundant.size(), 3u);
}

}  // namespace
}  // namespace jprim
