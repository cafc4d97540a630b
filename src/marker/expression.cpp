// SPDX-License-Identifier: Apache-2.0
#include "jprim/marker/expression.h"

#include <algorithm>
#include <set>

#include "base/format.h"
#include "base/text.h"
#include "expression/language.h"
#include "jprim/base/error.h"
#include "marker/marker_vocabulary.h"

namespace jprim {

using SimTK::Real;
using SimTK::Stage;
using SimTK::State;
using SimTK::Vec3;

namespace {

using FunctionPointer = std::shared_ptr<const SimTK::Function>;

// What a dataset's functions know besides.
bool isOfDatasets(const std::string& name) {
    static const std::set<std::string> names{"JPRIM",  "JOINT",  "GCON",  "MOTION", "SFORCE", "SPDP", "BUSH",
                                             "GFORCE", "VFORCE", "VTORQ", "ORIENT", "FM",     "FX",   "FY",
                                             "FZ",     "TM",     "TX",    "TY",     "TZ"};
    return names.count(name) > 0;
}

/// The measures of markers and what a program defines.
class DefinedVocabulary final : public MarkerVocabulary {
public:
    DefinedVocabulary(MarkerFrames& frames, const ExpressionDefinitions& definitions)
        : MarkerVocabulary(frames), m_definitions(definitions) {
        for (const auto& [name, function] : definitions.functions) addFunction(name, function);
    }

    std::optional<Operand> call(ProgramBuilder& builder, const Call& call) override {
        const auto found = m_functions.find(call.name);
        if (found != m_functions.end()) return callFunction(builder, call, found->second);
        if (isOfDatasets(call.name))
            throw ExpressionError(call.offset,
                                  fmt::format("{} is known in datasets alone; a program asks the "
                                              "element itself, as by calcReactionOnI()",
                                              call.name));
        return MarkerVocabulary::call(builder, call);
    }

    std::vector<std::string> getNames() const override {
        std::vector<std::string> names = MarkerVocabulary::getNames();
        for (const auto& [name, function] : m_functions) names.push_back(name);
        return names;
    }

    const InterpolatingSpline* findSpline(int id) override {
        const auto found = m_definitions.splines.find(id);
        return found == m_definitions.splines.end() ? nullptr : &found->second;
    }

private:
    static Operand callFunction(ProgramBuilder& builder, const Call& call, const FunctionPointer& function) {
        const size_t number = size_t(function->getArgumentSize());
        requireArguments(call, number, number);
        return builder.curve(std::make_shared<FunctionCurve>(function), requireScalar(call, 0),
                             requireScalar(call, number - 1));
    }

    void addFunction(const std::string& given, const FunctionPointer& function) {
        const std::string name = toUpperCase(given), element = fmt::format("function {}", quote(given));
        const auto isTaken = [&name](const std::vector<std::string>& names) {
            return std::find(names.begin(), names.end(), name) != names.end();
        };
        if (!function) throw Error(element, "it is a null pointer");
        if (isTaken(getLanguageNames()) || isTaken(getNames()))
            throw Error(element, "the name is taken; small and capital letters are the same");
        if (function->getArgumentSize() < 1 || function->getArgumentSize() > 2)
            throw Error(element, fmt::format("it takes {} arguments; it must take 1 or 2",
                                             function->getArgumentSize()));
        m_functions[name] = function;
    }

    const std::string* findVariable(int id) const override {
        const auto found = m_definitions.variables.find(id);
        return found == m_definitions.variables.end() ? nullptr : &found->second;
    }

    const ExpressionDefinitions& m_definitions;
    std::map<std::string, FunctionPointer> m_functions;  // by name in upper case
};

}  // namespace

Expression::Expression(const std::string& text, const std::map<int, Marker>& markers,
                       const ExpressionDefinitions& definitions) {
    const auto find = [&markers](int id) {
        const auto found = markers.find(id);
        return found == markers.end() ? nullptr : &found->second;
    };
    ProgramBuilder builder;
    MarkerFrames frames(builder, find, {});
    DefinedVocabulary vocabulary(frames, definitions);
    try {
        m_expression = std::make_shared<const MarkerExpression>(
            frames.finish(compileExpression(text, builder, vocabulary)));
    } catch (const ExpressionError& error) {
        throw Error(fmt::format("expression \"{}\"", text),
                    fmt::format("column {}: {}", error.offset + 1, error.what()));
    }
}

Expression Expression::ofTime(const FunctionPointer& function) {
    const char* const element = "function of TIME";
    if (!function) throw Error(element, "it is a null pointer");
    if (function->getArgumentSize() != 1)
        throw Error(element,
                    fmt::format("it takes {} arguments; it must take 1", function->getArgumentSize()));
    return Expression("F(TIME)", {}, {{}, {}, {{"F", function}}});
}

bool Expression::isVector() const {
    return m_expression->program.isVector();
}

// Loads that only a State can tell count as accelerations.
Stage Expression::getDependsOnStage() const {
    const Program& program = m_expression->program;
    switch (program.getLevel()) {
        case KinematicLevel::Acceleration: return Stage::Acceleration;
        case KinematicLevel::Velocity: return Stage::Velocity;
        default: break;
    }
    return getMarkers().empty() ? Stage::Time : Stage::Position;
}

bool Expression::dependsOnTime() const {
    return m_expression->program.getTimeInput() >= 0;
}

bool Expression::isLinearInVelocity() const {
    return m_expression->program.isLinearInVelocity();
}

std::vector<int> Expression::getMarkers() const {
    std::vector<int> ids;
    for (size_t k = 0; k < m_expression->vectorInputs.size(); ++k)
        if (m_expression->program.usesVectorInput(int(k)))
            ids.push_back(m_expression->markerIds[size_t(m_expression->vectorInputs[k].marker)]);
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

Real Expression::calcValue(const State& state) const {
    if (isVector()) throw Error("Expression::calcValue()", "the expression is a vector; use calcVector()");
    Evaluation evaluation(m_expression->program);
    m_expression->setInputs(state, evaluation);
    return evaluation.calcValue();
}

Vec3 Expression::calcVector(const State& state) const {
    if (!isVector()) throw Error("Expression::calcVector()", "the expression is a number; use calcValue()");
    Evaluation evaluation(m_expression->program);
    m_expression->setInputs(state, evaluation);
    return evaluation.calcVectorValue();
}

}  // namespace jprim
