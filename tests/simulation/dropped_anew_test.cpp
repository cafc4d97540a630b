// SPDX-License-Identifier: Apache-2.0
// Mechanisms whose redundant equations change places: no choice of equations to keep is good everywhere.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "jprim/marker/angles.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Real;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;

std::string formatFrame(const Transform& X) {
    const Vec3 angles = calcAngles313(X.R());
    return fmt::format("QP={},{},{},REULER={},{},{}", X.p()[0], X.p()[1], X.p()[2], angles[0], angles[1],
                       angles[2]);
}

// A ring of four hinges that moves although 6 - 4 * 5 + 3 * 6 < 0: opposite links are alike, and lengths a, b and twists
// A, B of neighbours go as a/b = sin A / sin B. Source: G. T. Bennett, A new mechanism, Engineering 76 (1903).
// Its angles obey tan(t1/2) tan(t2/2) = sin((B + A)/2) / sin((B - A)/2), t3 = -t1, t4 = -t2.
std::string writeBennettLinkage() {
    const Real a = 0.5, A = 0.7, B = 1.3, t1 = 1;
    const Real b = a * std::sin(B) / std::sin(A);
    const Real t2 = 2 * std::atan(std::sin((B + A) / 2) / std::sin((B - A) / 2) / std::tan(t1 / 2));
    const Real angles[] = {t1, t2, -t1, -t2}, lengths[] = {a, b, a, b}, twists[] = {A, B, A, B};
    Transform hinge(Rotation(0.4, SimTK::XAxis) * Rotation(0.3, SimTK::ZAxis), Vec3(0.1, 0.2, 0.3));
    std::string text = "Bennett\nACCGRAV/IGRAV=2.1,JGRAV=-9.81,KGRAV=1.3\nPART/1,GROUND\n", joints;
    for (int k = 0; k < 4; ++k) {
        const int before = k + 1, after = k == 3 ? 1 : k + 2;  // the parts that the hinge is between
        const Transform next = hinge * Transform(Rotation(angles[k], SimTK::ZAxis), Vec3(0)) *
                               Transform(Rotation(twists[k], SimTK::XAxis), Vec3(lengths[k], 0, 0));
        if (k < 3) {
            const Vec3 center = (hinge.p() + next.p()) / 2;
            text += fmt::format(
                "PART/{0},MASS={1},IP=0.02,0.03,0.04,CM={0}0\nMARKER/{0}0,PART={0},QP={2},{3},{4}\n", after,
                1 + 0.3 * k, center[0], center[1], center[2]);
        }
        joints += fmt::format(
            "MARKER/{0}1,PART={1},{3}\nMARKER/{0}2,PART={2},{3}\nJOINT/{0},REVOLUTE,I={0}1,J={0}2\n", k + 100,
            after, before, formatFrame(hinge));
        hinge = next;
    }
    return text + joints + "END\n";
}

// Three discs on parallel axes, neighbours joined by three parallel links each; the middle one floats. Driven.
std::string writeSchmidtCoupling() {
    const Real radius = 0.2;
    const Vec3 offsets[] = {Vec3(0), Vec3(0.15, 0.11, 0.05), Vec3(0.25, -0.06, 0.1)};
    std::string text = "Schmidt\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/1\n";
    int marker = 100, joint = 0;
    const auto add = [&](int part, const Vec3& at) {
        text += fmt::format("MARKER/{},PART={},QP={},{},{}\n", ++marker, part, at[0], at[1], at[2]);
        return marker;
    };
    const auto addHinge = [&](int partI, int partJ, const Vec3& at) {
        const int i = add(partI, at), j = add(partJ, at);
        text += fmt::format("JOINT/{},REVOLUTE,I={},J={}\n", ++joint, i, j);
    };
    const auto addPart = [&](int part, Real mass, Real moment, const Vec3& center) {
        text += fmt::format("PART/{},MASS={},IP={},{},{},CM={}\n", part, mass, moment, moment, 1.5 * moment,
                            marker + 1);
        add(part, center);
    };
    for (int disc = 0; disc < 3; ++disc)
        addPart(2 + disc, 1, 0.02, offsets[disc] + Vec3(0.01 * disc, 0.02, 0));
    addHinge(2, 1, offsets[0]);
    addHinge(4, 1, offsets[2]);
    for (int stage = 0; stage < 2; ++stage)
        for (int k = 0; k < 3; ++k) {
            const Real angle = 2 * SimTK::Pi * k / 3 + 0.2;
            const Vec3 pin = radius * Vec3(std::cos(angle), std::sin(angle), 0);
            const int link = 5 + 3 * stage + k;
            addPart(link, 0.1, 1e-4, pin + (offsets[stage] + offsets[stage + 1]) / 2);
            addHinge(link, 2 + stage, pin + offsets[stage]);
            addHinge(link, 3 + stage, pin + offsets[stage + 1]);
        }
    return text + "MOTION/1,JOINT=1,VELOCITY,FUNCTION=3\nEND\n";
}

SimulationOutcome run(const std::string& text, Formulation formulation, Redundancy redundancy) {
    const Mechanism mechanism = testing::buildOrFail(text, {formulation});
    SimulationOptions options;
    options.end = 4;
    options.steps = 40;
    options.accuracy = 1e-9;
    options.redundancy = redundancy;
    SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    EXPECT_EQ(outcome.failure, "");
    return outcome;
}

class DroppedAnew : public ::testing::TestWithParam<Formulation> {};

TEST_P(DroppedAnew, ABennettLinkageMovesAsWithAllItsEquations) {
    constexpr Real SameMotion = 1e-5;  // errors of steps add up over two turns
    const SimulationOutcome shared = run(writeBennettLinkage(), GetParam(), Redundancy::Share);
    const SimulationOutcome dropped = run(writeBennettLinkage(), GetParam(), Redundancy::Drop);
    EXPECT_EQ(dropped.summary.droppedEquations.size(), 3u);
    ASSERT_FALSE(dropped.summary.droppedAnew.empty());
    EXPECT_EQ(dropped.summary.droppedAnew[0].equations.size(), 3u);
    EXPECT_GT(dropped.summary.droppedAnew[0].time, 0);
    EXPECT_TRUE(shared.summary.droppedAnew.empty());
    for (const char* column : {"PART/2.X", "PART/3.Y", "PART/4.Z", "PART/4.WX"})
        EXPECT_NEAR(dropped.results.parts.getColumn(column).back(),
                    shared.results.parts.getColumn(column).back(), SameMotion)
            << column;
}

TEST_P(DroppedAnew, ASchmidtCouplingTurnsItsOutputAsItsInput) {
    constexpr Real Rounding = 1e-9;
    const SimulationOutcome dropped = run(writeSchmidtCoupling(), GetParam(), Redundancy::Drop);
    EXPECT_FALSE(dropped.summary.droppedAnew.empty());
    for (const Real w : dropped.results.parts.getColumn("PART/4.WZ")) EXPECT_NEAR(w, 3, Rounding);
}

INSTANTIATE_TEST_SUITE_P(Formulations, DroppedAnew,
                         ::testing::Values(Formulation::Tree, Formulation::Constraints),
                         [](const auto& info) {
                             return info.param == Formulation::Tree ? "Tree" : "Constraints";
                         });

}  // namespace
}  // namespace jprim
