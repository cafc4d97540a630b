// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_EXPRESSION_COMPILING_H_
#define JPRIM_TESTS_EXPRESSION_COMPILING_H_

#include <map>
#include <string>
#include <vector>

#include "expression/compile_expression.h"
#include "expression/evaluation.h"

namespace jprim::testing {

using SimTK::Real;
using SimTK::Vec3;

/// A vocabulary of inputs: scalars Q1 Q2 Q3, U1 U2, A1 and vectors RV, VV, of the levels position, velocity and
/// acceleration; TURN(y, x), a continuous angle; HALF(e) and TWICE, which compiles another text; SPLINE/7, one
/// curve, and SPLINE/8, a family.
class InputVocabulary : public Vocabulary {
public:
    InputVocabulary();

    std::optional<Operand> call(ProgramBuilder& builder, const Call& call) override;
    const InterpolatingSpline* findSpline(int id) override;
    std::vector<std::string> getNames() const override;

    /// The numbers of the inputs used so far, by name.
    std::map<std::string, int> inputs;

private:
    std::map<std::string, Operand> m_operands;
    std::map<int, InterpolatingSpline> m_splines;
};

/// An expression over the names of an InputVocabulary.
class Expression {
public:
    explicit Expression(const std::string& text);

    const Program& getProgram() const { return evaluation.getProgram(); }
    /// Supplies an input by name, if the expression has it.
    void set(const std::string& name, const Taylor<Real>& value);
    void set(const std::string& name, const Taylor<Vec3>& value);

    InputVocabulary vocabulary;
    Evaluation evaluation;
};

/// The value of an expression without inputs.
Real evaluate(const std::string& text);
Vec3 evaluateVector(const std::string& text);

/// `offset: message` of the ExpressionError; empty if the text compiles.
std::string findError(const std::string& text);

}  // namespace jprim::testing

#endif
