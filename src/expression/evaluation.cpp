// SPDX-License-Identifier: Apache-2.0
#include "expression/evaluation.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "expression/execute.h"

namespace jprim {

using SimTK::Real;
using SimTK::Vec3;

Evaluation::Evaluation(Program program)
    : m_program(std::move(program)),
      m_registers(m_program.m_code->initial),
      m_scalarGradients(m_registers.scalars.size()),
      m_vectorGradients(m_registers.vectors.size()) {}

void Evaluation::setScalarInput(int input, const Taylor<Real>& value) {
    const int r = m_program.m_code->scalarInputs.at(input);
    if (r >= 0) m_registers.scalars[r] = value;
}

void Evaluation::setVectorInput(int input, const Taylor<Vec3>& value) {
    const int r = m_program.m_code->vectorInputs.at(input);
    if (r >= 0) m_registers.vectors[r] = value;
}

void Evaluation::setRememberedAngle(int k, Real angle) {
    m_registers.scalars[m_program.m_code->angles.at(k).remembered].value = angle;
}

Real Evaluation::getAngle(int k) const {
    return m_registers.scalars[m_program.m_code->angles.at(k).result].value;
}

template <class Access>
void Evaluation::run() {
    const Program::Code& code = *m_program.m_code;
    for (const Instruction& instruction : code.instructions)
        execute<Access>(instruction, code.curves, m_registers);
}

Real Evaluation::calcValue() {
    assert(!m_program.isVector());
    run<ValuesOnly>();
    return m_registers.scalars[m_program.m_code->result.index].value;
}

Vec3 Evaluation::calcVectorValue() {
    assert(m_program.isVector());
    run<ValuesOnly>();
    return m_registers.vectors[m_program.m_code->result.index].value;
}

Taylor<Real> Evaluation::calcTaylor() {
    assert(!m_program.isVector());
    run<WithDerivatives>();
    return m_registers.scalars[m_program.m_code->result.index];
}

Taylor<Vec3> Evaluation::calcVectorTaylor() {
    assert(m_program.isVector());
    run<WithDerivatives>();
    return m_registers.vectors[m_program.m_code->result.index];
}

// With g = d result / d (what an instruction writes), each of its arguments x receives g d(written)/dx. An
// instruction whose g is zero has nothing to give, not even where a derivative is infinite.
void Evaluation::calcGradient() {
    assert(!m_program.isVector());
    const Program::Code& code = *m_program.m_code;
    std::fill(m_scalarGradients.begin(), m_scalarGradients.end(), Real(0));
    std::fill(m_vectorGradients.begin(), m_vectorGradients.end(), Vec3(0));
    m_scalarGradients[code.result.index] = 1;
    m_isGradientChosen = false;
    for (auto it = code.instructions.rbegin(); it != code.instructions.rend(); ++it) {
        if (hasVectorResult(it->operation))
            accumulateAdjoints(*it, m_vectorGradients[it->result]);
        else
            accumulateAdjoints(*it, m_scalarGradients[it->result]);
    }
}

namespace {

// Along no axis and in no plane of two, lest a mechanism that moves along these alone should not feel it.
const Vec3 ChosenDirection(0.36, 0.48, 0.8);

}  // namespace

void Evaluation::accumulateAdjoints(const Instruction& instruction, Real g) {
    if (g == 0) return;
    const std::array<int, 4>& arguments = instruction.arguments;
    const int detail = instruction.detail;
    const auto value = [&](int i) { return m_registers.scalars[arguments[i]].value; };
    const auto vectorValue = [&](int i) -> const Vec3& { return m_registers.vectors[arguments[i]].value; };
    const auto give = [&](int i, Real x) { m_scalarGradients[arguments[i]] += x; };
    const auto giveVector = [&](int i, const Vec3& x) { m_vectorGradients[arguments[i]] += x; };
    const auto givePartials = [&](const Partials& d) {
        give(0, g * d.x);
        give(1, g * d.y);
    };
    const Real f = m_registers.scalars[instruction.result].value;
    switch (instruction.operation) {
        case Operation::Add: return give(0, g), give(1, g);
        case Operation::Subtract: return give(0, g), give(1, -g);
        case Operation::Negate: return give(0, -g);
        case Operation::Multiply: return give(0, g * value(1)), give(1, g * value(0));
        case Operation::Divide: return give(0, g / value(1)), give(1, -g * f / value(1));
        case Operation::Call:
            return givePartials(calcPartials(static_cast<Function>(detail), value(0), value(1), f));
        case Operation::Curve:
            return givePartials(m_program.m_code->curves[size_t(detail)]->calcPartials(value(0), value(1)));
        case Operation::Select: return give(findBranch(value(0)), g);
        case Operation::Dot: return giveVector(0, g * vectorValue(1)), giveVector(1, g * vectorValue(0));
        case Operation::Norm:
            if (f == 0) m_isGradientChosen = true;
            return giveVector(0, f == 0 ? g * ChosenDirection : g / f * vectorValue(0));
        case Operation::Component: m_vectorGradients[arguments[0]][detail] += g; return;
        default: assert(!"the result is a vector");
    }
}

void Evaluation::accumulateAdjoints(const Instruction& instruction, const Vec3& g) {
    if (g == Vec3(0)) return;
    const std::array<int, 4>& arguments = instruction.arguments;
    const auto vectorValue = [&](int i) -> const Vec3& { return m_registers.vectors[arguments[i]].value; };
    const auto give = [&](int i, Real x) { m_scalarGradients[arguments[i]] += x; };
    const auto giveVector = [&](int i, const Vec3& x) { m_vectorGradients[arguments[i]] += x; };
    switch (instruction.operation) {
        case Operation::Vector: return give(0, g[0]), give(1, g[1]), give(2, g[2]);
        case Operation::AddVectors: return giveVector(0, g), giveVector(1, g);
        case Operation::SubtractVectors: return giveVector(0, g), giveVector(1, -g);
        case Operation::Scale:
            give(0, SimTK::dot(g, vectorValue(1)));
            return giveVector(1, m_registers.scalars[arguments[0]].value * g);
        case Operation::Cross:  // g . (a % b) = a . (b % g) = b . (g % a)
            giveVector(0, SimTK::cross(vectorValue(1), g));
            return giveVector(1, SimTK::cross(g, vectorValue(0)));
        default: assert(!"the result is a scalar");
    }
}

Real Evaluation::getScalarGradient(int input) const {
    const int r = m_program.m_code->scalarInputs.at(input);
    return r < 0 ? 0 : m_scalarGradients[r];
}

const Vec3& Evaluation::getVectorGradient(int input) const {
    static const Vec3 zero(0);
    const int r = m_program.m_code->vectorInputs.at(input);
    return r < 0 ? zero : m_vectorGradients[r];
}

}  // namespace jprim
