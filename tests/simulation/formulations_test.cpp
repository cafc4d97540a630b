// SPDX-License-Identifier: Apache-2.0
// The same dataset solved by a tree of joint coordinates and by free parts with constraints: two routes that share
// neither coordinates nor, for the joints in the tree, any formula. Both must give one motion and the same
// reactions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_dataset.h"
#include "support/run_dataset.h"
#include "support/two_routes.h"

namespace jprim {
namespace {

using testing::findDifference;
using testing::isDetermined;

constexpr double End = 0.2;  // s: long enough to move by about a radian
constexpr int Steps = 4;
constexpr double Accuracy = 1e-9;
// Of both integrations together, relative to the largest value of the table.
constexpr double Agreement = 1e-6;

Results runFormulation(const std::string& text, Formulation formulation) {
    return testing::run(testing::buildOrFail(text, {formulation}), End, Steps, Accuracy).results;
}

class Formulations : public ::testing::TestWithParam<int> {};

TEST_P(Formulations, AgreeOnRandomMechanisms) {
    constexpr int PerGroup = 25;
    int compared = 0;
    for (int k = 0; compared < PerGroup && k < 10 * PerGroup; ++k) {
        const unsigned seed = unsigned(1000 * GetParam() + k);
        const std::string text = testing::RandomDataset(seed).write(1 + k % 4, k % 3);
        if (!testing::isDetermined(text)) continue;
        ++compared;
        const Results tree = runFormulation(text, Formulation::Tree);
        const Results constraints = runFormulation(text, Formulation::Constraints);
        EXPECT_LE(findDifference(tree.parts, constraints.parts), Agreement) << seed << "\n" << text;
        EXPECT_LE(findDifference(tree.reactions, constraints.reactions), Agreement) << seed << "\n" << text;
        EXPECT_LE(findDifference(tree.requests, constraints.requests), Agreement) << seed << "\n" << text;
        if (HasFailure()) return;
    }
    EXPECT_EQ(compared, PerGroup);
}

INSTANTIATE_TEST_SUITE_P(Groups, Formulations, ::testing::Range(0, 8));

// A four-bar whose parts are given some hundredths away from where they fit, one link free to turn about itself.
TEST(Formulations, AssembleTheSame) {
    const std::string text =
        "t\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nMARKER/11,QP=2,0,0\n"
        "PART/2,MASS=1,CM=20,IP=0.1,0.1,0.1,QG=0.03,0.02,-0.01,REULER=1.2,0.02,0\n"
        "MARKER/20,QP=0.5,0,0\nMARKER/21\nMARKER/22,QP=1,0,0\n"
        "PART/3,MASS=2,CM=30,IP=0.3,0.2,0.3,QG=0.3,1,0.02,REULER=0.2,0,0.03\n"
        "MARKER/30,QP=0.8,0,0\nMARKER/31\nMARKER/32,QP=2,0,0\n"
        "PART/4,MASS=1,CM=40,IP=0.1,0.2,0.2,QG=2,0,0,REULER=1.1,0,0\n"
        "MARKER/40,QP=0.5,0,0\nMARKER/41\nMARKER/42,QP=1.2,0,0\n"
        "JOINT/1,REVOLUTE,I=21,J=10\nJPRIM/2,ATPOINT,I=31,J=22\nJOINT/3,SPHERICAL,I=42,J=32\n"
        "JPRIM/5,ATPOINT,I=11,J=41\nJPRIM/6,PARALLEL_AXES,I=41,J=11\nEND\n";
    const Mechanism tree = testing::buildOrFail(text, {Formulation::Tree});
    const Mechanism constraints = testing::buildOrFail(text, {Formulation::Constraints});
    const AssembledState a = assemble(tree), b = assemble(constraints);
    EXPECT_LT(std::max(a.after.length, a.after.angle), AssemblyTolerance);
    EXPECT_GT(a.before.length, 0.01);
    constexpr double Found = 1e-9;  // both are found by one search
    for (size_t k = 1; k < tree.getParts().size(); ++k) {
        const SimTK::Vec3 inTree = tree.getParts()[k].body.getBodyOriginLocation(a.state);
        const SimTK::Vec3 free = constraints.getParts()[k].body.getBodyOriginLocation(b.state);
        EXPECT_LT((inTree - free).norm(), Found) << k << inTree << free;
    }
}

// The comparison can fail: one part in ten thousand more gravity in one of the two is noticed.
TEST(FormulationsMutant, SlightlyWrongGravityIsNoticed) {
    const std::string text = testing::RandomDataset(1).write(3, 0);
    Diagnostics diagnostics;
    Dataset dataset = readDataset(text, diagnostics);
    for (double& g : dataset.gravity->acceleration) g *= 1 + 1e-4;
    const Mechanism mutant = std::move(*buildMechanism(dataset, diagnostics, {Formulation::Tree}));
    const Results wrong = testing::run(mutant, End, Steps, Accuracy).results;
    const Results right = runFormulation(text, Formulation::Constraints);
    EXPECT_GT(findDifference(wrong.parts, right.parts), Agreement);
    EXPECT_GT(findDifference(wrong.reactions, right.reactions), Agreement);
}

}  // namespace
}  // namespace jprim
