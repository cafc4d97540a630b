// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_FUNCTION_WRITER_H_
#define JPRIM_SRC_MECHANISM_FUNCTION_WRITER_H_

#include <stdexcept>
#include <string>

#include "mechanism/mechanism_vocabulary.h"

namespace jprim {

/// A mistake in a function expression, at its place in the file.
struct FunctionError : std::runtime_error {
    FunctionError(const SourcePosition& position, const std::string& message)
        : std::runtime_error(message), where(position) {}

    SourcePosition where;
};

/// Writes one Expression from functions of the dataset and operations of our own, in the dataset's units.
class FunctionWriter {
public:
    FunctionWriter(const MarkerFrames::FindMarker& find, const FunctionContext& context, FunctionUse use)
        : m_frames(m_builder, find, {context.units.length, context.units.time}),
          m_vocabulary(m_frames, find, context, use) {}
    /// Its parts refer to each other.
    FunctionWriter(const FunctionWriter&) = delete;
    FunctionWriter& operator=(const FunctionWriter&) = delete;

    ProgramBuilder& updBuilder() { return m_builder; }
    MarkerFrames& updFrames() { return m_frames; }

    /// A function of the dataset. @throws FunctionError
    Operand scalar(const ExpressionText& function) { return compile(function, false); }
    Operand vector(const ExpressionText& function) { return compile(function, true); }

    /// The derivative of the k-th state, and of an implicit one its equation, as MechanismVocabulary makes them.
    /// @throws FunctionError
    Operand rate(const ControlPlan& plan, size_t k);
    Operand equation(const ControlPlan& plan, size_t k, int& unknown);

    Operand scale(SimTK::Real factor, Operand a) { return m_builder.multiply(m_builder.number(factor), a); }
    /// The vector whose components in the axes of a marker are those of v.
    Operand fromAxesOf(int marker, Operand v);

    Expression finish(Operand result) {
        return Expression(std::make_shared<const MarkerExpression>(m_frames.finish(result)));
    }

private:
    Operand compile(const ExpressionText& function, bool isVector);
    static FunctionError locate(const ExpressionError& error, const PlannedState& state);

    ProgramBuilder m_builder;
    MarkerFrames m_frames;
    MechanismVocabulary m_vocabulary;
};

}  // namespace jprim

#endif
