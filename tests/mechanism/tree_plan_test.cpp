// SPDX-License-Identifier: Apache-2.0
// Which part hangs on which, by what, and what is left as equations.
#include "mechanism/tree_plan.h"

#include <gtest/gtest.h>

#include "base/format.h"
#include "jprim/dataset/read_dataset.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

// Ground and three parts, each with a marker of its own at three places: MARKER/21 to MARKER/23 of PART/2.
std::string makeParts(int count = 3) {
    std::string text = "t\nPART/1,GROUND\nMARKER/11\nMARKER/12,QP=1,0,0\nMARKER/13,QP=2,0,0\n";
    for (int part = 2; part < count + 2; ++part)
        text += fmt::format(
            "PART/{0},MASS=1,CM={0}1,IP=1,1,1\nMARKER/{0}1\nMARKER/{0}2,QP=1,0,0\nMARKER/{0}3,QP=2,0,0\n",
            part);
    return text;
}

Dataset read(const std::string& text) {
    Diagnostics diagnostics;
    const Dataset dataset = readDataset(text + "END\n", diagnostics);
    EXPECT_EQ(testing::formatAll(diagnostics), "");
    return dataset;
}

// "PART/2 on PART/1 by Pin JOINT/1; …; equations JOINT/2", with "reversed" and "swapped" where they are.
std::string describe(const TreePlan& plan, const Dataset& dataset) {
    std::vector<std::string> lines;
    for (const PlannedMobilizer& m : plan.getMobilizers()) {
        std::string line = fmt::format("PART/{}", dataset.parts[size_t(m.part)].id);
        if (m.parent >= 0) line += fmt::format(" on PART/{}", dataset.parts[size_t(m.parent)].id);
        line += fmt::format(" by {}", getSimbodyName(m.type));
        if (m.reversed) line += " reversed";
        for (const PlannedElement& e : m.elements)
            line += " " + e.id.getText() + (e.swapped ? " swapped" : "");
        lines.push_back(line);
    }
    std::vector<std::string> equations;
    const auto addEquations = [&](ElementKind kind, const auto& statements) {
        for (const auto& s : statements)
            if (const ElementId id{kind, s.id}; !plan.find(id)) equations.push_back(id.getText());
    };
    addEquations(ElementKind::Jprim, dataset.jprims);
    addEquations(ElementKind::Joint, dataset.joints);
    if (!equations.empty()) lines.push_back(fmt::format("equations {}", join(equations, " ")));
    return join(lines, "; ");
}

std::string plan(const std::string& statements) {
    const Dataset dataset = read(makeParts() + statements);
    return describe(planTree(dataset), dataset);
}

TEST(TreePlan, PartsWithoutJointsAreFree) {
    EXPECT_EQ(plan(""), "PART/2 by Free; PART/3 by Free; PART/4 by Free");
}

TEST(TreePlan, AChainHangsInItsOrderWhateverTheMarkers) {
    EXPECT_EQ(
        plan("JOINT/3,SPHERICAL,I=32,J=41\nJOINT/2,REVOLUTE,I=31,J=22\nJOINT/1,CYLINDRICAL,I=21,J=11\n"),
        "PART/2 on PART/1 by Cylinder JOINT/1; PART/3 on PART/2 by Pin JOINT/2; "
        "PART/4 on PART/3 by Ball reversed JOINT/3");
}

TEST(TreePlan, EveryJointHasItsMobilizer) {
    const std::pair<const char*, const char*> cases[] = {
        {"FIXED", "Weld"},          {"REVOLUTE", "Pin"},    {"TRANSLATIONAL", "Slider"},
        {"UNIVERSAL", "Universal"}, {"HOOKE", "Universal"}, {"CYLINDRICAL", "Cylinder"},
        {"SPHERICAL", "Ball"},      {"PLANAR", "Planar"}};
    for (const auto& [type, mobilizer] : cases) {
        const Dataset dataset = read(makeParts(1) + fmt::format("JOINT/1,{},I=21,J=11\n", type));
        EXPECT_EQ(describe(planTree(dataset), dataset),
                  fmt::format("PART/2 on PART/1 by {} JOINT/1", mobilizer));
    }
    for (const char* type : {"CONVEL", "SCREW,PITCH=1", "RACKPIN,PD=1"}) {
        const Dataset dataset = read(makeParts(1) + fmt::format("JOINT/1,{},I=21,J=11\n", type));
        EXPECT_EQ(describe(planTree(dataset), dataset), "PART/2 by Free; equations JOINT/1");
    }
}

TEST(TreePlan, PrimitivesBetweenTheSameMarkersAreTakenTogether) {
    const std::tuple<const char*, const char*, const char*> cases[] = {
        {"ATPOINT", "ORIENTATION", "Weld"},      {"ATPOINT", "PARALLEL_AXES", "Pin"},
        {"INLINE", "ORIENTATION", "Slider"},     {"ATPOINT", "PERPENDICULAR", "Universal"},
        {"INLINE", "PARALLEL_AXES", "Cylinder"}, {"INPLANE", "PARALLEL_AXES", "Planar"}};
    for (const auto& [first, second, mobilizer] : cases) {
        // The rotational one means the same either way; the translational one says which marker is I.
        const Dataset dataset =
            read(makeParts(1) + fmt::format("JPRIM/1,{},I=11,J=21\nJPRIM/2,{},I=21,J=11\n", second, first));
        EXPECT_EQ(describe(planTree(dataset), dataset),
                  fmt::format("PART/2 on PART/1 by {} JPRIM/2 JPRIM/1 swapped", mobilizer));
    }
}

TEST(TreePlan, WhatIsLeftOfAPairStaysAnEquation) {
    EXPECT_EQ(plan("JPRIM/1,ORIENTATION,I=21,J=11\nJPRIM/2,INPLANE,I=21,J=11\n"
                   "JPRIM/3,ATPOINT,I=31,J=11\nJPRIM/4,ATPOINT,I=31,J=11\n"
                   "JPRIM/5,INLINE,I=41,J=11\n"),
              "PART/3 on PART/1 by Ball JPRIM/3; PART/2 on PART/1 by Translation JPRIM/1; PART/4 by Free; "
              "equations JPRIM/2 JPRIM/4 JPRIM/5");
    // Two different markers are two joints.
    EXPECT_EQ(plan("JPRIM/1,ATPOINT,I=21,J=11\nJPRIM/2,PARALLEL_AXES,I=22,J=11\n"),
              "PART/2 on PART/1 by Ball JPRIM/1; PART/3 by Free; PART/4 by Free; equations JPRIM/2");
}

// A four-bar is cut far from ground, and at the ball rather than the hinge.
TEST(TreePlan, LoopsAreShortAndCloseWithFewEquations) {
    EXPECT_EQ(plan("JOINT/1,REVOLUTE,I=21,J=11\nJOINT/2,SPHERICAL,I=31,J=22\nJOINT/3,REVOLUTE,I=42,J=32\n"
                   "JOINT/4,REVOLUTE,I=41,J=12\n"),
              "PART/2 on PART/1 by Pin JOINT/1; PART/4 on PART/1 by Pin JOINT/4; "
              "PART/3 on PART/4 by Pin reversed JOINT/3; equations JOINT/2");
}

// A scotch yoke: the block slides in the yoke and turns on the crank, and is cut from the crank.
TEST(TreePlan, LoopsAreClosedByHingesRatherThanSliders) {
    EXPECT_EQ(plan("JOINT/1,REVOLUTE,I=21,J=11\nJOINT/2,REVOLUTE,I=31,J=22\nJOINT/3,TRANSLATIONAL,I=32,J=42\n"
                   "JOINT/4,TRANSLATIONAL,I=41,J=12\n"),
              "PART/4 on PART/1 by Slider JOINT/4; PART/2 on PART/1 by Pin JOINT/1; "
              "PART/3 on PART/4 by Slider JOINT/3; equations JOINT/2");
}

TEST(TreePlan, WhatHangsTogetherInTheAirIsFreeAtOnePart) {
    EXPECT_EQ(plan("JOINT/1,REVOLUTE,I=31,J=22\n"),
              "PART/4 by Free; PART/2 by Free; PART/3 on PART/2 by Pin JOINT/1");
}

TEST(TreePlan, JointsToPointMassesAreEquations) {
    EXPECT_EQ(plan("POINT_MASS/1,MASS=1,CM=91\nMARKER/91,POINT_MASS=1\nJOINT/1,SPHERICAL,I=91,J=21\n"),
              "PART/2 by Free; PART/3 by Free; PART/4 by Free; equations JOINT/1");
}

TEST(TreePlan, OrNothingIsInTheTree) {
    const Dataset dataset = read(makeParts(1) + "JOINT/1,REVOLUTE,I=21,J=11\nJPRIM/7,INLINE,I=21,J=11\n");
    EXPECT_EQ(describe(planFreeParts(dataset), dataset), "PART/2 by Free; equations JPRIM/7 JOINT/1");
}

}  // namespace
}  // namespace jprim
