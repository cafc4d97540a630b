// SPDX-License-Identifier: Apache-2.0
// What whole turns of its angles add to an expression, found from its operations.
#include <gtest/gtest.h>

#include <cmath>

#include "expression/compiling.h"

namespace jprim {
namespace {

using testing::Expression;

using SimTK::Pi;

constexpr double Rounding = 1e-14;

struct PeriodCase {
    const char* text;
    double turns;  // the period divided by 2 pi; 0 if there is none
};

std::ostream& operator<<(std::ostream& out, const PeriodCase& c) {
    return out << c.text;
}

class TurnPeriod : public ::testing::TestWithParam<PeriodCase> {};

TEST_P(TurnPeriod, IsTheGreatestCommonDivisorOfConstantFactors) {
    const Expression expression(GetParam().text);
    EXPECT_NEAR(expression.getProgram().findTurnPeriod(), 2 * Pi * GetParam().turns, Rounding);
}

INSTANTIATE_TEST_SUITE_P(
    Expressions, TurnPeriod,
    ::testing::Values(
        PeriodCase{"Q1", 0}, PeriodCase{"TURN(Q1,Q2)", 1}, PeriodCase{"Q3-0.016*TURN(Q1,Q2)", 0.016},
        PeriodCase{"-(Q3+TURN(Q1,Q2))/(-4)", 0.25}, PeriodCase{"2*TURN(Q1,Q2)*TIME", 0},
        PeriodCase{"SIN(TURN(Q1,Q2))", 0}, PeriodCase{"Q3/TURN(Q1,Q2)", 0},
        PeriodCase{"[TURN(Q1,Q2),0,0]*[1,0,0]", 0}, PeriodCase{"TURN(Q1,Q2)+TURN(Q1,Q2)**2", 0},
        PeriodCase{"TURN(Q1,Q2)-2*TURN(Q3,Q2)", 1}, PeriodCase{"TURN(Q1,Q2)-2.5*TURN(Q3,Q2)", 0.5},
        PeriodCase{"20*TURN(Q1,Q2)+35*TURN(Q3,Q2)", 5},
        PeriodCase{"6*TURN(Q1,Q2)-10*TURN(Q3,Q2)+15*TURN(Q2,Q1)", 1},
        PeriodCase{"199*TURN(Q1,Q2)+TURN(Q3,Q2)", 1}, PeriodCase{"201*TURN(Q1,Q2)+TURN(Q3,Q2)", 0},
        PeriodCase{"TURN(Q1,Q2)-SQRT(2)*TURN(Q3,Q2)", 0}, PeriodCase{"TURN(Q1,Q2)-SIN(TURN(Q3,Q2))", 0}));

// The factor found is the one that turning shows.
TEST(TurnPeriod, SlopesAreThoseOfTurning) {
    Expression expression("Q3*Q1-(0.7*TURN(Q1,Q2)-3)/5-TURN(Q2,Q3)");
    ASSERT_EQ(expression.getProgram().getNumAngles(), 2);
    for (const char* q : {"Q1", "Q2", "Q3"}) expression.set(q, Taylor<double>{0.3, 0, 0});
    Evaluation& evaluation = expression.evaluation;
    const double before = evaluation.calcValue();
    for (const int k : {0, 1}) {
        evaluation.setRememberedAngle(k, 6 * Pi);
        EXPECT_NEAR(evaluation.calcValue() - before, 6 * Pi * expression.getProgram().getAngleSlope(k),
                    100 * Rounding);
        evaluation.setRememberedAngle(k, 0);
    }
    EXPECT_NEAR(expression.getProgram().getAngleSlope(0), -0.14, Rounding);
    EXPECT_EQ(expression.getProgram().getAngleSlope(1), -1);
}

}  // namespace
}  // namespace jprim
