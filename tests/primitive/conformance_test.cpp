// SPDX-License-Identifier: Apache-2.0
// The identities of section 7 of the mathematics, off the manifold, for all six primitives and joints of two; and one
// deliberately wrong primitive for each identity, which the suite must refuse.
#include "support/conformance.h"

#include <gtest/gtest.h>

#include "jprim/jprim.h"
#include "support/mutants.h"

namespace jprim {
namespace {

using SimTK::Constraint;
using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;
using testing::AddConstraint;
using testing::Conformance;
using testing::Tree;

// Differences of sixth order leave about 1e-11; velocities and angles are of order one.
constexpr double DifferenceTolerance = 1e-8;
// Both routes are a few dozen operations on numbers of order one.
constexpr double RoundingTolerance = 1e-13;
constexpr int NumSeeds = 25;

struct Member {
    const char* name;
    int equations;
    AddConstraint add;
};

std::ostream& operator<<(std::ostream& out, const Member& member) {
    return out << member.name;
}

template <class Type>
Member makeMember(const char* name, int equations) {
    return {name, equations, [](const Marker& I, const Marker& J) -> Constraint { return Type(I, J); }};
}

template <Joint (*Make)(const Marker&, const Marker&, const std::string&)>
Member makeJoint(const char* name, int equations) {
    return {name, equations,
            [](const Marker& I, const Marker& J) -> Constraint { return Make(I, J, "").getConstraint(); }};
}

template <bool Opposed>
Member makeConvel(const char* name) {
    return {name, 4, [](const Marker& I, const Marker& J) -> Constraint {
                return Joint::Convel(I, J, Opposed).getConstraint();
            }};
}

class PrimitiveConformance : public ::testing::TestWithParam<std::tuple<Member, Tree>> {};

TEST_P(PrimitiveConformance, HoldsOffTheManifold) {
    const auto& [member, tree] = GetParam();
    for (int seed = 1; seed <= NumSeeds; ++seed) {
        SCOPED_TRACE(seed);
        const Conformance c = testing::measureConformance(member.add, tree, seed);
        EXPECT_LT(c.rateError, DifferenceTolerance);
        EXPECT_LT(c.accelerationError, DifferenceTolerance);
        EXPECT_LT(c.powerError, RoundingTolerance);
        EXPECT_LT(c.netLoad, RoundingTolerance);
        EXPECT_EQ(c.equations, member.equations);
        EXPECT_EQ(c.rank, member.equations);
    }
}

std::string nameCase(const ::testing::TestParamInfo<PrimitiveConformance::ParamType>& info) {
    return std::string(std::get<0>(info.param).name) + getName(std::get<1>(info.param));
}

INSTANTIATE_TEST_SUITE_P(
    AllSix, PrimitiveConformance,
    ::testing::Combine(::testing::Values(makeMember<AtPoint>("AtPoint", 3), makeMember<InLine>("InLine", 2),
                                         makeMember<InPlane>("InPlane", 1),
                                         makeMember<Orientation>("Orientation", 3),
                                         makeMember<ParallelAxes>("ParallelAxes", 2),
                                         makeMember<Perpendicular>("Perpendicular", 1)),
                       ::testing::Values(Tree::AncestorMoves, Tree::IOnGround, Tree::JOnGround,
                                         Tree::FlexibleI, Tree::FlexibleJ, Tree::FlexibleBoth)),
    nameCase);

// Equations of two kinds in one constraint, and those that no primitive has.
INSTANTIATE_TEST_SUITE_P(
    Joints, PrimitiveConformance,
    ::testing::Combine(::testing::Values(makeJoint<Joint::Revolute>("Revolute", 5),
                                         makeJoint<Joint::Translational>("Translational", 5),
                                         makeJoint<Joint::Fixed>("Fixed", 6),
                                         makeJoint<Joint::Hooke>("Hooke", 4), makeConvel<false>("Convel"),
                                         makeConvel<true>("ConvelOpposed")),
                       ::testing::Values(Tree::AncestorMoves, Tree::FlexibleBoth)),
    nameCase);

//---------------------------------------------------------------------------------------- mutants
// The largest defect over the seeds; a mutant must show at least the one it was given.
Conformance measureWorst(testing::Defect defect) {
    Conformance worst;
    worst.rank = 3;
    for (int seed = 1; seed <= NumSeeds; ++seed) {
        const Conformance c = testing::measureConformance(
            [defect](const Marker& I, const Marker& J) -> Constraint {
                return Constraint::Custom(new testing::MutantInLine(defect, I, J));
            },
            Tree::AncestorMoves, seed);
        worst.rateError = std::max(worst.rateError, c.rateError);
        worst.accelerationError = std::max(worst.accelerationError, c.accelerationError);
        worst.powerError = std::max(worst.powerError, c.powerError);
        worst.netLoad = std::max(worst.netLoad, c.netLoad);
        worst.rank = std::min(worst.rank, c.rank);
    }
    return worst;
}

TEST(ConformanceMutants, TheUnmutatedOnePasses) {
    const Conformance c = measureWorst(testing::Defect::None);
    EXPECT_LT(c.rateError, DifferenceTolerance);
    EXPECT_LT(c.accelerationError, DifferenceTolerance);
    EXPECT_LT(c.powerError, RoundingTolerance);
    EXPECT_LT(c.netLoad, RoundingTolerance);
    EXPECT_EQ(c.rank, 2);
}

TEST(ConformanceMutants, RateMeasuredInTheAncestorIsRefused) {
    EXPECT_GT(measureWorst(testing::Defect::RateOmitsRotationOfJ).rateError, 0.01);
}

TEST(ConformanceMutants, AccelerationWithoutCoriolisTermIsRefused) {
    EXPECT_GT(measureWorst(testing::Defect::AccelerationOmitsCoriolis).accelerationError, 0.01);
}

TEST(ConformanceMutants, ForceOfWrongSizeIsRefused) {
    EXPECT_GT(measureWorst(testing::Defect::ForceTwiceTooLarge).powerError, 0.01);
}

TEST(ConformanceMutants, ForceOnJWithoutLeverIsRefused) {
    EXPECT_GT(measureWorst(testing::Defect::ForceOmitsLever).netLoad, 0.01);
}

TEST(ConformanceMutants, EquationGivenTwiceIsRefused) {
    EXPECT_LT(measureWorst(testing::Defect::SameEquationTwice).rank, 2);
}

}  // namespace
}  // namespace jprim
