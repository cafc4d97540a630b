// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_DATASET_READER_PROPERTIES_H_
#define JPRIM_TESTS_DATASET_READER_PROPERTIES_H_

#include <algorithm>
#include <string>
#include <string_view>

#include "dataset/statement_lexer.h"
#include "jprim/dataset/read_dataset.h"
#include "jprim/dataset/write_dataset.h"

/// @file
/// What must hold for every text whatsoever; shared by the fuzzer and by the tests.
namespace jprim {

/// The statements of a text up to END, counted without the reader.
inline int countStatements(std::string_view text) {
    StatementLexer lexer(text);
    Statement statement;
    int count = 0;
    while (lexer.next(statement) && !isEnd(statement.text)) ++count;
    return count;
}

/// The first property that the reader breaks on this text; empty if it keeps them all.
inline std::string findBrokenProperty(std::string_view text) {
    Diagnostics diagnostics;
    const Dataset dataset = readDataset(text, diagnostics);
    const StatementCounts& counts = dataset.counts;
    if (counts.built + counts.ignored + counts.errors != countStatements(text))
        return "the counts do not add up to the statements";
    if (counts.errors > 0 && !hasErrors(diagnostics)) return "an error was counted but not reported";

    const int lines = static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
    SourcePosition last;
    for (const Diagnostic& d : diagnostics) {
        if (d.where.line < 1 || d.where.line > lines || d.where.column < 1) return "a position lies outside";
        if (d.where.line < last.line || (d.where.line == last.line && d.where.column < last.column))
            return "the diagnostics are not in the order of the file";
        last = d.where;
    }
    if (hasErrors(diagnostics)) return {};

    const std::size_t members = dataset.parts.size() + dataset.flexBodies.size() + dataset.markers.size() +
                                dataset.jprims.size() + dataset.joints.size() + dataset.requests.size() +
                                (dataset.units ? 1u : 0u) + (dataset.gravity ? 1u : 0u);
    if (members != static_cast<std::size_t>(counts.built)) return "not every built statement is a member";
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
