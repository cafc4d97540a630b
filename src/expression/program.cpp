// SPDX-License-Identifier: Apache-2.0
// ProgramBuilder::finish(): keeps of all that was written what one result needs.
#include "expression/program.h"

#include <algorithm>

namespace jprim {
namespace {

// New numbers for the registers of one kind, in their old order; -1 for those that are not needed.
class Renumbering {
public:
    explicit Renumbering(std::size_t size) : m_numbers(size, -1) {}

    void need(int r) { m_numbers[r] = 0; }
    bool isNeeded(int r) const { return m_numbers[r] >= 0; }
    int operator()(int r) const { return m_numbers[r]; }

    // Gives out the numbers and copies the needed registers.
    template <class T>
    void keep(const std::vector<T>& all, std::vector<T>& kept) {
        for (std::size_t r = 0; r < all.size(); ++r) {
            if (m_numbers[r] < 0) continue;
            m_numbers[r] = static_cast<int>(kept.size());
            kept.push_back(all[r]);
        }
    }

private:
    std::vector<int> m_numbers;
};

struct NewRegisters {
    Renumbering scalars, vectors;

    Renumbering& get(bool isVector) { return isVector ? vectors : scalars; }
};

// The registers that the result comes from: backwards, every instruction passes its need on.
NewRegisters findNeeded(const std::vector<Instruction>& instructions, Operand result, const Registers& all) {
    NewRegisters needed{Renumbering(all.scalars.size()), Renumbering(all.vectors.size())};
    needed.get(result.isVector).need(result.index);
    for (auto it = instructions.rbegin(); it != instructions.rend(); ++it) {
        if (!needed.get(hasVectorResult(it->operation)).isNeeded(it->result)) continue;
        const char* shapes = getShapes(it->operation);
        for (int i = 0; shapes[i]; ++i) needed.get(shapes[i] == 'v').need(it->arguments[i]);
    }
    return needed;
}

bool isSwitch(const Instruction& instruction) {
    return instruction.operation == Operation::Select ||
           (instruction.operation == Operation::Call && Function(instruction.detail) == Function::Abs);
}

}  // namespace

int Program::getNumDerivatives() const {
    int number = 2;
    for (const auto& curve : m_code->curves) number = std::min(number, curve->getNumDerivatives());
    return number;
}

Program ProgramBuilder::finish(Operand result) const {
    NewRegisters renumber = findNeeded(m_instructions, result, m_values);
    const auto code = std::make_shared<Program::Code>();
    renumber.scalars.keep(m_values.scalars, code->initial.scalars);
    renumber.vectors.keep(m_values.vectors, code->initial.vectors);

    const auto addSwitch = [&](int value) {
        const auto isSame = [&](const Program::Switch& other) {
            return other.value == renumber.scalars(value);
        };
        if (m_scalarTraits[size_t(value)].isConstant ||
            std::any_of(code->switches.begin(), code->switches.end(), isSame))
            return;
        code->switches.push_back({renumber.scalars(value), m_scalarTraits[size_t(value)].level});
    };
    for (Instruction instruction : m_instructions) {
        instruction.result = renumber.get(hasVectorResult(instruction.operation))(instruction.result);
        if (instruction.result < 0) continue;
        if (isSwitch(instruction)) addSwitch(instruction.arguments[0]);
        const char* shapes = getShapes(instruction.operation);
        for (int i = 0; shapes[i]; ++i) {
            int& argument = instruction.arguments[i];
            argument = renumber.get(shapes[i] == 'v')(argument);
        }
        if (instruction.operation == Operation::Curve) {
            code->curves.push_back(m_curves[instruction.detail]);
            instruction.detail = static_cast<int>(code->curves.size()) - 1;
        }
        code->instructions.push_back(instruction);
    }
    for (const int r : m_scalarInputs) code->scalarInputs.push_back(renumber.scalars(r));
    for (const int r : m_vectorInputs) code->vectorInputs.push_back(renumber.vectors(r));
    if (m_timeInput >= 0 && code->scalarInputs[m_timeInput] >= 0) code->timeInput = m_timeInput;
    for (const Program::Angle& angle : m_angles)
        if (renumber.scalars.isNeeded(angle.result))
            code->angles.push_back(
                {renumber.scalars(angle.remembered), renumber.scalars(angle.result), SimTK::NaN});

    code->result = {renumber.get(result.isVector)(result.index), result.isVector};
    code->level = getTraits(result).level;
    code->velocityDegree = getTraits(result).velocityDegree;
    Program::findAngleSlopes(*code);
    return Program(code);
}

}  // namespace jprim
