// SPDX-License-Identifier: Apache-2.0
// REQUEST: what to write out.
#include <utility>

#include "base/format.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using R = RequestStatement;
using V = ArgumentValue;

// The four types come first, in the order of RequestType, then F1 to F8.
constexpr std::size_t FirstExpressionRow = 4;

void setType(R& r, const V& v) {
    r.type = static_cast<RequestType>(v.row);
}

void addExpression(R& r, const V& v) {
    r.expressions.emplace_back(static_cast<int>(v.row - FirstExpressionRow) + 1, v.expression);
}

constexpr ArgumentRule expression(std::string_view name) {
    return ArgumentRule(name, Kind::Expression, ExactOnly);
}

constexpr ArgumentRule names(std::string_view name) {
    constexpr std::size_t Components = 8;
    return ArgumentRule(name, Kind::Names, 2).of(1, Components);
}

const ArgumentTable<R>& getRequestTable() {
    static const ArgumentTable<R> table = {
        {{"DISPLACEMENT", Kind::Choice}, setType},
        {{"VELOCITY", Kind::Choice}, setType},
        {{"ACCELERATION", Kind::Choice}, setType},
        {{"FORCE", Kind::Choice}, setType},
        {expression("F1"), addExpression},
        {expression("F2"), addExpression},
        {expression("F3"), addExpression},
        {expression("F4"), addExpression},
        {expression("F5"), addExpression},
        {expression("F6"), addExpression},
        {expression("F7"), addExpression},
        {expression("F8"), addExpression},
        {{"I", Kind::Marker, ExactOnly}, [](R& r, const V& v) { r.i = v.getId(); }},
        {{"J", Kind::MarkerOrZero, ExactOnly}, [](R& r, const V& v) { r.j = v.getId(); }},
        {{"RM", Kind::MarkerOrZero, ExactOnly}, [](R& r, const V& v) { r.rm = v.getId(); }},
        {{"COMMENT", Kind::Text}, [](R& r, const V& v) { r.comment = v.text; }},
        {{"TITLE", Kind::Text}, [](R& r, const V& v) { r.title = v.text; }},
        {names("CNAMES"), [](R& r, const V& v) { r.cnames = v.names; }},
        {names("CUNITS"), [](R& r, const V& v) { r.cunits = v.names; }},
        {names("CLABELS"), [](R& r, const V& v) { r.clabels = v.names; }},
        {names("CTITLE"), [](R& r, const V& v) { r.ctitle = v.names; }},
        {{"RESULTS_NAME", Kind::Names, 3}, [](R& r, const V& v) { r.resultsName = v.names[0]; }},
        {{"VARIABLES", Kind::Unsupported, 3}, nullptr},
        {{"ROUTINE", Kind::Unsupported, 3}, nullptr},
        {{"FUNCTION", Kind::Subroutine, 2}, nullptr}};
    return table;
}

void checkForm(StatementReader& reader, const R& request) {
    const bool hasType = reader.has(Kind::Choice);
    const bool hasExpressions = !request.expressions.empty();
    if (hasType && hasExpressions)
        reader.addError(0, fmt::format("{} takes {} or expressions F1 to F8, not both", reader.getName(),
                                       getAdamsName(request.type)));
    else if (!hasType && !hasExpressions)
        reader.addError(0, fmt::format("{} needs DISPLACEMENT, VELOCITY, ACCELERATION, FORCE or "
                                       "expressions F1 to F8",
                                       reader.getName()));
    else if (hasType && request.i == 0)
        reader.addError(0, fmt::format("{} needs I: I=", reader.getName()));
}

}  // namespace

void readRequest(StatementReader& reader) {
    RequestStatement request;
    if (reader.readStatement(getRequestTable(), request)) checkForm(reader, request);
    if (!request.expressions.empty()) request.type = RequestType::Expressions;
    if (!reader.hasErrors()) reader.updState().dataset.requests.push_back(std::move(request));
}

}  // namespace jprim
