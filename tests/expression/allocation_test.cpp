// SPDX-License-Identifier: Apache-2.0
// Evaluating takes no memory.
#include <gtest/gtest.h>

#include "expression/compiling.h"
#include "support/allocations.h"

namespace jprim::testing {
namespace {

TEST(ExpressionEvaluation, TakesNoMemory) {
    Expression expression(
        "UV(RV%VV)*[Q1,2,3]*STEP(TIME,0,1,2,3)**1.5+AKISPL(Q1,Q2,8,1)*TURN(Q1,Q2)-IMPACT(Q1,U1,2,1E3,1.5,2,0.1)");
    Evaluation& evaluation = expression.evaluation;
    const Taylor<Vec3> r{Vec3(1, 2, 4), Vec3(1), Vec3(2)}, v{Vec3(2, -1, 3), Vec3(2), Vec3(1)};
    const int rInput = expression.vocabulary.inputs.at("RV"), vInput = expression.vocabulary.inputs.at("VV");

    const int before = getNumAllocations();
    evaluation.setVectorInput(rInput, r);
    evaluation.setVectorInput(vInput, v);
    for (int i = 0; i < expression.getProgram().getNumScalarInputs(); ++i)
        evaluation.setScalarInput(i, {0.5 + i, 1, 2});
    evaluation.setRememberedAngle(0, 7);
    const Real value = evaluation.calcValue();
    const Taylor<Real> taylor = evaluation.calcTaylor();
    evaluation.calcGradient();
    const Vec3 gradient = evaluation.getVectorGradient(rInput);
    const int after = getNumAllocations();

    EXPECT_EQ(after, before);
    EXPECT_EQ(value, taylor.value);
    EXPECT_GT(gradient.norm(), 0);
    const Evaluation copy = evaluation;  // the counter counts
    EXPECT_GT(getNumAllocations(), after);
}

}  // namespace
}  // namespace jprim::testing
