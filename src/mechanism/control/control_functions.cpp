// SPDX-License-Identifier: Apache-2.0
// DIF, DIF1, ARYVAL, PINVAL, POUVAL, SENVAL: a State tells states and what sensors have noted; all else is written out
// as an expression of these.
#include <algorithm>
#include <iterator>

#include "base/format.h"
#include "general/check_expression.h"
#include "mechanism/control/control_variables.h"
#include "mechanism/mechanism_vocabulary.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;

namespace {

const char* const ControlFunctions[] = {"DIF", "DIF1", "ARYVAL", "PINVAL", "POUVAL", "SENVAL"};

constexpr const char* NotInEquation =
    "a constraint cannot depend on states of DIFF, LSE and TFSISO or on SENVAL, whose accelerations nobody tells";

}  // namespace

std::vector<std::string> MechanismVocabulary::getControlNames() {
    return {std::begin(ControlFunctions), std::end(ControlFunctions)};
}

std::optional<Operand> MechanismVocabulary::callControl(ProgramBuilder& builder, const Call& call) {
    const auto named = std::find(std::begin(ControlFunctions), std::end(ControlFunctions), call.name);
    if (named == std::end(ControlFunctions)) return std::nullopt;
    const bool hasElements = call.name == "ARYVAL" || call.name == "PINVAL" || call.name == "POUVAL";
    const std::vector<int> ids = getIds(call, hasElements ? 2 : 1, hasElements ? 2 : 1);
    const std::string keyword = call.name == "ARYVAL"   ? "ARRAY"
                                : call.name == "PINVAL" ? "PINPUT"
                                : call.name == "POUVAL" ? "POUTPUT"
                                : call.name == "SENVAL" ? "SENSOR"
                                                        : "DIFF";
    if (m_context.control.faulty.count(fmt::format("{}/{}", keyword, ids[0])) > 0) return builder.time();
    if (call.name == "ARYVAL") return makeArrayElement(builder, call, ids[0], ids[1]);
    if (call.name == "SENVAL") return makeSensorValue(call, ids[0]);
    if (call.name == "PINVAL")
        return makePlantValue(builder, call, m_context.control.plantInputs, keyword, ids);
    if (call.name == "POUVAL")
        return makePlantValue(builder, call, m_context.control.plantOutputs, keyword, ids);
    const auto diff = m_context.control.diffs.find(ids[0]);
    if (diff == m_context.control.diffs.end()) throwMissing(call, keyword, ids[0]);
    return call.name == "DIF" ? makeState(diff->second, call.offset)
                              : makeDerivative(builder, call.offset, diff->second);
}

void MechanismVocabulary::throwMissing(const Call& call, const std::string& keyword, int id) {
    throw ExpressionError(call.arguments[0].offset, fmt::format("{}/{} does not exist", keyword, id));
}

size_t MechanismVocabulary::requireElement(const Call& call, const std::string& keyword, int id, int number,
                                           int size) {
    if (1 <= number && number <= size) return size_t(number - 1);
    throw ExpressionError(call.arguments[1].offset,
                          fmt::format("{}/{} has {} elements, so the second argument must be 1 to {}",
                                      keyword, id, size, size));
}

void MechanismVocabulary::requireStates(size_t offset) const {
    if (m_use == FunctionUse::OfTime) throw ExpressionError(offset, NotOnlyTime);
    if (m_use == FunctionUse::Equation) throw ExpressionError(offset, NotInEquation);
}

// Of the level of velocities, as it is the integral of something and its rate is known when accelerations are.
Operand MechanismVocabulary::makeState(size_t k, size_t offset) {
    requireStates(offset);
    return makeNamed(m_context.control.states[k].name, offset, [&] {
        const ControlVariables* const variables = m_context.controlVariables;
        return updFrames().addScalar(
            KinematicLevel::Velocity, [variables, k](const State& s) { return variables->getState(s, k); },
            [variables, k](const State& s) { return variables->getRate(s, k); });
    });
}

Operand MechanismVocabulary::makeFunction(ProgramBuilder& builder, size_t offset, size_t k) {
    const Operand value = compileExpression(m_context.control.states[k].diff->function.text, builder, *this);
    if (!value.isVector) return value;
    throw ExpressionError(offset, "the function is a vector; it must be a number");
}

Operand MechanismVocabulary::makeDerivative(ProgramBuilder& builder, size_t offset, size_t k) {
    const DiffStatement& diff = *m_context.control.states[k].diff;
    if (diff.implicit && !m_unknowns.empty() && m_unknowns.back().state == k) {
        Unknown& unknown = m_unknowns.back();
        if (unknown.input >= 0) return unknown.derivative;
        unknown.input = builder.getNumScalarInputs();
        return unknown.derivative =
                   updFrames().addScalar(KinematicLevel::Position, [](const State&) { return Real(0); });
    }
    return makeNamed(fmt::format("DIF1({})", diff.id), offset, [&] {
        return diff.implicit ? makeImplicitDerivative(builder, offset, k) : makeFunction(builder, offset, k);
    });
}

// The equation itself tells here only on what the derivative depends: it is solved in a program of its own.
Operand MechanismVocabulary::makeImplicitDerivative(ProgramBuilder& builder, size_t offset, size_t k) {
    m_unknowns.push_back({k, -1, {}});
    const KinematicLevel level = builder.getLevel(makeFunction(builder, offset, k));
    m_unknowns.pop_back();
    requireStates(offset);
    const ControlVariables* const variables = m_context.controlVariables;
    return updFrames().addScalar(
        level, [variables, k](const State& s) { return variables->getImplicitRate(k)->solve(s); });
}

Operand MechanismVocabulary::makeEquation(ProgramBuilder& builder, size_t k, int& unknown) {
    m_unknowns.push_back({k, -1, {}});
    const Operand value = makeFunction(builder, 0, k);
    unknown = m_unknowns.back().input;
    m_unknowns.pop_back();
    return value;
}

Operand MechanismVocabulary::makeSensorValue(const Call& call, int id) {
    requireStates(call.offset);
    const auto found = m_context.control.sensors.find(id);
    if (found == m_context.control.sensors.end()) throwMissing(call, "SENSOR", id);
    if (!m_context.control.evaluates[found->second])
        throw ExpressionError(call.arguments[0].offset,
                              fmt::format("SENSOR/{} has no EVALUATE, so it has no value", id));
    return updFrames().addScalar(KinematicLevel::Position,
                                 [variables = m_context.controlVariables, k = found->second](const State& s) {
                                     return variables->getSensorValue(s, k);
                                 });
}

Operand MechanismVocabulary::makePlantValue(ProgramBuilder& builder, const Call& call,
                                            const std::map<int, const PlantStatement*>& plants,
                                            const std::string& keyword, const std::vector<int>& ids) {
    const auto found = plants.find(ids[0]);
    if (found == plants.end()) throwMissing(call, keyword, ids[0]);
    const std::vector<int>& variables = found->second->variables;
    const size_t k = requireElement(call, keyword, ids[0], ids[1], int(variables.size()));
    return makeVariable(builder, variables[k], call.offset, call.offset);
}

Operand MechanismVocabulary::makeArrayElement(ProgramBuilder& builder, const Call& call, int id, int number) {
    const auto found = m_context.control.arrays.find(id);
    if (found == m_context.control.arrays.end()) throwMissing(call, "ARRAY", id);
    const ControlPlan::Array& array = found->second;
    if (array.size < 0)
        throw ExpressionError(call.arguments[0].offset,
                              fmt::format("ARRAY/{} belongs to no LSE or TFSISO, so it has no values", id));
    const size_t k = requireElement(call, "ARRAY", id, number, array.size);
    const ArrayStatement& statement = *array.statement;
    switch (statement.type) {
        case ArrayType::Constants:
            return builder.number(statement.numbers.empty() ? 0 : statement.numbers[k]);
        case ArrayType::Inputs:
            return makeVariable(builder, statement.variables[k], call.offset, call.offset);
        case ArrayType::States: return makeState(array.firstState + k, call.offset);
        case ArrayType::Outputs: break;
    }
    const LinearSystem& system = m_context.control.systems[array.system];
    return makeNamed(fmt::format("ARYVAL({},{})", id, number), call.offset,
                     [&] { return makeLinear(builder, system, system.C, system.D, int(k), call.offset); });
}

Operand MechanismVocabulary::makeLinear(ProgramBuilder& builder, const LinearSystem& system,
                                        const Coefficients& ofStates, const Coefficients& ofInputs, int row,
                                        size_t offset) {
    Operand sum = builder.number(0);
    const auto add = [&](const Coefficients& coefficients, const auto& makeTerm) {
        for (int k = 0; k < coefficients.columns; ++k)
            if (const Real factor = coefficients.get(row, k); factor != 0)
                sum = builder.add(sum, builder.multiply(builder.number(factor), makeTerm(k)));
    };
    const size_t firstState = m_context.control.arrays.at(system.x).firstState;
    add(ofStates, [&](int k) { return makeState(firstState + size_t(k), offset); });
    add(ofInputs, [&](int k) { return makeVariable(builder, system.inputs[size_t(k)], offset, offset); });
    return sum;
}

Operand MechanismVocabulary::makeRate(ProgramBuilder& builder, size_t k) {
    const PlannedState& state = m_context.control.states[k];
    if (state.diff) return makeDerivative(builder, 0, k);
    const LinearSystem& system = m_context.control.systems[state.system];
    return makeLinear(builder, system, system.A, system.B, state.row, 0);
}

}  // namespace jprim
