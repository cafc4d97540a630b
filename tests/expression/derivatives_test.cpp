// SPDX-License-Identifier: Apache-2.0
// Every function against its closed form, and by three routes its derivatives: along a motion of the inputs, by
// differences of values along the same motion, and as gradient times rates.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "expression/compiling.h"

namespace jprim::testing {
namespace {

constexpr Real Pi = 3.14159265358979323846;

// A smooth motion of all inputs, far from symmetric. TIME is t.
struct Motion {
    Real t;

    Taylor<Real> wave(Real mean, Real size, Real rate, Real phase) const {
        const Real angle = rate * t + phase;
        return {mean + size * std::sin(angle), size * rate * std::cos(angle),
                -size * rate * rate * std::sin(angle)};
    }
    std::map<std::string, Taylor<Real>> scalars() const {
        return {{"TIME", {t, 1, 0}},
                {"Q1", wave(0.31, 0.17, 1.3, 0.4)},  // within 0.14 .. 0.48
                {"Q2", wave(1.9, 0.41, 0.7, 1.1)},   // within 1.49 .. 2.31
                {"Q3", wave(-0.7, 0.23, 1.9, 2.3)},  // within -0.93 .. -0.47
                {"U1", wave(0.21, 0.6, 1.1, 0.2)},
                {"U2", wave(-0.4, 0.9, 0.8, 1.7)},
                {"A1", wave(0.9, 0.3, 1.7, 0.9)}};
    }
    std::map<std::string, Taylor<Vec3>> vectors() const {
        const auto pack = [](const Taylor<Real>& x, const Taylor<Real>& y, const Taylor<Real>& z) {
            return Taylor<Vec3>{
                {x.value, y.value, z.value}, {x.first, y.first, z.first}, {x.second, y.second, z.second}};
        };
        return {{"RV", pack(wave(1.1, 0.4, 1.2, 0.1), wave(-0.6, 0.3, 0.9, 1.3), wave(0.8, 0.5, 1.4, 2.2))},
                {"VV", pack(wave(0.2, 0.7, 1.1, 0.6), wave(0.9, 0.2, 1.6, 0.8), wave(-1.3, 0.4, 0.7, 1.9))}};
    }
};

void move(Expression& expression, const Motion& motion) {
    for (const auto& [name, value] : motion.scalars()) expression.set(name, value);
    for (const auto& [name, value] : motion.vectors()) expression.set(name, value);
}

// df/dt at t by central differences of two steps, whose errors of fourth order cancel.
Real differentiate(const std::function<Real(Real)>& f, Real t) {
    const auto slope = [&](Real h) { return (f(t + h) - f(t - h)) / (2 * h); };
    constexpr Real h = 2e-3;
    return (4 * slope(h / 2) - slope(h)) / 3;
}

// Truncation h^4/30 f''''' and rounding eps/h, both about 1e-12, for functions with derivatives up to 100.
constexpr Real DifferenceTolerance = 1e-9;
// The same sums in another order.
constexpr Real RoundingTolerance = 1e-13;

void expectNear(Real a, Real b, Real tolerance, const std::string& what) {
    EXPECT_NEAR(a, b, tolerance * (1 + std::abs(b))) << what;
}

// Gradient times rates, over all inputs.
Real calcRate(const Expression& expression, const Motion& motion) {
    const Evaluation& evaluation = expression.evaluation;
    const auto scalars = motion.scalars();
    const auto vectors = motion.vectors();
    Real rate = 0;
    for (const auto& [name, input] : expression.vocabulary.inputs)
        if (vectors.count(name))
            rate += SimTK::dot(evaluation.getVectorGradient(input), vectors.at(name).first);
        else
            rate += evaluation.getScalarGradient(input) * scalars.at(name).first;
    const int time = expression.getProgram().getTimeInput();
    return time < 0 ? rate : rate + evaluation.getScalarGradient(time);
}

void checkDerivatives(const std::string& text, Real t) {
    Expression expression(text);
    const auto calcAt = [&](Real at) {
        move(expression, {at});
        return expression.evaluation.calcTaylor();
    };
    const auto calcValueAt = [&](Real at) {
        move(expression, {at});
        return expression.evaluation.calcValue();
    };
    const Taylor<Real> result = calcAt(t);
    ASSERT_TRUE(std::isfinite(result.value)) << text;
    const Real first = differentiate(calcValueAt, t);
    const Real second = differentiate([&](Real at) { return calcAt(at).first; }, t);
    expectNear(result.first, first, DifferenceTolerance, text + ", first derivative");
    expectNear(result.second, second, DifferenceTolerance, text + ", second derivative");

    EXPECT_EQ(calcValueAt(t), result.value) << text;
    expression.evaluation.calcGradient();
    expectNear(calcRate(expression, {t}), result.first, RoundingTolerance, text + ", gradient");
}

struct Case {
    const char* text;
    std::function<Real(Real q1, Real q2, Real q3)> formula;
};

Real step(Real s) {
    return s * s * (3 - 2 * s);
}

const std::vector<Case>& getCases() {
    static const std::vector<Case> cases = {
        {"Q1+Q2-Q3", [](Real a, Real b, Real c) { return a + b - c; }},
        {"-Q1*Q2/Q3", [](Real a, Real b, Real c) { return -a * b / c; }},
        {"Q1**Q2", [](Real a, Real b, Real) { return std::pow(a, b); }},
        {"Q1**2.5", [](Real a, Real, Real) { return std::pow(a, 2.5); }},
        {"Q3**2", [](Real, Real, Real c) { return c * c; }},
        {"Q3**3", [](Real, Real, Real c) { return c * c * c; }},
        {"Q3**-1", [](Real, Real, Real c) { return 1 / c; }},
        {"3**Q3", [](Real, Real, Real c) { return std::pow(3, c); }},
        {"ABS(Q3)", [](Real, Real, Real c) { return -c; }},
        {"ACOS(Q1)", [](Real a, Real, Real) { return std::acos(a); }},
        {"AINT(9*Q3)*Q1", [](Real a, Real, Real c) { return a * std::ceil(9 * c); }},
        {"ANINT(5*Q3)*Q1", [](Real a, Real, Real c) { return a * std::floor(5 * c + 0.5); }},
        {"ASIN(Q3)", [](Real, Real, Real c) { return std::asin(c); }},
        {"ATAN(Q2)", [](Real, Real b, Real) { return std::atan(b); }},
        {"ATAN2(Q3,-Q2)", [](Real, Real b, Real c) { return std::atan(c / -b) - Pi; }},
        {"COS(Q2)", [](Real, Real b, Real) { return std::sin(b + Pi / 2); }},
        {"COSH(Q2)", [](Real, Real b, Real) { return (std::exp(b) + std::exp(-b)) / 2; }},
        {"DIM(Q2,Q1)", [](Real a, Real b, Real) { return b - a; }},
        {"DIM(Q1,Q2)+Q3", [](Real, Real, Real c) { return c; }},
        {"EXP(Q3)", [](Real, Real, Real c) { return std::exp(c); }},
        {"LOG(Q2)", [](Real, Real b, Real) { return std::log(b); }},
        {"LOG10(Q2)", [](Real, Real b, Real) { return std::log(b) / std::log(10); }},
        {"MAX(Q1,Q2)", [](Real, Real b, Real) { return b; }},
        {"MAX(Q1,Q3)", [](Real a, Real, Real) { return a; }},
        {"MIN(Q1,Q2)", [](Real a, Real, Real) { return a; }},
        {"MIN(Q1,Q3)", [](Real, Real, Real c) { return c; }},
        {"MOD(5*Q2,Q1)", [](Real a, Real b, Real) { return 5 * b - a * std::floor(5 * b / a); }},
        {"MOD(7*Q3,Q1)", [](Real a, Real, Real c) { return 7 * c - a * std::ceil(7 * c / a); }},
        {"SIGN(Q2,Q3)", [](Real, Real b, Real) { return -b; }},
        {"SIGN(Q3,Q2)", [](Real, Real, Real c) { return -c; }},
        {"SIN(Q2)", [](Real, Real b, Real) { return std::sin(b); }},
        {"SINH(Q3)", [](Real, Real, Real c) { return (std::exp(c) - std::exp(-c)) / 2; }},
        {"SQRT(Q2)", [](Real, Real b, Real) { return std::sqrt(b); }},
        {"TAN(Q3)", [](Real, Real, Real c) { return std::sin(c) / std::cos(c); }},
        {"TANH(Q3)", [](Real, Real, Real c) { return 1 - 2 / (std::exp(2 * c) + 1); }},
        {"STEP(Q1,0.1,2,0.6,-3)", [](Real a, Real, Real) { return 2 - 5 * step((a - 0.1) / 0.5); }},
        {"STEP(Q1,0.6,-3,0.1,2)", [](Real a, Real, Real) { return 2 - 5 * step((a - 0.1) / 0.5); }},
        {"STEP(Q2,0.1,2,0.6,-3)+Q1", [](Real a, Real, Real) { return a - 3; }},
        {"STEP(Q3,0.1,Q2,0.6,-3)", [](Real, Real b, Real) { return b; }},
        {"STEP5(Q1,0.1,2,0.6,Q2)",
         [](Real a, Real b, Real) {
             const Real s = (a - 0.1) / 0.5;
             return 2 + (b - 2) * (10 * std::pow(s, 3) - 15 * std::pow(s, 4) + 6 * std::pow(s, 5));
         }},
        {"HAVSIN(Q1,0.1,2,0.6,-3)",
         [](Real a, Real, Real) { return -0.5 - 2.5 * std::sin(Pi * (a - 0.1) / 0.5 - Pi / 2); }},
        {"IF(Q1:Q2,1,Q3)", [](Real, Real, Real c) { return c; }},
        {"IF(Q3:Q2,1,Q1)", [](Real, Real b, Real) { return b; }},
        {"IMPACT(Q1,Q3,2,40,1.5,3,0.9)",  // deep: full damping
         [](Real a, Real, Real c) { return 40 * std::pow(2 - a, 1.5) - 3 * c; }},
        {"IMPACT(Q1,Q3,2,40,1.5,3,3)",  // the damping grows
         [](Real a, Real, Real c) { return 40 * std::pow(2 - a, 1.5) - c * 3 * step((2 - a) / 3); }},
        {"IMPACT(Q1,Q2,2,0.1,1.5,30,3)+Q3", [](Real, Real, Real c) { return c; }},  // never pulls
        {"IMPACT(Q2,Q3,0.1,40,1.5,3,2)+Q1", [](Real a, Real, Real) { return a; }},  // no contact
        {"BISTOP(Q1,Q3,2,5,40,1.5,3,3)",
         [](Real a, Real, Real c) { return 40 * std::pow(2 - a, 1.5) - c * 3 * step((2 - a) / 3); }},
        {"BISTOP(Q2,Q1,-1,1,40,1.5,3,2)",
         [](Real a, Real b, Real) { return -40 * std::pow(b - 1, 1.5) - a * 3 * step((b - 1) / 2); }},
        {"BISTOP(Q2,Q3,-1,1,0.1,1.5,30,2)+Q1", [](Real a, Real, Real) { return a; }},
        {"BISTOP(Q2,Q3,1,5,40,1.5,3,2)+Q1", [](Real a, Real, Real) { return a; }},
        {"POLY(Q2,Q1,3,-2,5,0.5)",
         [](Real a, Real b, Real) {
             const Real u = b - a;
             return 3 - 2 * u + 5 * u * u + 0.5 * u * u * u;
         }},
        {"POLY(Q2,Q1,Q3)", [](Real, Real, Real c) { return c; }},
        {"CHEBY(Q1,-0.2,3,-2,5,0.5,0.7)",
         [](Real a, Real, Real) {
             const Real angle = std::acos(a + 0.2);
             return 3 - 2 * std::cos(angle) + 5 * std::cos(2 * angle) + 0.5 * std::cos(3 * angle) +
                    0.7 * std::cos(4 * angle);
         }},
        {"SHF(Q2,Q1,3,2,0.4,5)",
         [](Real a, Real b, Real) { return 3 * std::sin(2 * (b - a) - 0.4) + 5; }},
        {"SHF(Q2,Q1,3,2)", [](Real a, Real b, Real) { return 3 * std::sin(2 * (b - a)); }},
        {"FORCOS(Q2,Q1,2,3,0.4,-5)",
         [](Real a, Real b, Real) { return 3 + 0.4 * std::cos(2 * (b - a)) - 5 * std::cos(4 * (b - a)); }},
        {"FORSIN(Q2,Q1,2,3,0.4,-5)",
         [](Real a, Real b, Real) { return 3 + 0.4 * std::sin(2 * (b - a)) - 5 * std::sin(4 * (b - a)); }},
        {"TURN(Q3,-Q2)", [](Real, Real b, Real c) { return std::atan(c / -b) - Pi; }},
        {"[Q1,2,Q3]*[Q2,Q1,5]", [](Real a, Real b, Real c) { return a * b + 2 * a + 5 * c; }},
        {"[Q1,2,Q3]%[Q2,Q1,5]*[0,1,0]", [](Real a, Real b, Real c) { return c * b - a * 5; }},
        {"UV([Q1,2,Q3])*[0,0,1]",
         [](Real a, Real, Real c) { return c / std::sqrt(a * a + 4 + c * c); }},
    };
    return cases;
}

TEST(ExpressionDerivatives, ValuesAgreeWithClosedForms) {
    for (const Case& c : getCases())
        for (const Real t : {0.2, 1.7}) {
            Expression expression(c.text);
            move(expression, {t});
            const auto q = Motion{t}.scalars();
            expectNear(expression.evaluation.calcValue(),
                       c.formula(q.at("Q1").value, q.at("Q2").value, q.at("Q3").value), RoundingTolerance,
                       c.text);
        }
}

TEST(ExpressionDerivatives, ThreeRoutesAgreeForEachFunction) {
    for (const Case& c : getCases())
        for (const Real t : {0.2, 1.7}) checkDerivatives(c.text, t);
}

TEST(ExpressionDerivatives, ThreeRoutesAgreeForWholeExpressions) {
    for (const char* text :
         {"SIN(2*TIME)*Q1-Q2**2/(1+U1**2)", "UV(RV)*VV-(RV%VV)*[1,Q1,-2]*A1",
          "SQRT(RV*RV)-2-0.1*STEP(TIME,0,0,3,1)", "RV%(VV%(2*RV-VV/Q2))*VV+TIME",
          "IMPACT(SQRT(RV*RV),UV(RV)*VV,2,1E2,2.2,10,0.1)", "IF(Q3+0.7:U1*Q1,0,U2/Q2)*[1,2,3]*(-RV)",
          "AKISPL(3*Q1,0,7)*U1+CUBSPL(Q2,0,7,1)", "AKISPL(Q2,1.3+Q1,8,0)+CUBSPL(Q3,Q2,8,0)",
          "AKISPL(Q3,1.3+Q1,8,1)*CUBSPL(Q2,Q2,8,2)", "AKISPL(-9+Q1,Q2,8)+CUBSPL(9+Q1,Q2,8,1)+Q3",
          "TURN(RV*VV,SQRT(RV%VV*(RV%VV)))"})
        for (const Real t : {0.15, 1.75}) checkDerivatives(text, t);
}

// The check can fail: AINT by its definition has a derivative of zero, which these differences do not.
TEST(ExpressionDerivatives, AWrongDerivativeIsNoticed) {
    Expression expression("AINT(1E6*Q1)/1E6");
    move(expression, {0.2});
    const Real first = differentiate(
        [&](Real at) {
            move(expression, {at});
            return expression.evaluation.calcValue();
        },
        0.2);
    EXPECT_GT(std::abs(expression.evaluation.calcTaylor().first - first), 1e3 * DifferenceTolerance);
}

}  // namespace
}  // namespace jprim::testing
