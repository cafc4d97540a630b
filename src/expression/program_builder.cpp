// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "expression/execute.h"
#include "expression/program.h"

namespace jprim {

using SimTK::Real;
using SimTK::Vec3;

namespace {

constexpr int Nonlinear = 2;  // stands for all degrees above 1

// The degree of a result in the velocities, given those of its arguments.
int calcDegree(Operation operation, const std::array<int, 4>& degrees) {
    const int highest = *std::max_element(degrees.begin(), degrees.end());
    switch (operation) {
        case Operation::Multiply:
        case Operation::Dot:
        case Operation::Scale:
        case Operation::Cross: return std::min(degrees[0] + degrees[1], Nonlinear);
        case Operation::Divide: return degrees[1] == 0 ? degrees[0] : Nonlinear;
        case Operation::Select: return degrees[0] == 0 ? highest : Nonlinear;
        case Operation::Call:
        case Operation::Norm:
        case Operation::Curve: return highest == 0 ? 0 : Nonlinear;
        default: return highest;
    }
}

[[maybe_unused]] bool fits(const char* shapes, const std::initializer_list<Operand>& arguments) {
    return std::equal(arguments.begin(), arguments.end(), shapes, shapes + std::strlen(shapes),
                      [](Operand a, char shape) { return a.index >= 0 && a.isVector == (shape == 'v'); });
}

}  // namespace

const ProgramBuilder::Traits& ProgramBuilder::getTraits(Operand a) const {
    return a.isVector ? m_vectorTraits.at(a.index) : m_scalarTraits.at(a.index);
}

ProgramBuilder::Traits ProgramBuilder::combineTraits(Operation operation,
                                                     const std::initializer_list<Operand>& arguments) const {
    Traits result{true};
    std::array<int, 4> degrees{};
    int i = 0;
    for (const Operand a : arguments) {
        const Traits& traits = getTraits(a);
        result.isConstant = result.isConstant && traits.isConstant;
        result.level = std::max(result.level, traits.level);
        degrees[i++] = traits.velocityDegree;
    }
    result.velocityDegree = calcDegree(operation, degrees);
    return result;
}

Operand ProgramBuilder::makeOperand(bool isVector, const Traits& traits) {
    if (isVector) {
        m_values.vectors.emplace_back();
        m_vectorTraits.push_back(traits);
        return {static_cast<int>(m_vectorTraits.size()) - 1, true};
    }
    m_values.scalars.emplace_back();
    m_scalarTraits.push_back(traits);
    return {static_cast<int>(m_scalarTraits.size()) - 1, false};
}

Operand ProgramBuilder::emit(Operation operation, std::initializer_list<Operand> arguments, int detail) {
    assert(fits(getShapes(operation), arguments));
    const Traits traits = combineTraits(operation, arguments);
    const Operand result = makeOperand(hasVectorResult(operation), traits);
    Instruction instruction{operation, detail, {-1, -1, -1, -1}, result.index};
    std::transform(arguments.begin(), arguments.end(), instruction.arguments.begin(),
                   [](Operand a) { return a.index; });
    if (traits.isConstant)
        execute<ValuesOnly>(instruction, m_curves, m_values);
    else
        m_instructions.push_back(instruction);
    return result;
}

Operand ProgramBuilder::addInput(bool isVector, KinematicLevel level) {
    constexpr std::array<int, 3> degrees{0, 1, Nonlinear};
    const Operand input = makeOperand(isVector, {false, level, degrees[static_cast<int>(level)]});
    (isVector ? m_vectorInputs : m_scalarInputs).push_back(input.index);
    return input;
}

Operand ProgramBuilder::addScalarInput(KinematicLevel level) {
    return addInput(false, level);
}

Operand ProgramBuilder::addVectorInput(KinematicLevel level) {
    return addInput(true, level);
}

Operand ProgramBuilder::time() {
    if (m_timeInput < 0) {
        m_timeInput = static_cast<int>(m_scalarInputs.size());
        addScalarInput(KinematicLevel::Position);
    }
    return {m_scalarInputs[m_timeInput], false};
}

Operand ProgramBuilder::number(Real value) {
    const Operand result = makeOperand(false, {true});
    m_values.scalars.back().value = value;
    return result;
}

Operand ProgramBuilder::vector(Operand x, Operand y, Operand z) {
    return emit(Operation::Vector, {x, y, z});
}

Operand ProgramBuilder::add(Operand a, Operand b) {
    return emit(a.isVector ? Operation::AddVectors : Operation::Add, {a, b});
}

Operand ProgramBuilder::subtract(Operand a, Operand b) {
    return emit(a.isVector ? Operation::SubtractVectors : Operation::Subtract, {a, b});
}

Operand ProgramBuilder::negate(Operand a) {
    return a.isVector ? multiply(number(-1), a) : emit(Operation::Negate, {a});
}

Operand ProgramBuilder::multiply(Operand a, Operand b) {
    if (a.isVector && b.isVector) return emit(Operation::Dot, {a, b});
    if (a.isVector) return emit(Operation::Scale, {b, a});
    return emit(b.isVector ? Operation::Scale : Operation::Multiply, {a, b});
}

Operand ProgramBuilder::divide(Operand a, Operand b) {
    if (a.isVector) return emit(Operation::Scale, {divide(number(1), b), a});
    return emit(Operation::Divide, {a, b});
}

Operand ProgramBuilder::cross(Operand a, Operand b) {
    return emit(Operation::Cross, {a, b});
}

Operand ProgramBuilder::norm(Operand a) {
    return emit(Operation::Norm, {a});
}

Operand ProgramBuilder::normalize(Operand a) {
    const Operand length = norm(a), zero = number(0);
    return multiply(select(length, zero, zero, divide(number(1), length)), a);
}

Operand ProgramBuilder::component(Operand a, int axis) {
    assert(0 <= axis && axis < 3);
    return emit(Operation::Component, {a}, axis);
}

Operand ProgramBuilder::callTwo(Function function, Operand x, Operand y) {
    return emit(Operation::Call, {x, y}, static_cast<int>(function));
}

Operand ProgramBuilder::call(Function function, Operand a) {
    return callTwo(function, a, a);
}

Operand ProgramBuilder::power(Operand a, Operand b) {
    // Spelt out where that is exact, so that the degree in velocities is seen too.
    if (isConstant(b) && getConstant(b) == 1) return a;
    if (isConstant(b) && getConstant(b) == 2) return multiply(a, a);
    return callTwo(Function::Power, a, b);
}

Operand ProgramBuilder::min(Operand a, Operand b) {
    return select(subtract(a, b), a, a, b);
}

Operand ProgramBuilder::max(Operand a, Operand b) {
    return select(subtract(a, b), b, a, a);
}

Operand ProgramBuilder::mod(Operand a, Operand b) {
    return callTwo(Function::Mod, a, b);
}

Operand ProgramBuilder::sign(Operand a, Operand b) {
    const Operand size = call(Function::Abs, a);
    return select(b, negate(size), size, size);
}

Operand ProgramBuilder::dim(Operand a, Operand b) {
    return max(number(0), subtract(a, b));
}

Operand ProgramBuilder::select(Operand condition, Operand ifNegative, Operand ifZero, Operand ifPositive) {
    return emit(Operation::Select, {condition, ifNegative, ifZero, ifPositive});
}

Operand ProgramBuilder::curve(std::shared_ptr<const Curve> curve, Operand x, Operand z) {
    m_curves.push_back(std::move(curve));
    return emit(Operation::Curve, {x, z}, static_cast<int>(m_curves.size()) - 1);
}

Operand ProgramBuilder::atan2(Operand y, Operand x) {
    return callTwo(Function::Atan2, y, x);
}

Operand ProgramBuilder::continuousAngle(Operand y, Operand x) {
    const Operand remembered = makeOperand(false, {});
    const Operand result = callTwo(Function::Unwind, atan2(y, x), remembered);
    m_angles.push_back({remembered.index, result.index, SimTK::NaN});
    return result;
}

Real ProgramBuilder::getConstant(Operand scalar) const {
    assert(isConstant(scalar) && !scalar.isVector);
    return m_values.scalars[scalar.index].value;
}

bool ProgramBuilder::isFinite(Operand a) const {
    if (!isConstant(a)) return true;
    return a.isVector ? m_values.vectors[a.index].value.isFinite()
                      : std::isfinite(m_values.scalars[a.index].value);
}

}  // namespace jprim
