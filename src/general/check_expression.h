// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_GENERAL_CHECK_EXPRESSION_H_
#define JPRIM_SRC_GENERAL_CHECK_EXPRESSION_H_

#include <string>

#include "marker/marker_expression.h"

namespace jprim {

/// What is wrong with a value in the expression of an equation, or empty.
std::string findValueProblem(KinematicLevel level, bool isLinearInVelocity);

/// What is wrong with an expression as an equation, or empty.
std::string findEquationProblem(const MarkerExpression& expression);

/// What is wrong with an expression as a function of nothing but time, or empty.
constexpr const char* NotOnlyTime = "the function must depend on nothing but TIME";
std::string findFunctionProblem(const MarkerExpression& expression);

/// The matter subsystem of all markers of an equation. @throws Error naming the element if there is none
SimTK::SimbodyMatterSubsystem& findMatter(const MarkerExpression& expression, const std::string& element);

}  // namespace jprim

#endif
