// SPDX-License-Identifier: Apache-2.0
#include "jprim/dataset/read_dataset.h"

#include "base/format.h"
#include "base/read_file.h"
#include "base/sort_diagnostics.h"
#include "base/text.h"
#include "dataset/language/read_state.h"
#include "dataset/language/statement_lexer.h"
#include "dataset/statement_kind.h"

namespace jprim {
namespace {

const StatementKind* findKind(std::string_view keyword) {
    const std::vector<StatementKind>& kinds = getStatementKinds();
    const WordMatch match = findWord(kinds, keyword);
    return match.found ? &kinds[match.index] : nullptr;
}

void readStatement(ReadState& state, const StatementText& statement) {
    StatementReader reader(state, statement);
    const std::string_view keyword = reader.readKeyword();
    if (reader.hasErrors()) return;
    const StatementKind* const kind = findKind(keyword);
    if (keyword.size() == 3 && startsWith("END", keyword)) {
        reader.addError(0, "END stands alone; it takes no id and no arguments");
    } else if (!kind) {
        reader.addError(0, fmt::format("unknown statement {}{}", quote(keyword),
                                       suggestWord(getStatementKinds(), keyword)));
    } else if (!kind->read) {
        reader.addError(0, fmt::format("{} is not supported yet", kind->name));
    } else if (reader.readHead(kind->name, kind->hasId)) {
        kind->read(reader);
    }
}

// The title is never a statement, but a file without a title would lose its first one unseen.
void checkTitle(std::string_view title, Diagnostics& diagnostics) {
    const std::size_t slash = title.find('/');
    if (slash == title.npos || slash == 0) return;
    const StatementKind* const kind = findKind(title.substr(0, slash));
    const bool digit = slash + 1 < title.size() && isDigit(title[slash + 1]);
    if (!kind || (kind->hasId && !digit)) return;  // "M/S rod" is a title like any other
    diagnostics.push_back(
        {Severity::Warning,
         {1, 1},
         fmt::format("the first line is the title, so {} is not read as a statement", quote(title))});
}

void checkEnd(ReadState& state, bool ended, SourcePosition end) {
    if (state.ground.line == 0 && !state.partFailed)
        state.diagnostics.push_back({Severity::Error, end, "there is no ground part; add PART/1, GROUND"});
    if (!ended) state.diagnostics.push_back({Severity::Warning, end, "the END statement is missing"});
}

StatementCounts countOutcomes(const std::vector<Outcome>& outcomes) {
    StatementCounts counts;
    for (const Outcome outcome : outcomes) {
        if (outcome == Outcome::Built) ++counts.built;
        if (outcome == Outcome::Ignored) ++counts.ignored;
        if (outcome == Outcome::Error) ++counts.errors;
    }
    return counts;
}

std::map<std::string, std::set<int>> findFaulty(const ReadState& state) {
    std::map<std::string, std::set<int>> faulty;
    for (const auto& [keyword, ids] : state.ids)
        for (const auto& [id, entry] : ids)
            if (state.outcomes[entry.statement] == Outcome::Error) faulty[std::string(keyword)].insert(id);
    return faulty;
}

}  // namespace

Dataset readDataset(std::string_view text, Diagnostics& diagnostics) {
    const std::size_t earlier = diagnostics.size();
    ReadState state(diagnostics);
    StatementLexer lexer(text);
    state.dataset.title = std::string(lexer.takeLine());
    checkTitle(state.dataset.title, diagnostics);
    StatementText statement;
    bool ended = false;
    while (!ended && lexer.next(statement)) {
        ended = isEnd(statement.text);
        if (!ended) readStatement(state, statement);
    }
    checkReferences(state);
    checkJointUses(state);
    checkEnd(state, ended, ended ? statement.getPosition(0) : lexer.getPosition());
    sortByPosition(earlier, diagnostics);
    state.dataset.counts = countOutcomes(state.outcomes);
    state.dataset.faulty = findFaulty(state);
    return std::move(state.dataset);
}

Dataset readDatasetFile(const std::string& path, Diagnostics& diagnostics) {
    return readFrom(path, diagnostics, readDataset);
}

}  // namespace jprim
