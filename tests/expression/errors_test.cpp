// SPDX-License-Identifier: Apache-2.0
// Each mistake is reported where it stands.
#include <gtest/gtest.h>

#include <ctime>

#include "expression/compiling.h"

namespace jprim::testing {
namespace {

struct Case {
    const char* text;
    const char* error;
};

void expectErrors(std::initializer_list<Case> cases) {
    for (const Case& c : cases) EXPECT_EQ(findError(c.text), c.error) << c.text;
}

TEST(ExpressionErrors, Values) {
    expectErrors({
        {"", "0: the expression is empty"},
        {" \t ", "0: the expression is empty"},
        {"2+", "2: a value is missing at the end of the expression"},
        {"2**", "3: a value is missing at the end of the expression"},
        {"-", "1: a value is missing at the end of the expression"},
        {"2*/3", "2: a value is missing before '/'"},
        {"2** *3", "4: a value is missing before '*'"},
        {"()", "1: a value is missing before ')'"},
        {"MAX(1,)", "6: a value is missing before ')'"},
        {"MAX(,1)", "4: a value is missing before ','"},
        {"[1,,2]", "3: a value is missing before ','"},
        {"2 3", "2: an operator is missing before '3'"},
        {"2 PI", "2: an operator is missing before 'PI'"},
        {"(2)(3)", "3: an operator is missing before '('"},
        {"2[1,2,3]", "1: an operator is missing before '['"},
        {"(2 3)", "3: an operator is missing before '3'"},
    });
}

TEST(ExpressionErrors, BracketsAndSeparators) {
    expectErrors({
        {"(2+3", "0: '(' is not closed"},
        {"2*MAX(2,3", "5: '(' is not closed"},
        {"1+[1,2,3", "2: '[' is not closed"},
        {"2+3)", "3: ')' closes no bracket"},
        {"2]", "1: ']' closes no bracket"},
        {"(2]", "2: ']' cannot close '('"},
        {"[1,2,3)", "6: ')' cannot close '['"},
        {"[1,2]", "0: a vector has three components: [x, y, z]"},
        {"[1,2,3,4]", "0: a vector has three components: [x, y, z]"},
        {"2,3", "1: ',' stands only between arguments and between components"},
        {"(2,3)", "2: ',' stands only between arguments and between components"},
        {"MAX(1:2)", "5: ':' stands only after the first argument of IF"},
        {"IF(1:2:3:4)", "6: ':' stands only after the first argument of IF"},
        {"IF(1,2,3,4)", "4: IF has a colon here: IF(e: a, b, c)"},
    });
}

TEST(ExpressionErrors, CharactersAndNumbers) {
    expectErrors({
        {"2^3", "1: '^' has no meaning here; a power is written **"},
        {"2 # 3", "2: '#' has no meaning in an expression"},
        {"a\xe4", "1: '?' has no meaning in an expression"},
        {"2=3", "1: '=' has no meaning in an expression"},
        {"_A", "0: '_' has no meaning in an expression"},
        {"1+1e400", "2: '1e400' is out of range; a number's size is 1E-307 to 1E+308"},
        {"1e-400", "0: '1e-400' is out of range; a number's size is 1E-307 to 1E+308"},
        {"1.2.3", "0: '1.2.3' is not a number; write it like 1.5 or 1.5E3"},
        {".", "0: '.' is not a number; write it like 1.5 or 1.5E3"},
        {"2X", "0: '2X' is not a number; write it like 1.5 or 1.5E3"},
        {"0x10", "0: '0x10' is not a number; write it like 1.5 or 1.5E3"},
        {"1E", "0: '1E' is not a number; write it like 1.5 or 1.5E3"},
        {"2E+X", "0: '2E' is not a number; write it like 1.5 or 1.5E3"},
        {"4*1.0D+3",
         "2: '1.0D+3' may be degrees or an exponent; write a blank behind the D of degrees, or E for an "
         "exponent"},
        {"1.0D3", "0: '1.0D3' has a D exponent; write E instead, for example 1.0E+3"},
        {"NAN", "0: unknown name 'NAN'; did you mean TAN?"},
        {"INF", "0: unknown name 'INF'; did you mean IF?"},
    });
    EXPECT_EQ(findError(std::string("2+\0", 3)), "2: '?' has no meaning in an expression");
}

TEST(ExpressionErrors, Names) {
    expectErrors({
        {"2+SINN(1)", "2: unknown function 'SINN'; did you mean SIN?"},
        {"hal(1)", "0: unknown function 'HAL'; did you mean HALF?"},
        {"TIM", "0: unknown name 'TIM'; did you mean TIME?"},
        {"QQQQQQ(1)", "0: unknown function 'QQQQQQ'"},
        {"SWEEP(1,2,3)", "0: SWEEP is not supported"},
        {"1+MODE", "2: MODE is not supported"},
        {"FRICTION()", "0: FRICTION is not supported"},
    });
    for (const char* name :
         {"ARYVAL",  "BEAM",   "CONTACT", "CURVE",  "CVCV",   "DELAY",   "DIF",       "DIF1",
          "FIELD",   "FXFREQ", "FXMODE",  "INTERP", "INVPSD", "NFORCE",  "PINVAL",    "POUVAL",
          "PTCV",    "SENVAL", "USER",    "MFORCE", "TIRE",   "SURFACE", "CLEARANCE", "COUPLER",
          "FE_LOAD", "UCON",   "LSE",     "GSE",    "TFSISO", "MATRIX",  "ARRAY",     "PTSF"})
        EXPECT_EQ(findError(std::string(name) + "(1)"), "0: " + std::string(name) + " is not supported");
}

TEST(ExpressionErrors, Arguments) {
    expectErrors({
        {"SIN", "0: SIN needs its arguments, in parentheses"},
        {"SIN()", "0: SIN takes 1 argument, not 0"},
        {"SIN(1,2)", "6: SIN takes 1 argument, not 2"},
        {"1+MAX(1)", "2: MAX takes 2 arguments, not 1"},
        {"MIN(1,2,3)", "8: MIN takes 2 arguments, not 3"},
        {"PI(1)", "3: PI takes no arguments, not 1"},
        {"POLY(1,2)", "0: POLY takes 3 to 33 arguments, not 2"},
        {"SHF(1,2,3)", "0: SHF takes 4 to 6 arguments, not 3"},
        {"STEP(Q1,0,0,1)", "0: STEP takes 5 arguments, not 4"},
        {"STEP(Q1,1,0,1,5)", "12: x0 and x1 of STEP must differ: STEP(x, x0, h0, x1, h1)"},
        {"STEP5(Q1,1,0,1,5)", "13: x0 and x1 of STEP5 must differ: STEP5(x, x0, h0, x1, h1)"},
        {"HAVSIN(Q1,2-1,0,1,5)", "16: x0 and x1 of HAVSIN must differ: HAVSIN(x, x0, h0, x1, h1)"},
        {"AKISPL(Q1,0,9,0)", "12: there is no SPLINE/9"},
        {"AKISPL(Q1,0,7.5,0)",
         "12: argument 3 of AKISPL must be a whole number from 0 to 2147483647, written without sign"},
        {"CUBSPL(Q1,0,-7)",
         "12: argument 3 of CUBSPL must be a whole number from 0 to 2147483647, written without sign"},
        {"IDS(2147483648,1)",
         "4: argument 1 of IDS must be a whole number from 0 to 2147483647, written without sign"},
        {"IDS((2),1)",
         "4: argument 1 of IDS must be a whole number from 0 to 2147483647, written without sign"},
        {"CUBSPL(Q1,0,7,3)", "14: the order of the derivative of CUBSPL is 0, 1 or 2, not 3"},
    });
}

TEST(ExpressionErrors, Shapes) {
    expectErrors({
        {"1+[1,2,3]", "1: '+' stands between a scalar and a vector"},
        {"RV-1", "2: '-' stands between a scalar and a vector"},
        {"1/RV", "1: a vector cannot be a divisor"},
        {"RV/RV", "2: a vector cannot be a divisor"},
        {"RV**2", "2: '**' takes scalars, not vectors"},
        {"2**RV", "1: '**' takes scalars, not vectors"},
        {"2%RV", "1: '%' is the cross product; it needs two vectors"},
        {"RV%2", "2: '%' is the cross product; it needs two vectors"},
        {"RV*VV%RV", "5: v*v%v is ambiguous; write v*(v%v)"},
        {"2*RV*VV%RV", "7: v*v%v is ambiguous; write v*(v%v)"},
        {"(RV*VV)%RV", "7: '%' is the cross product; it needs two vectors"},
        {"[1,RV,2]", "3: a component must be a scalar, not a vector"},
        {"MAX(1, RV)", "7: argument 2 of MAX must be a scalar, not a vector"},
        {"HALF(RV)", "5: argument 1 of HALF must be a scalar, not a vector"},
        {"UV(2)", "3: the argument of UV must be a vector, not a scalar"},
        {"IF(RV:1,2,3)", "3: argument 1 of IF must be a scalar, not a vector"},
    });
    EXPECT_EQ(findError("RV*(VV%RV)"), "");
    EXPECT_EQ(findError("RV%VV*RV"), "");
}

TEST(ExpressionErrors, ConstantsWithoutAValue) {
    expectErrors({
        {"2+1/0", "3: the value of '/' is not a finite number"},
        {"10**400", "2: the value of '**' is not a finite number"},
        {"1E308+1E308", "5: the value of '+' is not a finite number"},
        {"SQRT(-1)", "0: the value of 'SQRT' is not a finite number"},
        {"2*ACOS(2)", "2: the value of 'ACOS' is not a finite number"},
        {"LOG(0)", "0: the value of 'LOG' is not a finite number"},
        {"[1,2,3]/0", "7: the value of '/' is not a finite number"},
    });
    EXPECT_EQ(findError("1/Q1"), "");
}

std::string repeat(int count, const std::string& text) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

TEST(ExpressionErrors, NestingHasALimit) {
    const auto nest = [](int depth) { return repeat(depth, "(") + "1" + repeat(depth, ")"); };
    EXPECT_EQ(evaluate(nest(200)), 1);
    EXPECT_EQ(findError(nest(201)), "201: brackets and powers are nested more than 200 deep");
    EXPECT_EQ(evaluate(repeat(200, "1**") + "1"), 1);
    EXPECT_EQ(findError(repeat(201, "1**") + "1"), "603: brackets and powers are nested more than 200 deep");
    for (const char* piece : {"(", "[", "SIN(", "2**", "IF(1:", "-(", "2**-"})
        EXPECT_NE(findError(repeat(20000, piece)), "") << piece;
    // Siblings are not nested, nor are signs.
    EXPECT_EQ(evaluate(repeat(5000, "(1)+") + "1"), 5001);
    EXPECT_EQ(evaluate(repeat(30000, "-") + "1"), 1);
}

/// Of expressions that must be linear in velocities.
class LinearVocabulary : public InputVocabulary {
public:
    std::string findProblem(const ProgramBuilder& builder, Operand value) const override {
        return builder.isLinearInVelocity(value) ? "" : "not linear";
    }
};

// The first value that must not be there is found where it stands, and none where the whole is as it must be.
TEST(ExpressionErrors, AValueThatIsNotAllowedIsFoundWhereItStands) {
    const std::pair<const char*, const char*> cases[] = {
        {"U1*Q1**2+2*U2/Q2-SIN(Q1)", ""},   {"Q1+U1 *U2", "6: not linear"},
        {"2+SQRT(VV*VV)", "9: not linear"}, {"(Q1-A1)*0", "4: not linear"},
        {"U1+U2**2", "5: not linear"},      {"Q1*IF(U1: 1,2,3)", "3: not linear"}};
    for (const auto& [text, error] : cases) {
        LinearVocabulary vocabulary;
        ProgramBuilder builder;
        std::string found;
        try {
            compileExpression(text, builder, vocabulary);
        } catch (const ExpressionError& e) {
            found = std::to_string(e.offset) + ": " + e.message;
        }
        EXPECT_EQ(found, error) << text;
        EXPECT_EQ(Expression(text).getProgram().isLinearInVelocity(), found.empty()) << text;
    }
}

TEST(ExpressionErrors, LengthHasALimit) {
    EXPECT_EQ(evaluate(repeat(49999, "1+") + "12"), 50011);
    EXPECT_EQ(findError(repeat(50000, "1+") + "1"),
              "100000: the expression has 100001 characters; the most is 100000");
    EXPECT_EQ(findError("MAX(" + repeat(64, "1,") + "1)"), "132: a function takes no more than 64 arguments");
}

// Ten times the text takes about ten times as long; a quadratic parser would need a hundred.
TEST(ExpressionErrors, TimeGrowsLikeTheText) {
    for (const std::string piece : {"-", "Q1+", "MAX(Q1,2)*", "1.5-", "(Q1)+", "a", "9", "* "}) {
        const auto measure = [&](int length) {
            const std::string text = repeat(length / static_cast<int>(piece.size()), piece) + "Q1";
            double least = 1e9;  // of CPU, of three, because other processes disturb
            for (int i = 0; i < 3; ++i) {
                const std::clock_t begin = std::clock();
                findError(text);
                least = std::min(least, double(std::clock() - begin) / CLOCKS_PER_SEC);
            }
            return least;
        };
        constexpr double slack = 4, noise = 2e-3;  // [s]
        EXPECT_LT(measure(99000), 10 * slack * measure(9900) + noise) << piece;
    }
}

}  // namespace
}  // namespace jprim::testing
