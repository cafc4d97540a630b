// SPDX-License-Identifier: Apache-2.0
#include "expression/compiling.h"

namespace jprim::testing {
namespace {

struct Input {
    const char* name;
    bool isVector;
    KinematicLevel level;
};

const Input Inputs[] = {
    {"Q1", false, KinematicLevel::Position}, {"Q2", false, KinematicLevel::Position},
    {"Q3", false, KinematicLevel::Position}, {"U1", false, KinematicLevel::Velocity},
    {"U2", false, KinematicLevel::Velocity}, {"A1", false, KinematicLevel::Acceleration},
    {"RV", true, KinematicLevel::Position},  {"VV", true, KinematicLevel::Velocity},
};

Program compile(const std::string& text, InputVocabulary& vocabulary) {
    ProgramBuilder builder;
    const Operand result = compileExpression(text, builder, vocabulary);
    return builder.finish(result);
}

}  // namespace

InputVocabulary::InputVocabulary() {
    const std::vector<Real> x{-1, 0, 0.5, 2, 3.5, 4}, y{2, 1.5, 3, -1, 0.3, 0.7}, y2{0, 1, -2, 0.4, 2, 1};
    m_splines.emplace(7, InterpolatingSpline("SPLINE/7", x, y));
    m_splines.emplace(8, InterpolatingSpline("SPLINE/8", x, {1, 3}, {y, y2}));
}

std::optional<Operand> InputVocabulary::call(ProgramBuilder& builder, const Call& call) {
    if (call.name == "TURN") {
        requireArguments(call, 2, 2);
        return builder.continuousAngle(requireScalar(call, 0), requireScalar(call, 1));
    }
    if (call.name == "HALF") {
        requireArguments(call, 1, 1);
        return builder.multiply(builder.number(0.5), requireScalar(call, 0));
    }
    if (call.name == "TWICE") return compileExpression("2*Q1", builder, *this);
    if (call.name == "IDS") {
        requireArguments(call, 2, 2);
        return builder.number(10 * requireId(call, 0) + requireId(call, 1));
    }
    for (const Input& input : Inputs) {
        if (call.name != input.name) continue;
        const auto known = m_operands.find(call.name);
        if (known != m_operands.end()) return known->second;
        inputs[call.name] = input.isVector ? builder.getNumVectorInputs() : builder.getNumScalarInputs();
        return m_operands[call.name] =
                   input.isVector ? builder.addVectorInput(input.level) : builder.addScalarInput(input.level);
    }
    return std::nullopt;
}

const InterpolatingSpline* InputVocabulary::findSpline(int id) {
    const auto found = m_splines.find(id);
    return found == m_splines.end() ? nullptr : &found->second;
}

std::vector<std::string> InputVocabulary::getNames() const {
    std::vector<std::string> names{"TURN", "HALF", "TWICE", "IDS"};
    for (const Input& input : Inputs) names.emplace_back(input.name);
    return names;
}

Expression::Expression(const std::string& text) : evaluation(compile(text, vocabulary)) {}

void Expression::set(const std::string& name, const Taylor<Real>& value) {
    const auto input = vocabulary.inputs.find(name);
    if (name == "TIME" && getProgram().getTimeInput() >= 0)
        evaluation.setScalarInput(getProgram().getTimeInput(), value);
    else if (input != vocabulary.inputs.end())
        evaluation.setScalarInput(input->second, value);
}

void Expression::set(const std::string& name, const Taylor<Vec3>& value) {
    const auto input = vocabulary.inputs.find(name);
    if (input != vocabulary.inputs.end()) evaluation.setVectorInput(input->second, value);
}

Real evaluate(const std::string& text) {
    return Expression(text).evaluation.calcValue();
}

Vec3 evaluateVector(const std::string& text) {
    return Expression(text).evaluation.calcVectorValue();
}

std::string findError(const std::string& text) {
    try {
        const Expression expression(text);
    } catch (const ExpressionError& error) {
        return std::to_string(error.offset) + ": " + error.message;
    }
    return "";
}

}  // namespace jprim::testing
