// SPDX-License-Identifier: Apache-2.0
// REQUEST: what to write out.
#include "base/format.h"
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = RequestStatement;

const SpellingTable<RequestType>& getTypes() {
    using T = RequestType;
    static const SpellingTable<T> types = {{T::Displacement, "DISPLACEMENT"},
                                           {T::Velocity, "VELOCITY"},
                                           {T::Acceleration, "ACCELERATION"},
                                           {T::Force, "FORCE"}};
    return types;
}

// The type is written always, but for Expressions, which no word says.
std::vector<Field<S>> typeFields() {
    std::vector<Field<S>> fields = choice(getTypes(), &S::type);
    fields.front().write = [](StatementWriter& writer, const S& s) {
        writer.add(getTypes().getName(s.type));
    };
    return fields;
}

// F1 to F8; the first of them writes and compares all.
std::vector<Field<S>> expressionFields() {
    constexpr std::string_view names[] = {"F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8"};
    std::vector<Field<S>> fields;
    int number = 0;
    for (const std::string_view name : names)
        fields.emplace_back(ArgumentRule(name, Kind::Expression, ExactOnly),
                            [number = ++number](S& s, const ArgumentValue& given) {
                                s.expressions.emplace_back(number, given.expression);
                            });
    fields.front().write = [](StatementWriter& writer, const S& s) {
        for (const auto& [number, expression] : s.expressions)
            writer.addExpression(fmt::format("F{}", number), expression.text);
    };
    fields.front().equal = [](const S& a, const S& b) { return a.expressions == b.expressions; };
    return fields;
}

constexpr ArgumentRule names(std::string_view name) {
    constexpr std::size_t components = 8;
    return ArgumentRule(name, Kind::Names, 2).of(1, components);
}

Field<S> resultsNameField() {
    Field<S> name = field({"RESULTS_NAME", Kind::Names, 3}, &S::resultsName);
    name.write = [](StatementWriter& writer, const S& s) {
        if (!s.resultsName.empty()) writer.add("RESULTS_NAME", std::vector<std::string>{s.resultsName});
    };
    return name;
}

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {typeFields(),
                                         field({"I", Kind::Marker, ExactOnly}, &S::i),
                                         field({"J", Kind::MarkerOrZero, ExactOnly}, &S::j),
                                         field({"RM", Kind::MarkerOrZero, ExactOnly}, &S::rm),
                                         field({"COMMENT", Kind::Text}, &S::comment),
                                         field({"TITLE", Kind::Text}, &S::title),
                                         field(names("CUNITS"), &S::cunits),
                                         field(names("CNAMES"), &S::cnames),
                                         field(names("CLABELS"), &S::clabels),
                                         field(names("CTITLE"), &S::ctitle),
                                         resultsNameField(),
                                         expressionFields(),
                                         ArgumentRule("VARIABLES", Kind::Unsupported, 3),
                                         ArgumentRule("ROUTINE", Kind::Unsupported, 3),
                                         subroutineRule()};
    return fields;
}

void check(StatementReader& reader, S& request) {
    const bool hasType = reader.has(Kind::Choice);
    const bool hasExpressions = !request.expressions.empty();
    if (hasType && hasExpressions)
        reader.addError(0, fmt::format("{} takes {} or expressions F1 to F8, not both", reader.getName(),
                                       getAdamsName(request.type)));
    else if (!hasType && !hasExpressions)
        reader.addError(0, fmt::format("{} needs DISPLACEMENT, VELOCITY, ACCELERATION, FORCE or "
                                       "expressions F1 to F8",
                                       reader.getName()));
    else
        reader.checkNeeded("I", hasType);
    if (hasExpressions) request.type = RequestType::Expressions;
}

}  // namespace

StatementKind describeRequest() {
    return makeKind("REQUEST", 1, getFields(), &Dataset::requests, check);
}

const char* getAdamsName(RequestType type) {
    return type == RequestType::Expressions ? "EXPRESSIONS" : getTypes().getName(type).data();
}

}  // namespace jprim
