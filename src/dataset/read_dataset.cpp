// SPDX-License-Identifier: Apache-2.0
#include "jprim/dataset/read_dataset.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <tuple>

#include "dataset/read_state.h"
#include "dataset/statement_lexer.h"
#include "dataset/statement_reader.h"
#include "dataset/statements.h"
#include "dataset/text.h"

namespace jprim {
namespace {

const StatementRule* findRule(std::string_view keyword) {
    const std::vector<StatementRule>& rules = getStatementRules();
    const WordMatch match = findWord(rules, keyword);
    return match.found ? &rules[match.index] : nullptr;
}

void readStatement(ReadState& state, const Statement& statement) {
    StatementReader reader(state, statement);
    const std::string_view keyword = reader.readKeyword();
    if (reader.hasErrors()) return;
    const StatementRule* const rule = findRule(keyword);
    const std::size_t ampersand = statement.text.find('&');
    if (keyword.size() == 3 && startsWith("END", keyword)) {
        reader.addError(0, "END stands alone; it takes no id and no arguments");
    } else if (!rule) {
        reader.addError(0, fmt::format("unknown statement {}{}", quote(keyword),
                                       suggestWord(getStatementRules(), keyword)));
    } else if (!rule->read) {
        reader.addError(0, fmt::format("{} is not supported yet", rule->name));
    } else if (ampersand != std::string::npos) {
        reader.addError(ampersand, "'&' may only end a line, to continue it on the next");
    } else {
        reader.readHead(rule->name, rule->hasId);
        rule->read(reader);
    }
}

// The title is never a statement, but a file without a title would lose its first one unseen.
void checkTitle(std::string_view title, Diagnostics& diagnostics) {
    const std::size_t slash = title.find('/');
    if (slash == title.npos || slash == 0) return;
    const StatementRule* const rule = findRule(title.substr(0, slash));
    const bool digit = slash + 1 < title.size() && isDigit(title[slash + 1]);
    if (!rule || (rule->hasId && !digit)) return;  // "M/S rod" is a title like any other
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

// References are checked last, but belong where they stand.
void sortFrom(std::size_t first, Diagnostics& diagnostics) {
    std::stable_sort(diagnostics.begin() + static_cast<std::ptrdiff_t>(first), diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) {
                         return std::tie(a.where.line, a.where.column) <
                                std::tie(b.where.line, b.where.column);
                     });
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

}  // namespace

Dataset readDataset(std::string_view text, Diagnostics& diagnostics) {
    const std::size_t earlier = diagnostics.size();
    ReadState state(diagnostics);
    StatementLexer lexer(text);
    state.dataset.title = std::string(lexer.getTitle());
    checkTitle(lexer.getTitle(), diagnostics);
    Statement statement;
    bool ended = false;
    while (!ended && lexer.next(statement)) {
        ended = isEnd(statement.text);
        if (!ended) readStatement(state, statement);
    }
    checkReferences(state);
    checkEnd(state, ended, ended ? statement.getPosition(0) : lexer.getEnd());
    sortFrom(earlier, diagnostics);
    state.dataset.counts = countOutcomes(state.outcomes);
    return std::move(state.dataset);
}

Dataset readDatasetFile(const std::string& path, Diagnostics& diagnostics) {
    std::error_code code;  // a folder has no size, although it can be opened
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    std::ifstream file(path, std::ios::binary);
    std::string text(code ? 0 : static_cast<std::size_t>(size), '\0');
    if (!code) file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (code || !file) {
        diagnostics.push_back({Severity::Error, {}, "cannot read the file; check its name and permissions"});
        return {};
    }
    Dataset dataset = readDataset(text, diagnostics);
    dataset.folder = std::filesystem::path(path).parent_path().string();
    return dataset;
}

}  // namespace jprim
