// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_EXPRESSION_EXPRESSION_PROPERTIES_H_
#define JPRIM_TESTS_EXPRESSION_EXPRESSION_PROPERTIES_H_

#include <algorithm>
#include <cmath>
#include <string>

#include "base/text.h"
#include "expression/compiling.h"

/// @file
/// What must hold for every text whatsoever; shared by the fuzzer and by the tests.
namespace jprim::testing {

/// Inputs for any expression; the same each time, and away from zero.
inline void supplyInputs(Expression& expression) {
    Evaluation& evaluation = expression.evaluation;
    for (int i = 0; i < expression.getProgram().getNumScalarInputs(); ++i)
        evaluation.setScalarInput(i, {0.7 + 0.3 * i, -0.4, 1.1});
    for (int i = 0; i < expression.getProgram().getNumVectorInputs(); ++i)
        evaluation.setVectorInput(i, {Vec3(0.3, -1.2, 2.1), Vec3(1.4, 0.2, -0.6), Vec3(0.1, 0.8, -2)});
}

/// A scalar's value, or the sum of a vector's components.
inline Real calcSum(Expression& expression) {
    supplyInputs(expression);
    Evaluation& evaluation = expression.evaluation;
    return expression.getProgram().isVector() ? evaluation.calcVectorValue().sum() : evaluation.calcValue();
}

inline bool isSame(Real a, Real b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

/// The first property that the compiled expression breaks; empty if it keeps them all.
inline std::string findBrokenProperty(Expression& expression) {
    const Real value = calcSum(expression);
    Evaluation& evaluation = expression.evaluation;
    if (expression.getProgram().isVector())
        return isSame(evaluation.calcVectorTaylor().value.sum(), value) ? "" : "two values of a vector";
    if (!isSame(evaluation.calcTaylor().value, value)) return "two values of a scalar";
    evaluation.calcGradient();
    for (int i = 0; i < expression.getProgram().getNumScalarInputs(); ++i)
        if (!expression.getProgram().usesScalarInput(i) && evaluation.getScalarGradient(i) != 0)
            return "a gradient without influence";
    return "";
}

/// The first property that compiling breaks on this text; empty if it keeps them all.
inline std::string findBrokenProperty(const std::string& text) {
    try {
        Expression expression(text);
        const std::string broken = findBrokenProperty(expression);
        if (!broken.empty()) return broken;
        Expression upperCase(toUpperCase(text));
        if (!isSame(calcSum(upperCase), calcSum(expression))) return "upper case has another value";
        if (std::count(text.begin(), text.end(), '(') > 100 || text.size() > 1000) return "";
        Expression inBrackets("( " + text + "\n)");
        if (!isSame(calcSum(inBrackets), calcSum(expression))) return "brackets change the value";
    } catch (const ExpressionError& error) {
        if (error.offset > text.size()) return "the error lies outside the text";
        if (error.message.empty()) return "the error says nothing";
        if (std::any_of(error.message.begin(), error.message.end(),
                        [](char c) { return c < ' ' || c > '~'; }))
            return "the error is not readable";
    }
    return "";
}

}  // namespace jprim::testing

#endif
