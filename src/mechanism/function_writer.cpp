// SPDX-License-Identifier: Apache-2.0
#include "mechanism/function_writer.h"

namespace jprim {

Operand FunctionWriter::compile(const ExpressionText& function, bool isVector) {
    try {
        const Operand value = compileExpression(function.text, m_builder, m_vocabulary);
        if (value.isVector == isVector) return value;
    } catch (const ExpressionError& error) {
        throw FunctionError(function.getPosition(error.offset), error.what());
    }
    throw FunctionError(function.getPosition(0), isVector ? "the function must be a vector, such as [1,0,0]"
                                                          : "the function is a vector; it must be a number");
}

FunctionError FunctionWriter::locate(const ExpressionError& error, const PlannedState& state) {
    return FunctionError(state.diff ? state.diff->function.getPosition(error.offset) : state.where,
                         error.what());
}

Operand FunctionWriter::rate(const ControlPlan& plan, size_t k) {
    const PlannedState& state = plan.states[k];
    if (state.diff && !state.diff->implicit) return scalar(state.diff->function);
    try {
        return m_vocabulary.makeRate(m_builder, k);
    } catch (const ExpressionError& error) {
        throw locate(error, state);
    }
}

Operand FunctionWriter::equation(const ControlPlan& plan, size_t k, int& unknown) {
    try {
        return m_vocabulary.makeEquation(m_builder, k, unknown);
    } catch (const ExpressionError& error) {
        throw locate(error, plan.states[k]);
    }
}

Operand FunctionWriter::fromAxesOf(int marker, Operand v) {
    if (marker == 0) return v;
    Operand sum = m_builder.multiply(m_builder.component(v, 0), m_frames.axis(marker, 0));
    for (int axis = 1; axis < 3; ++axis)
        sum =
            m_builder.add(sum, m_builder.multiply(m_builder.component(v, axis), m_frames.axis(marker, axis)));
    return sum;
}

}  // namespace jprim
