// SPDX-License-Identifier: Apache-2.0
#include "expression/time_breaks.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace jprim {

using SimTK::Real;

namespace {

bool isOfScalars(const Instruction& instruction) {
    return !hasVectorResult(instruction.operation) && !std::strchr(getShapes(instruction.operation), 'v');
}

bool hasBranches(const Instruction& instruction) {
    if (instruction.operation == Operation::Select || instruction.operation == Operation::Curve) return true;
    if (instruction.operation != Operation::Call) return false;
    const auto function = static_cast<Function>(instruction.detail);
    return function == Function::Abs || function == Function::Aint || function == Function::Anint ||
           function == Function::Mod;
}

// Values stay zero between corners of their own only.
Real findSign(Real x) {
    return x < 0 ? -1 : 1;
}

}  // namespace

TimeBreaks::TimeBreaks(const Program& program, Real unit) : m_program(program), m_unit(unit) {
    const Program::Code& code = *m_program.m_code;
    if (code.timeInput < 0) return;
    std::vector<bool> isKnown(code.initial.scalars.size(), true);  // given time
    for (const int input : code.scalarInputs)
        if (input >= 0) isKnown[size_t(input)] = false;
    for (const Program::Angle& angle : code.angles) isKnown[size_t(angle.remembered)] = false;
    isKnown[size_t(code.scalarInputs[size_t(code.timeInput)])] = true;
    for (const Taylor<Real>& constant : code.initial.scalars)
        m_ranges.push_back({constant.value, constant.value});
    for (const Instruction& instruction : code.instructions) {
        if (hasVectorResult(instruction.operation)) continue;
        const auto& arguments = instruction.arguments;
        const auto isGiven = [&](int argument) { return argument < 0 || isKnown[size_t(argument)]; };
        const bool scalars = isOfScalars(instruction);
        isKnown[size_t(instruction.result)] =
            scalars && std::all_of(arguments.begin(), arguments.end(), isGiven);
        if (isKnown[size_t(instruction.result)]) m_instructions.push_back(instruction);
        // A branch may be decided by time where what it leads to is not.
        else if (instruction.operation == Operation::Select && isKnown[size_t(arguments[0])])
            m_instructions.push_back(instruction);
    }
    for (const Instruction& instruction : m_instructions)
        if (hasBranches(instruction)) m_joints.push_back({instruction});
}

Interval TimeBreaks::calc(const Instruction& instruction) const {
    const auto range = [&](int i) -> const Interval& { return m_ranges[size_t(instruction.arguments[i])]; };
    switch (instruction.operation) {
        case Operation::Add: return range(0) + range(1);
        case Operation::Subtract: return range(0) - range(1);
        case Operation::Negate: return -range(0);
        case Operation::Multiply: return range(0) * range(1);
        case Operation::Divide: return range(0) / range(1);
        case Operation::Call: return calcRange(static_cast<Function>(instruction.detail), range(0), range(1));
        case Operation::Select: {
            const Interval& condition = range(0);
            if (std::isnan(condition.low) || std::isnan(condition.high)) return {};
            std::optional<Interval> result;
            const auto add = [&](const Interval& branch) {
                result = result ? unite(*result, branch) : branch;
            };
            if (condition.low < 0) add(range(1));
            if (condition.contains(0)) add(range(2));
            if (condition.high > 0) add(range(3));
            return *result;
        }
        case Operation::Curve: {
            const Interval &x = range(0), &z = range(1);
            if (x.low != x.high || z.low != z.high) return {};
            const Real y = m_program.m_code->curves[size_t(instruction.detail)]->calcValue(x.low, z.low);
            return {y, y};
        }
        default: return {};
    }
}

void TimeBreaks::look(Joint& joint) const {
    const Instruction& instruction = joint.instruction;
    const Interval& x = m_ranges[size_t(instruction.arguments[0])];
    const auto set = [&](Real first, Real last) {
        joint.first = first;
        joint.last = last;
    };
    if (instruction.operation == Operation::Select) return set(findSign(x.low), findSign(x.high));
    if (instruction.operation == Operation::Curve) {
        const Curve& curve = *m_program.m_code->curves[size_t(instruction.detail)];
        return set(curve.findPiece(x.low), curve.findPiece(x.high));
    }
    switch (static_cast<Function>(instruction.detail)) {
        case Function::Abs: return set(findSign(x.low), findSign(x.high));
        case Function::Aint: return set(std::trunc(x.low), std::trunc(x.high));
        case Function::Anint: return set(std::round(x.low), std::round(x.high));
        default: {
            const Interval quotient = x / m_ranges[size_t(instruction.arguments[1])];
            return set(std::trunc(quotient.low), std::trunc(quotient.high));
        }
    }
}

// Where everything between two times is.
void TimeBreaks::run(Real from, Real to) {
    const Program::Code& code = *m_program.m_code;
    m_ranges[size_t(code.scalarInputs[size_t(code.timeInput)])] = {from / m_unit, to / m_unit};
    for (const Instruction& instruction : m_instructions)
        m_ranges[size_t(instruction.result)] = calc(instruction);
    for (Joint& joint : m_joints) look(joint);
    ++m_numRuns;
}

bool TimeBreaks::isSure() const {
    return std::all_of(m_joints.begin(), m_joints.end(), [](const Joint& joint) { return joint.isSure(); });
}

bool TimeBreaks::isBounded() const {
    return std::all_of(m_joints.begin(), m_joints.end(), [this](const Joint& joint) {
        return joint.isSure() || m_ranges[size_t(joint.instruction.arguments[0])].isBounded();
    });
}

std::vector<Real> TimeBreaks::findBranches(Real time) {
    run(time, time);
    std::vector<Real> branches;
    for (const Joint& joint : m_joints) branches.push_back(joint.first);
    return branches;
}

std::optional<TimeBreak> TimeBreaks::search(Real from, Real to, int halvings) {
    constexpr int IfUnbounded = 6, MostRuns = 5000;
    run(from, to);
    if (isSure()) return std::nullopt;
    if (!isBounded()) halvings = std::min(halvings, IfUnbounded);
    const Real middle = from + (to - from) / 2;
    if (halvings == 0 || m_numRuns > MostRuns || !(from < middle && middle < to)) return narrow(from, to);
    if (const auto found = search(from, middle, halvings - 1)) return found;
    return search(middle, to, halvings - 1);
}

// The branches may be the same at both ends after all. One that is left where it has just been reached, as those for zero
// are, is no stop on the way.
std::optional<TimeBreak> TimeBreaks::narrow(Real from, Real to) {
    const std::vector<Real> before = findBranches(from);
    if (findBranches(to) == before) return std::nullopt;
    for (Real middle = from + (to - from) / 2; from < middle && middle < to; middle = from + (to - from) / 2)
        (findBranches(middle) == before ? from : to) = middle;
    return TimeBreak{from, to};
}

std::vector<bool> TimeBreaks::findZeros(Real time) {
    run(time, time);
    std::vector<bool> zeros;
    for (const Joint& joint : m_joints) {
        const Instruction& instruction = joint.instruction;
        const bool hasOwn = instruction.operation == Operation::Select ||
                            (instruction.operation == Operation::Call &&
                             static_cast<Function>(instruction.detail) == Function::Abs);
        zeros.push_back(hasOwn && m_ranges[size_t(instruction.arguments[0])].low == 0);
    }
    return zeros;
}

// IF and ABS have a branch for zero, which rounding may hold for a few numbers. What is zero for longer is so between breaks. The
// numbers next to zero are closer to each other than any step can be.
Real TimeBreaks::leaveZero(Real time, int direction, Real closest) {
    constexpr int MostDoublings = 20;
    const Real next = std::nextafter(time, direction * SimTK::Infinity) - time;
    const Real spacing = direction * std::max(std::abs(next), closest);
    const std::vector<bool> here = findZeros(time),
                            far = findZeros(time + std::ldexp(spacing, MostDoublings));
    const auto isHeld = [&](Real there) {
        const std::vector<bool> zeros = findZeros(there);
        for (size_t k = 0; k < zeros.size(); ++k)
            if (here[k] && zeros[k] && !far[k]) return true;
        return false;
    };
    Real there = time;
    for (int k = 0; k < MostDoublings && isHeld(there); ++k) there = time + std::ldexp(spacing, k);
    return there;
}

std::optional<TimeBreak> TimeBreaks::findFirst(Real after, Real until) {
    constexpr int Halvings = 45, MostMerged = 8, OfSpan = -60;
    if (isEmpty() || !(after < until)) return std::nullopt;
    m_numRuns = 0;
    const Real closest = std::ldexp(until - after, OfSpan);
    std::optional<TimeBreak> found = search(after, leaveZero(until, 1, closest), Halvings);
    if (!found) return std::nullopt;
    found->before = std::max(after, leaveZero(found->before, -1, closest));
    found->behind = leaveZero(found->behind, 1, closest);
    for (int k = 0; k < MostMerged; ++k) {
        const Real next = std::nextafter(found->behind, SimTK::Infinity);
        if (findBranches(next) == findBranches(found->behind)) break;
        found->behind = next;
    }
    return found;
}

}  // namespace jprim
