// SPDX-License-Identifier: Apache-2.0
// What a program says of itself, what it leaves out, whole turns, and derivatives where there are none.
#include <gtest/gtest.h>

#include <cmath>

#include "expression/compiling.h"

namespace jprim::testing {
namespace {

constexpr Real Pi = 3.14159265358979323846;

TEST(ExpressionProgram, LinearityInVelocities) {
    for (const char* text :
         {"2", "Q1*Q2", "U1", "-U1/Q1+2*U2-3", "Q1**2*U1", "U1**1", "VV*RV", "VV*[1,0,0]*Q1", "UV(RV)*VV",
          "RV%VV*[0,1,0]", "[U1,2,U2]*RV", "U1*SIN(Q1)+COS(TIME)*U2", "IF(Q1:U1,0,U2)", "STEP(Q1,0,U1,1,U2)",
          "(U1+2)/SQRT(Q1)", "MAX(Q1,Q2)*U1", "AKISPL(Q1,0,7)*U1", "IF(TIME:U1,0,Q1)-U1", "TURN(Q1,Q2)*U1"})
        EXPECT_TRUE(Expression(text).getProgram().isLinearInVelocity()) << text;
    for (const char* text : {"U1*U2",
                             "U1**2",
                             "U1**Q1",
                             "2**U1",
                             "SIN(U1)",
                             "ABS(U1)",
                             "Q1/U1",
                             "U1/U1",
                             "VV*VV",
                             "VV%VV*RV",
                             "UV(VV)*RV",
                             "SQRT(VV*VV)",
                             "U1*VV*RV",
                             "IF(U1:U2,0,1)",
                             "MAX(U1,0)",
                             "STEP(U1,0,0,1,1)",
                             "STEP(Q1,0,U1*U2,1,1)",
                             "AKISPL(U1,0,7)",
                             "A1",
                             "Q1*A1",
                             "U1-U1*U2",
                             "TURN(U1,1)",
                             "MOD(U1,2)",
                             "SIGN(Q1,U1)"})
        EXPECT_FALSE(Expression(text).getProgram().isLinearInVelocity()) << text;
}

TEST(ExpressionProgram, Level) {
    EXPECT_EQ(Expression("2*PI").getProgram().getLevel(), KinematicLevel::Position);
    EXPECT_EQ(Expression("Q1+TIME").getProgram().getLevel(), KinematicLevel::Position);
    EXPECT_EQ(Expression("Q1*VV*RV").getProgram().getLevel(), KinematicLevel::Velocity);
    EXPECT_EQ(Expression("U1+0*A1").getProgram().getLevel(), KinematicLevel::Acceleration);
    EXPECT_EQ(Expression("[Q1,U1,2]").getProgram().getLevel(), KinematicLevel::Velocity);
    EXPECT_TRUE(Expression("[Q1,U1,2]").getProgram().isVector());
}

// The inputs keep their numbers when others turn out to be of no use.
TEST(ExpressionProgram, WhatTheResultDoesNotNeedIsLeftOut) {
    ProgramBuilder builder;
    const Operand a = builder.addScalarInput(KinematicLevel::Acceleration);
    const Operand t = builder.time();
    const Operand q = builder.addScalarInput(KinematicLevel::Position);
    const Operand v = builder.addVectorInput(KinematicLevel::Velocity);
    const Operand r = builder.addVectorInput(KinematicLevel::Position);
    builder.multiply(builder.continuousAngle(a, t), builder.norm(v));
    const Operand result = builder.multiply(q, builder.component(r, 1));
    EXPECT_EQ(builder.getNumScalarInputs(), 3);

    const Program program = builder.finish(result);
    EXPECT_EQ(program.getNumScalarInputs(), 3);
    EXPECT_EQ(program.getNumVectorInputs(), 2);
    EXPECT_FALSE(program.usesScalarInput(0));
    EXPECT_FALSE(program.usesScalarInput(1));
    EXPECT_TRUE(program.usesScalarInput(2));
    EXPECT_FALSE(program.usesVectorInput(0));
    EXPECT_TRUE(program.usesVectorInput(1));
    EXPECT_EQ(program.getTimeInput(), -1);
    EXPECT_EQ(program.getNumAngles(), 0);
    EXPECT_EQ(program.getLevel(), KinematicLevel::Position);
    EXPECT_EQ(builder.finish(t).getTimeInput(), 1);

    Evaluation evaluation(program);
    evaluation.setScalarInput(0, {7, 7, 7});
    evaluation.setScalarInput(2, {3, 0, 0});
    evaluation.setVectorInput(1, {Vec3(2, 5, 11), Vec3(0), Vec3(0)});
    EXPECT_EQ(evaluation.calcValue(), 15);
    evaluation.calcGradient();
    EXPECT_EQ(evaluation.getScalarGradient(0), 0);
    EXPECT_EQ(evaluation.getScalarGradient(2), 5);
    EXPECT_EQ(evaluation.getVectorGradient(0), Vec3(0));
    EXPECT_EQ(evaluation.getVectorGradient(1), Vec3(0, 3, 0));
}

TEST(ExpressionProgram, AResultMayBeAnInputOrANumber) {
    Expression input("Q1"), number("2*3");
    input.set("Q1", Taylor<Real>{4, 5, 6});
    EXPECT_EQ(input.evaluation.calcTaylor().second, 6);
    input.evaluation.calcGradient();
    EXPECT_EQ(input.evaluation.getScalarGradient(0), 1);
    EXPECT_EQ(number.evaluation.calcTaylor().value, 6);
    EXPECT_EQ(number.evaluation.calcTaylor().first, 0);
    number.evaluation.calcGradient();
}

TEST(ExpressionProgram, VectorResultsHaveDerivatives) {
    Expression expression("Q1*[1,Q1,2]");
    expression.set("Q1", Taylor<Real>{3, 2, 5});
    EXPECT_EQ(expression.evaluation.calcVectorValue(), Vec3(3, 9, 6));
    const Taylor<Vec3> result = expression.evaluation.calcVectorTaylor();
    EXPECT_EQ(result.value, Vec3(3, 9, 6));
    EXPECT_EQ(result.first, Vec3(2, 12, 4));
    EXPECT_EQ(result.second, Vec3(5, 38, 10));
}

TEST(ExpressionProgram, CopiesAreIndependent) {
    Expression expression("Q1+1");
    expression.set("Q1", Taylor<Real>{3, 0, 0});
    Evaluation copy = expression.evaluation;
    copy.setScalarInput(0, {8, 0, 0});
    EXPECT_EQ(expression.evaluation.calcValue(), 4);
    EXPECT_EQ(copy.calcValue(), 9);
}

// Remembered after each step, an angle counts whole turns; forgotten, it is folded.
TEST(ExpressionAngle, WholeTurnsAreCounted) {
    Expression expression("2*TURN(SIN(Q1),COS(Q1))");
    EXPECT_EQ(expression.getProgram().getNumAngles(), 1);
    constexpr Real tolerance = 1e-14;  // a few roundings of an angle of up to 40
    Evaluation& evaluation = expression.evaluation;
    for (const int direction : {1, -1}) {
        evaluation.setRememberedAngle(0, 0);
        for (int step = 1; step <= 15; ++step) {
            const Real angle = direction * 2.7 * step;  // not quite half a turn
            expression.set("Q1", Taylor<Real>{angle, 0.5, 0.25});
            const Taylor<Real> result = evaluation.calcTaylor();
            EXPECT_NEAR(result.value, 2 * angle, 2 * tolerance * std::abs(angle));
            EXPECT_NEAR(result.first, 1, 1e-15);
            EXPECT_NEAR(result.second, 0.5, 1e-15);
            EXPECT_NEAR(evaluation.getAngle(0), angle, tolerance * std::abs(angle));
            EXPECT_EQ(evaluation.calcValue(), result.value);
            evaluation.setRememberedAngle(0, evaluation.getAngle(0));
        }
    }
    evaluation.setRememberedAngle(0, 0);
    EXPECT_NEAR(evaluation.calcValue(), 2 * std::remainder(-2.7 * 15, 2 * Pi), 1e-13);
}

TEST(ExpressionAngle, AnglesAreRememberedApart) {
    Expression expression("TURN(Q1,-1)+10*TURN(Q2,-1)");
    ASSERT_EQ(expression.getProgram().getNumAngles(), 2);
    Evaluation& evaluation = expression.evaluation;
    expression.set("Q1", Taylor<Real>{1, 0, 0});
    expression.set("Q2", Taylor<Real>{-1, 0, 0});
    evaluation.setRememberedAngle(0, 2 * Pi);
    evaluation.setRememberedAngle(1, 3);
    EXPECT_NEAR(evaluation.calcValue(), 0.75 * Pi + 2 * Pi + 10 * 1.25 * Pi, 1e-13);
    EXPECT_NEAR(evaluation.getAngle(0), 2.75 * Pi, 1e-14);
    EXPECT_NEAR(evaluation.getAngle(1), 1.25 * Pi, 1e-14);
}

struct SingularCase {
    const char* text;
    Real value, first;
};

// At q = 0, q' = 2. An infinite slope, a bend, a branch without a value: the derivatives stay finite.
TEST(ExpressionSingular, DerivativesThatDoNotExistAreFinite) {
    const SingularCase cases[] = {
        {"ABS(Q1)", 0, 0},
        {"SQRT(Q1)", 0, 0},
        {"Q1**0.5", 0, 0},
        {"Q1**1.5", 0, 0},
        {"Q1**1", 0, 2},
        {"Q1**Q2", 0, 2},  // q2 = 1
        {"0**(Q1+1)", 0, 0},
        {"ACOS(1+Q1)", 0, 0},
        {"ASIN(1-Q1)", Pi / 2, 0},
        {"MAX(Q1,3*Q1)", 0, 2},
        {"MIN(Q1,3*Q1)", 0, 2},
        {"DIM(Q1,0)", 0, 0},
        {"ATAN2(Q1,3*Q1)", 0, 0},
        {"TURN(Q1,3*Q1)", 0, 0},
        {"SQRT([Q1,Q1,0]*[Q1,Q1,0])", 0, 0},
        {"UV([Q1,Q1,0])*[1,1,0]", 0, 0},
        {"IF(Q1:1/Q1,Q1,LOG(Q1))", 0, 2},
        {"IF(Q1-1:Q1,1/Q1,1/Q1)", 0, 2},
        {"IF(Q1-1:5+Q1,SQRT(Q1-1),LOG(Q1))", 5, 2},
        {"MAX(1+Q1,SQRT(Q1))", 1, 2},
        {"STEP(Q1,0,3,1,5)", 3, 0},
        {"STEP(Q1,-1,3,0,5)", 5, 0},
        {"STEP(Q1,Q2,3,Q2,5)", 3, 0},  // q2 = 1: corners that fall together make a jump
        {"IMPACT(Q1,5,0,100,1.5,3,0.1)", 0, 0},
        {"IMPACT(Q1,5,1,100,1.5,3,0)", 85, -300},
        {"AINT(Q1)", 0, 0},
        {"MOD(Q1,2)", 0, 2},
        {"SIGN(3,Q1)", 3, 0},
    };
    for (const SingularCase& c : cases) {
        Expression expression(c.text);
        expression.set("Q1", Taylor<Real>{0, 2, 0.7});
        expression.set("Q2", Taylor<Real>{1, 0, 0});
        const Taylor<Real> result = expression.evaluation.calcTaylor();
        EXPECT_DOUBLE_EQ(result.value, c.value) << c.text;
        EXPECT_DOUBLE_EQ(result.first, c.first) << c.text;
        EXPECT_TRUE(std::isfinite(result.second)) << c.text << " " << result.second;
        expression.evaluation.calcGradient();
        EXPECT_DOUBLE_EQ(expression.evaluation.getScalarGradient(expression.vocabulary.inputs.at("Q1")),
                         c.first / 2)
            << c.text;
    }
}

TEST(ExpressionSingular, NoValueIsNotHidden) {
    for (const char* text : {"LOG(Q1)", "SQRT(Q1)", "IF(LOG(Q1):1,2,3)", "MAX(LOG(Q1),1)", "Q1**0.5"}) {
        Expression expression(text);
        expression.set("Q1", Taylor<Real>{-1, 0, 0});
        EXPECT_TRUE(std::isnan(expression.evaluation.calcValue())) << text;
    }
}

}  // namespace
}  // namespace jprim::testing
