// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_DATASET_READER_PROPERTIES_H_
#define JPRIM_TESTS_DATASET_READER_PROPERTIES_H_

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/language/statement_lexer.h"
#include "jprim/dataset/read_dataset.h"
#include "jprim/dataset/write_dataset.h"

/// @file
/// What must hold for every text whatsoever; shared by the fuzzer and by the tests.
namespace jprim {

/// The statements of a text up to END, counted without the reader.
inline int countStatements(std::string_view text) {
    StatementLexer lexer(text);
    lexer.takeLine();
    StatementText statement;
    int count = 0;
    while (lexer.next(statement) && !isEnd(statement.text)) ++count;
    return count;
}

/// The members of a dataset that came from a statement that was built.
inline std::size_t countMembers(const Dataset& d) {
    return d.parts.size() + d.pointMasses.size() + d.flexBodies.size() + d.markers.size() + d.jprims.size() +
           d.joints.size() + d.gcons.size() + d.motions.size() + d.couplers.size() + d.sforces.size() +
           d.vectorForces.size() + d.springdampers.size() + d.bushings.size() + d.variables.size() +
           d.splines.size() + d.arrays.size() + d.matrices.size() + d.diffs.size() + d.lses.size() +
           d.tfsisos.size() + d.plantInputs.size() + d.plantOutputs.size() + d.sensors.size() +
           d.requests.size() + d.graphics.size() + (d.units ? 1u : 0u) + (d.gravity ? 1u : 0u);
}

/// Every expression of a dataset.
inline std::vector<ExpressionText> listExpressions(const Dataset& d) {
    std::vector<ExpressionText> all;
    const auto addFunctions = [&all](const auto& statements) {
        for (const auto& statement : statements) all.push_back(statement.function);
    };
    addFunctions(d.gcons);
    addFunctions(d.motions);
    addFunctions(d.sforces);
    addFunctions(d.variables);
    addFunctions(d.diffs);
    addFunctions(d.sensors);
    for (const SensorStatement& sensor : d.sensors)
        if (sensor.evaluate) all.push_back(*sensor.evaluate);
    for (const VectorForceStatement& force : d.vectorForces) {
        for (const auto& component : force.components) all.push_back(component.value_or(ExpressionText{}));
        all.push_back(force.fxyz.value_or(ExpressionText{}));
        all.push_back(force.txyz.value_or(ExpressionText{}));
    }
    for (const RequestStatement& request : d.requests)
        for (const auto& [number, expression] : request.expressions) all.push_back(expression);
    return all;
}

/// True if each character of the expression, other than a space, stands in the text where it says.
inline bool standsWhereItSays(const ExpressionText& expression, const std::vector<std::string_view>& lines) {
    for (std::size_t i = 0; i < expression.text.size(); ++i) {
        const SourcePosition where = expression.getPosition(i);
        if (expression.text[i] == ' ') continue;
        if (where.line < 1 || static_cast<std::size_t>(where.line) > lines.size()) return false;
        const std::string_view line = lines[static_cast<std::size_t>(where.line) - 1];
        const std::size_t column = static_cast<std::size_t>(where.column) - 1;
        if (column >= line.size() || line[column] != expression.text[i]) return false;
    }
    return true;
}

inline std::vector<std::string_view> splitLines(std::string_view text) {
    std::vector<std::string_view> lines;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

/// What is wrong with the positions of diagnostics about this text; empty if nothing is.
inline std::string findMisplaced(std::string_view text, const Diagnostics& diagnostics) {
    const int lines = static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
    SourcePosition last;
    for (const Diagnostic& d : diagnostics) {
        if (d.where.line < 1 || d.where.line > lines || d.where.column < 1) return "a position lies outside";
        if (d.where.line < last.line || (d.where.line == last.line && d.where.column < last.column))
            return "the diagnostics are not in the order of the file";
        last = d.where;
    }
    return {};
}

/// The first property that the reader breaks on this text; empty if it keeps them all.
inline std::string findBrokenProperty(std::string_view text) {
    Diagnostics diagnostics;
    const Dataset dataset = readDataset(text, diagnostics);
    const StatementCounts& counts = dataset.counts;
    if (counts.built + counts.ignored + counts.errors != countStatements(text))
        return "the counts do not add up to the statements";
    if (counts.errors > 0 && !hasErrors(diagnostics)) return "an error was counted but not reported";

    const std::string misplaced = findMisplaced(text, diagnostics);
    if (!misplaced.empty()) return misplaced;
    const std::vector<std::string_view> textLines = splitLines(text);
    for (const ExpressionText& expression : listExpressions(dataset))
        if (!standsWhereItSays(expression, textLines)) return "an expression does not stand where it says";
    if (hasErrors(diagnostics)) return {};

    if (countMembers(dataset) != static_cast<std::size_t>(counts.built))
        return "not every built statement is a member";
    const std::string written = writeDataset(dataset);
    Diagnostics again;
    const Dataset reread = readDataset(written, again);
    if (hasErrors(again)) return "the written dataset has an error: " + formatDiagnostic("", again.front());
    if (reread != dataset) return "the written dataset reads differently:\n" + written;
    if (writeDataset(reread) != written) return "writing twice gives two texts";
    return {};
}

}  // namespace jprim

#endif
