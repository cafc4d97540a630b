// SPDX-License-Identifier: Apache-2.0
// What whole turns of its angles add to the result of a Program.
#include <algorithm>
#include <cmath>
#include <vector>

#include "expression/program.h"

namespace jprim {

using SimTK::NaN;
using SimTK::Real;

namespace {

// Goes from the result back through the instructions. A slope is a number where it is the same whatever the inputs
// are, and NaN elsewhere; sums and constant factors are all that leaves it a number.
class ConstantSlopes {
public:
    ConstantSlopes(const Registers& registers, const std::vector<bool>& isConstant, Operand result)
        : m_scalars(registers.scalars),
          m_isConstant(isConstant),
          m_ofScalars(registers.scalars.size()),
          m_ofVectors(registers.vectors.size()) {
        (result.isVector ? m_ofVectors : m_ofScalars)[size_t(result.index)] = result.isVector ? NaN : 1;
    }

    Real get(int scalar) const { return m_ofScalars[size_t(scalar)]; }

    void accumulateAdjoints(const Instruction& instruction) {
        const bool isVector = hasVectorResult(instruction.operation);
        const Real slope = (isVector ? m_ofVectors : m_ofScalars)[size_t(instruction.result)];
        if (slope == 0) return;
        const auto& [a, b, c, d] = instruction.arguments;
        switch (instruction.operation) {
            case Operation::Add: return add(a, slope), add(b, slope);
            case Operation::Subtract: return add(a, slope), add(b, -slope);
            case Operation::Negate: return add(a, -slope);
            case Operation::Multiply: return add(a, slope * getConstant(b)), add(b, slope * getConstant(a));
            case Operation::Divide: return add(a, slope / getConstant(b)), add(b, NaN);
            default: break;
        }
        const char* shapes = getShapes(instruction.operation);
        for (size_t i = 0; shapes[i]; ++i)
            (shapes[i] == 'v' ? m_ofVectors : m_ofScalars)[size_t(instruction.arguments[i])] = NaN;
    }

private:
    void add(int scalar, Real slope) { m_ofScalars[size_t(scalar)] += slope; }
    Real getConstant(int scalar) const {
        return m_isConstant[size_t(scalar)] ? m_scalars[size_t(scalar)].value : NaN;
    }

    const std::vector<Taylor<Real>>& m_scalars;
    const std::vector<bool>& m_isConstant;
    std::vector<Real> m_ofScalars, m_ofVectors;
};

}  // namespace

void Program::findAngleSlopes(Code& code) {
    if (code.angles.empty()) return;
    std::vector<bool> isConstant(code.initial.scalars.size(), true);
    for (const Angle& angle : code.angles) isConstant[size_t(angle.remembered)] = false;
    for (const int input : code.scalarInputs)
        if (input >= 0) isConstant[size_t(input)] = false;
    for (const Instruction& instruction : code.instructions)
        if (!hasVectorResult(instruction.operation)) isConstant[size_t(instruction.result)] = false;
    ConstantSlopes slopes(code.initial, isConstant, code.result);
    std::for_each(code.instructions.rbegin(), code.instructions.rend(),
                  [&slopes](const Instruction& instruction) { slopes.accumulateAdjoints(instruction); });
    for (Angle& angle : code.angles) angle.slope = slopes.get(angle.result);
}

// The greatest number of which all slopes are whole multiples is the largest slope divided by a whole number.
Real Program::findTurnPeriod() const {
    constexpr Real Rounding = 1e-12;
    Real largest = 0;
    for (const Angle& angle : m_code->angles) {
        if (!std::isfinite(angle.slope)) return 0;
        largest = std::max(largest, std::abs(angle.slope));
    }
    for (int n = 1; largest > 0 && n <= LargestRatio; ++n) {
        const auto isMultiple = [&](const Angle& angle) {
            const Real ratio = n * angle.slope / largest;
            return std::abs(ratio - std::round(ratio)) <= n * Rounding;
        };
        if (std::all_of(m_code->angles.begin(), m_code->angles.end(), isMultiple))
            return 2 * SimTK::Pi * largest / n;
    }
    return 0;
}

}  // namespace jprim
