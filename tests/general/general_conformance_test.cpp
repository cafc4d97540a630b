// SPDX-License-Identifier: Apache-2.0
// The identities that every constraint must satisfy off its manifold, for equations of all kinds.
#include <gtest/gtest.h>

#include "jprim/general/general_constraint.h"
#include "support/conformance.h"

namespace jprim {
namespace {

using testing::Conformance;
using testing::Tree;
using testing::expressions::DifferenceTolerance;
using testing::expressions::RoundingTolerance;

constexpr int NumSeeds = 10;
/// An equation between markers 1 and 2. Relative ones act on the two alone, with no net load.
struct Case {
    const char* name;
    const char* text;
    bool isRelative;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.text;
}

const Case Cases[] = {
    {"Distance", "DM(1,2)-0.7", true},
    {"Component", "DX(1,2,2)-0.1*TIME**2", true},
    {"ComponentInGround", "DY(1,2)+0.2*SIN(2*TIME)", false},
    {"ProductOfAxes", "UVZ(1)*UVX(2)", true},
    {"TripleProduct", "UVX(1)*(UVY(2)%UVZ(1))-0.3", true},
    {"Angle", "SIN(AZ(1,2))-0.5", true},
    {"EulerAngle", "SIN(PSI(1,2))+THETA(1,2)*COS(PHI(1,2))", true},
    {"Pitch", "PITCH(1,2)-SIN(YAW(1,2))*COS(ROLL(1,2))", true},
    {"Cam", "DM(1,2)-STEP5(AX(1,2),-1,0.5,1,0.9)", true},
    {"Screw", "DZ(1,2,2)-0.1*SIN(AZ(1,2))", true},
    {"Vectors", "[1,2,3]*(DXYZ(1,2)%UVY(1))-EXP(DX(2))", false},
    {"IncludedAngle", "INCANG(1,0,2)-1.1", false},
    {"Velocity", "VX(1,2,2,2)-0.3*COS(TIME)", true},
    {"Rolling", "VX(1)-WZ(1)*DY(1)", false},
    {"RadialVelocity", "VR(1,2)+DM(1,2)*WZ(1,2,2)", true},
};

class GeneralConformance : public ::testing::TestWithParam<std::tuple<Case, Tree>> {};

TEST_P(GeneralConformance, HoldsOffTheManifold) {
    const auto& [c, tree] = GetParam();
    const auto add = [&text = c.text](const Marker& I, const Marker& J) -> SimTK::Constraint {
        return GeneralConstraint(Expression(text, {{1, I}, {2, J}}));
    };
    for (int seed = 1; seed <= NumSeeds; ++seed) {
        SCOPED_TRACE(seed);
        const Conformance result = testing::measureConformance(add, tree, seed);
        EXPECT_LT(result.rateError, DifferenceTolerance);
        EXPECT_LT(result.accelerationError, DifferenceTolerance);
        EXPECT_LT(result.powerError, RoundingTolerance);
        EXPECT_EQ(result.equations, 1);
        if (c.isRelative) {
            EXPECT_LT(result.netLoad, RoundingTolerance);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Expressions, GeneralConformance,
                         ::testing::Combine(::testing::ValuesIn(Cases),
                                            ::testing::Values(Tree::AncestorMoves, Tree::JOnGround,
                                                              Tree::FlexibleI, Tree::FlexibleBoth)),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param).name) +
                                    testing::getName(std::get<1>(info.param));
                         });

// The suite can fail: a staircase of 10,000 steps goes along with DX, but its derivative is zero.
TEST(GeneralConformance, NoticesARateThatIsNotTheDerivative) {
    const auto add = [](const Marker& I, const Marker& J) -> SimTK::Constraint {
        return GeneralConstraint(Expression("DM(1,2)+AINT(10000*DX(1,2,2))/10000", {{1, I}, {2, J}}));
    };
    constexpr double Seen = 1e-2;
    EXPECT_GT(testing::measureConformance(add, Tree::AncestorMoves, 1).rateError, Seen);
}

}  // namespace
}  // namespace jprim
