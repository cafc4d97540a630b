// SPDX-License-Identifier: Apache-2.0
// A command file: two names, then one command after the other. What each says is read in command_rules.cpp.
#include <utility>

#include "base/format.h"
#include "base/read_file.h"
#include "base/sort_diagnostics.h"
#include "base/text.h"
#include "dataset/commands/command_rules.h"
#include "dataset/language/statement_lexer.h"
#include "dataset/statement_kind.h"
#include "dataset/statements/ignored.h"

namespace jprim {
namespace {

const CommandRule* findRule(std::string_view keyword) {
    const std::vector<CommandRule>& rules = getCommandRules();
    const WordMatch match = findWord(rules, keyword);
    return match.found ? &rules[match.index] : nullptr;
}

// The command that a line begins with, or null.
const CommandRule* findCommand(std::string_view line) {
    const std::size_t slash = line.find('/');
    return slash == line.npos || slash == 0 ? nullptr : findRule(trim(line.substr(0, slash)));
}

// A statement of a dataset that changes no motion may be given as a command, too.
const StatementKind* findIgnored(std::string_view keyword) {
    const std::vector<StatementKind>& kinds = getStatementKinds();
    const WordMatch match = findWord(kinds, keyword);
    const bool ignored = match.found && kinds[match.index].isIgnored && !kinds[match.index].hasId;
    return ignored ? &kinds[match.index] : nullptr;
}

// Commands of Adams that a dataset has no statement for. The first of them only tell or show something.
constexpr std::size_t NumTelling = 6;
const std::vector<Word>& getOtherCommands() {
    static const std::vector<Word> words = {
        {"HELP", 2},       {"INFO", 3},        {"LIST", 3},          {"MENU", 3},    {"SHOW", 2},
        {"TIME", 3},       {"CONTROL", 5},     {"LINEAR", 3},        {"SAVE", 2},    {"RELOAD", 3},
        {"RETURN", 3},     {"SET", ExactOnly}, {"ACENTER", 2},       {"AINIT", 2},   {"AUTOSCALE", 2},
        {"BACKUP", 2},     {"CENTER", 2},      {"CLEAR", ExactOnly}, {"DISPLAY", 3}, {"DRAW", 2},
        {"DT", ExactOnly}, {"ERASE", 2},       {"EXECUTION", 3},     {"PLOT", 2}};
    return words;
}

constexpr const char* Supported = "supported are FILE, SIMULATE, ACTIVATE, DEACTIVATE, STOP and EXIT";

// A word that is no command here: one of Adams, or none at all.
void rejectCommand(StatementReader& reader, std::string_view keyword) {
    const WordMatch other = findWord(getOtherCommands(), keyword);
    const WordMatch statement = findWord(getStatementKinds(), keyword);
    const std::string_view known = other.found       ? getOtherCommands()[other.index].name
                                   : statement.found ? getStatementKinds()[statement.index].name
                                                     : "";
    if (other.found && other.index < NumTelling)
        reader.addWarning(0, fmt::format("{} is not supported and is left out; it changes no motion", known));
    else if (isWordAlone(keyword, "STOP") || isWordAlone(keyword, "EXIT"))
        reader.addError(0, fmt::format("{} stands alone; it takes no arguments", toUpperCase(keyword)));
    else if (!known.empty())
        reader.addError(0, fmt::format("{} is not supported in a command file; {}", known, Supported));
    else
        reader.addError(0, fmt::format("{} is not a command; {}{}", quote(keyword), Supported,
                                       suggestWord(getCommandRules(), keyword)));
}

void readCommand(ReadState& state, CommandState& commands, const StatementText& statement) {
    StatementReader reader(state, statement);
    const std::string_view keyword = reader.readKeyword();
    if (reader.hasErrors()) return;
    if (const CommandRule* const rule = findRule(keyword)) {
        if (reader.readHead(rule->name, false)) rule->read(reader, commands);
    } else if (const StatementKind* const ignored = findIgnored(keyword)) {
        if (reader.readHead(ignored->name, false)) readIgnored(reader);
    } else {
        rejectCommand(reader, keyword);
    }
}

bool saysNothing(std::string_view line) {
    const std::string_view text = trim(line);
    return text.empty() || text.front() == '!';
}

// A name is never a command, but a file without names would lose its first commands unseen.
std::string takeName(std::string_view line, SourcePosition where, const char* what,
                     Diagnostics& diagnostics) {
    if (findCommand(line))
        diagnostics.push_back(
            {Severity::Warning, where,
             fmt::format("this line names the {}, so {} is not read as a command", what, quote(line))});
    return std::string(trim(line.substr(0, line.find('!'))));
}

// The first line that says something names the model, unless it is a FILE command, which then is left to be
// read. The next line names the output; it may be blank.
void readNames(StatementLexer& lexer, CommandState& commands, Diagnostics& diagnostics) {
    StatementLexer ahead = lexer;
    std::string_view line = ahead.takeLine();
    while (saysNothing(line) && !ahead.atEnd()) {
        lexer = ahead;
        line = ahead.takeLine();
    }
    const CommandRule* const rule = findCommand(line);
    if (saysNothing(line) || (rule && rule->name == "FILE")) return;
    commands.modelLine = lexer.getPosition().line;
    commands.file.model = takeName(line, lexer.getPosition(), "model", diagnostics);
    const SourcePosition where = ahead.getPosition();
    line = ahead.takeLine();
    if (!saysNothing(line)) commands.file.output = takeName(line, where, "output", diagnostics);
    lexer = ahead;
}

bool isStop(std::string_view text) {
    return isWordAlone(text, "STOP") || isWordAlone(text, "EXIT");
}

}  // namespace

CommandFile readCommands(std::string_view text, Diagnostics& diagnostics) {
    const std::size_t earlier = diagnostics.size();
    ReadState state(diagnostics);
    CommandState commands;
    StatementLexer lexer(text);
    readNames(lexer, commands, diagnostics);
    StatementText statement;
    while (lexer.next(statement) && !isStop(statement.text)) readCommand(state, commands, statement);
    CommandFile& file = commands.file;
    if (commands.modelLine == 0)
        diagnostics.push_back(
            {Severity::Error, {1, 1}, "no model is named; the first line may do it, or FILE/MODEL="});
    sortByPosition(earlier, diagnostics);
    if (file.output.empty()) file.output = file.model;
    file.ignored = std::move(state.dataset.ignored);
    return std::move(file);
}

CommandFile readCommandFile(const std::string& path, Diagnostics& diagnostics) {
    return readFrom(path, diagnostics, readCommands);
}

}  // namespace jprim
