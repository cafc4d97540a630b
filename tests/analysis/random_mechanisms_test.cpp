// SPDX-License-Identifier: Apache-2.0
// Closed mechanisms whose redundancy is known from how they were made.
//
// A tree of hinges, sleeves and crosses at random places has independent equations. A joint that repeats one
// of the tree adds nothing. A joint of e equations at a random place that closes a path with k freedoms of the
// tree adds min(e, k) independent ones: its equations ask something of each relative motion, and nothing about
// a random place makes them ask the same twice. (That is so for k <= 6 and paths without common tree joints.)
#include <gtest/gtest.h>

#include <random>

#include "analysis/check_report.h"
#include "analysis/free_bodies.h"

namespace jprim {
namespace {

using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;
using testing::FreeBodies;
using testing::makePrimitive;
using testing::ReportChecker;

enum class TreeJoint { Hinge, Sleeve, Cross };

class RandomMechanism : public FreeBodies {
public:
    explicit RandomMechanism(unsigned seed) : m_generator(seed) {
        const int numBodies = pick(2, 9);
        for (int k = 0; k < numBodies; ++k) {
            const int body = addBody(drawPose());
            m_edges.push_back({pick(-1, body - 1), TreeJoint(pick(0, 2)), drawPose(), false});
            addTreeJoint(body);
        }
        numTreeJoints = int(joints.size());
        for (int k = pick(1, 4); k > 0; --k) pick(0, 1) ? repeatTreeJoint() : closePath();
    }

    int numTreeJoints = 0;
    int numRedundant = 0;  // by construction
    int numLost = 0;       // freedoms that loops take

private:
    struct Edge {
        int parent;
        TreeJoint type;
        Transform X_GM;
        bool isInLoop;
    };

    int pick(int first, int last) { return first + int(m_generator() % unsigned(last - first + 1)); }
    double drawNumber() { return 2. * m_generator() / double(m_generator.max()) - 1; }
    Transform drawPose() {
        const SimTK::Quaternion q(
            SimTK::Vec4(drawNumber(), drawNumber(), drawNumber(), drawNumber()).normalize());
        return {Rotation(q), Vec3(drawNumber(), drawNumber(), drawNumber())};
    }

    // Markers whose z axes are at right angles.
    void addCrossed(Make make, int I, int J, const Transform& X_GM) {
        addJoint(make, mark(I, X_GM * Transform(Rotation(SimTK::Pi / 2, SimTK::XAxis))), mark(J, X_GM));
    }

    void addTreeJoint(int body) {
        const Edge& edge = m_edges[size_t(body)];
        if (edge.type == TreeJoint::Hinge) addJoint(Joint::Revolute, body, edge.parent, edge.X_GM);
        if (edge.type == TreeJoint::Sleeve) addJoint(Joint::Cylindrical, body, edge.parent, edge.X_GM);
        if (edge.type == TreeJoint::Cross) addCrossed(Joint::Universal, body, edge.parent, edge.X_GM);
    }

    void repeatTreeJoint() {
        const int body = pick(0, int(m_edges.size()) - 1);
        const Edge& edge = m_edges[size_t(body)];
        const bool isWhole = pick(0, 1);
        const Transform shifted = edge.X_GM * Transform(Vec3(0, 0, drawNumber()));  // along the axis
        switch (edge.type) {
            case TreeJoint::Hinge:
                addJoint(isWhole ? Joint::Revolute : Joint::Spherical, body, edge.parent, shifted);
                numRedundant += isWhole ? 5 : 3;
                break;
            case TreeJoint::Sleeve:
                addJoint(isWhole ? Joint::Cylindrical : Make(makePrimitive<InLine>), body, edge.parent,
                         shifted);
                numRedundant += isWhole ? 4 : 2;
                break;
            case TreeJoint::Cross:
                addCrossed(isWhole ? Joint::Universal : Make(makePrimitive<Perpendicular>), body, edge.parent,
                           edge.X_GM);
                numRedundant += isWhole ? 4 : 1;
                break;
        }
    }

    void closePath() {
        const int body = pick(0, int(m_edges.size()) - 1);
        int ancestor = body, freedoms = 0, turns = 0;
        for (int length = pick(1, 4); length > 0 && ancestor >= 0; --length) {
            Edge& edge = m_edges[size_t(ancestor)];
            const int added = edge.type == TreeJoint::Hinge ? 1 : 2;
            if (edge.isInLoop || freedoms + added > 6) break;
            edge.isInLoop = true;
            freedoms += added;
            turns += edge.type == TreeJoint::Cross ? 2 : 1;
            ancestor = edge.parent;
        }
        if (freedoms == 0) return;
        const std::pair<Make, int> kinds[] = {{makePrimitive<InPlane>, 1}, {Joint::Spherical, 3},
                                              {Joint::Cylindrical, 4},     {Joint::Revolute, 5},
                                              {Joint::Fixed, 6},           {makePrimitive<ParallelAxes>, 2}};
        const auto& [make, equations] = kinds[pick(0, 5)];
        if (equations == 2 && turns == 1) return;  // PARALLEL_AXES asks for more turns than there are
        addJoint(make, body, ancestor, drawPose());
        numRedundant += std::max(0, equations - freedoms);
        numLost += std::min(equations, freedoms);
    }

    std::mt19937 m_generator;
    std::vector<Edge> m_edges;
};

TEST(RandomMechanisms, AllTwoHundredAreJudgedRight) {
    int withRedundancy = 0, rigid = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        RandomMechanism mechanism(seed);
        const SimTK::State state = mechanism.draw();
        const ConstraintReport report = analyzeConstraints(mechanism.matter, state);
        ASSERT_EQ(report.getNumRedundant(), mechanism.numRedundant);
        EXPECT_EQ(int(report.redundant.size()), mechanism.numRedundant);
        EXPECT_FALSE(report.isSingularPosition());
        EXPECT_EQ(countFreedoms(mechanism.matter, state).rank, report.rank);
        EXPECT_EQ(ReportChecker(mechanism.matter, state).findContradiction(report), "");
        // Later elements are the redundant ones.
        for (const RedundantEquation& r : report.redundant) {
            const std::string& element = report.equations[size_t(r.equation)].element;
            const int joint = std::stoi(element.substr(element.find('/') + 1));
            EXPECT_GT(joint, mechanism.numTreeJoints);
        }
        withRedundancy += mechanism.numRedundant > 0;
        rigid += report.getDegreesOfFreedom() == 0;
    }
    EXPECT_GT(withRedundancy, 100);
    EXPECT_LT(withRedundancy, 200);
    EXPECT_GT(rigid, 5);
}

// The checker can say no: reports spoiled in every way that matters.
TEST(RandomMechanisms, SpoiledReportsAreRejected) {
    RandomMechanism mechanism(7);
    const SimTK::State state = mechanism.draw();
    const ReportChecker checker(mechanism.matter, state);
    const ConstraintReport report = analyzeConstraints(mechanism.matter, state);
    ASSERT_FALSE(report.redundant.empty());
    ASSERT_EQ(checker.findContradiction(report), "");

    ConstraintReport otherRank = report;
    --otherRank.rank;
    EXPECT_EQ(checker.findContradiction(otherRank), "the rank is another");
    ConstraintReport forgotten = report;
    forgotten.redundant.pop_back();
    EXPECT_EQ(checker.findContradiction(forgotten), "not as many are redundant");
    ConstraintReport lessThanNeeded = report;
    lessThanNeeded.redundant.back().dependsOn.pop_back();
    EXPECT_NE(checker.findContradiction(lessThanNeeded).find("does not follow"), std::string::npos);
    ConstraintReport moreThanNeeded = report;
    std::vector<int>& on = moreThanNeeded.redundant.back().dependsOn;
    int unrelated = 0;
    while (std::count(on.begin(), on.end(), unrelated)) ++unrelated;
    on.push_back(unrelated);
    EXPECT_NE(checker.findContradiction(moreThanNeeded).find("follows from less"), std::string::npos);
    // Rows in another order than the names.
    ConstraintReport shuffled = report;
    std::rotate(shuffled.equations.begin(), shuffled.equations.begin() + 1, shuffled.equations.end());
    EXPECT_NE(checker.findContradiction(shuffled), "");
}

}  // namespace
}  // namespace jprim
