// SPDX-License-Identifier: Apache-2.0
// What a text means: precedence, numbers, blanks, vectors and names, against results worked out by hand.
#include <gtest/gtest.h>

#include "expression/compiling.h"

namespace jprim::testing {
namespace {

constexpr Real Pi = 3.14159265358979323846;

struct Case {
    const char* text;
    Real value;
};

// The numbers are chosen so that every other grouping gives another value.
TEST(ExpressionGrammar, Precedence) {
    const Case cases[] = {
        {"2+3*5", 17},   {"7-4-2", 1},      {"7-4+2", 5},          {"60/6/5", 2},        {"60/6*5", 50},
        {"2*3**2", 18},  {"2**3**2", 512},  {"(2**3)**2", 64},     {"-3**2", -9},        {"(-3)**2", 9},
        {"2**-2", 0.25}, {"-2**-2", -0.25}, {"-2**-1**4", -0.5},   {"2**-2**2", 0.0625}, {"2**+2", 4},
        {"2*-3", -6},    {"8/-2**2", -2},   {"-2*3+10", 4},        {"5- -3", 8},         {"5-+-3", 8},
        {"--3", 3},      {"+-+3", -3},      {"2*(3+(4-1))*2", 24}, {"((((7))))", 7},
    };
    for (const Case& c : cases) EXPECT_EQ(evaluate(c.text), c.value) << c.text;
}

TEST(ExpressionGrammar, Numbers) {
    const Case cases[] = {
        {"5", 5},
        {"5.", 5},
        {".5", 0.5},
        {"2.07E+005", 207000},
        {"1e4", 1e4},
        {"1E-3", 1e-3},
        {"1E3-1", 999},
        {"00012", 12},
        {"90D", Pi / 2},
        {"1.8e2d", Pi},
        {"-90D", -Pi / 2},
        {"3-180D", 3 - Pi},
        {"180D - 3", Pi - 3},
        {"180D +3", Pi + 3},
        {"180D*2", 2 * Pi},
        {"1E+308", 1e308},
        {"99999999999", 99999999999},
    };
    for (const Case& c : cases) EXPECT_EQ(evaluate(c.text), c.value) << c.text;
}

TEST(ExpressionGrammar, BlanksAndCaseMeanNothing) {
    for (const char* text :
         {"max(2,3)**2", " MAX ( 2 , 3 ) * * 2 ", "Max(\t2,\r3)*\n*2", "MAX(2,3)* *\t2", "mAx(2,3)**  2"})
        EXPECT_EQ(evaluate(text), 9) << text;
}

TEST(ExpressionGrammar, Vectors) {
    EXPECT_EQ(evaluateVector("[1, 2*3, -4]"), Vec3(1, 6, -4));
    EXPECT_EQ(evaluateVector("[1,2,3]+[5,7,11]*2"), Vec3(11, 16, 25));
    EXPECT_EQ(evaluateVector("[1,2,3]-2*[5,7,11]"), Vec3(-9, -12, -19));
    EXPECT_EQ(evaluateVector("-[1,2,3]"), Vec3(-1, -2, -3));
    EXPECT_EQ(evaluateVector("[2,4,6]/2"), Vec3(1, 2, 3));
    EXPECT_EQ(evaluate("[1,2,3]*[5,7,11]"), 52);
    EXPECT_EQ(evaluateVector("[1,2,3]%[5,7,11]"), Vec3(1, 4, -3));
    EXPECT_EQ(evaluateVector("2*[1,2,3]%[5,7,11]"), Vec3(2, 8, -6));
    EXPECT_EQ(evaluate("[1,2,3]%[5,7,11]*[2,0,1]"), -1);
    EXPECT_EQ(evaluate("[2,0,1]*([1,2,3]%[5,7,11])"), -1);
    EXPECT_EQ(evaluateVector("[1,2,3]*[5,7,11]*[1,0,2]"), Vec3(52, 0, 104));
    EXPECT_EQ(evaluateVector("UV([0,3,4])"), Vec3(0, 0.6000000000000001, 0.8));
    EXPECT_EQ(evaluateVector("UV([0,0,0])"), Vec3(0, 0, 0));
}

TEST(ExpressionGrammar, ConstantsOfTheLanguage) {
    EXPECT_EQ(evaluate("PI"), Pi);
    EXPECT_EQ(evaluate("180*DTOR"), Pi);
    EXPECT_EQ(evaluate("RTOD"), 180 / Pi);
    Expression expression("2*TIME+Q1");
    expression.set("TIME", Taylor<Real>{0.75, 1, 0});
    expression.set("Q1", Taylor<Real>{4, 0, 0});
    EXPECT_EQ(expression.evaluation.calcValue(), 5.5);
}

TEST(ExpressionGrammar, TheVocabularyIsAsked) {
    EXPECT_EQ(evaluate("half(3)+1"), 2.5);
    EXPECT_EQ(evaluate("IDS(007, 3)"), 73);
    EXPECT_EQ(evaluate("IDS( 7 ,3 )"), 73);
    Expression expression("TWICE**2 - q1");
    expression.set("Q1", Taylor<Real>{3, 0, 0});
    EXPECT_EQ(expression.evaluation.calcValue(), 33);
}

TEST(ExpressionGrammar, IfTakesTheBranchOfTheSign) {
    for (const auto& [condition, value] : {std::pair("-0.1", 2), std::pair("0", 3), std::pair("1E-9", 5)})
        EXPECT_EQ(evaluate(std::string("IF(") + condition + ": 2, 3, 5)"), value);
}

}  // namespace
}  // namespace jprim::testing
