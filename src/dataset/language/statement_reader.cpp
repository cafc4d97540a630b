// SPDX-License-Identifier: Apache-2.0
// A statement as a whole: its keyword, its id, its messages. The arguments are in argument_reader.cpp.
#include "dataset/language/statement_reader.h"

#include <algorithm>

#include "base/format.h"
#include "base/numbers.h"
#include "base/text.h"

namespace jprim {

StatementReader::StatementReader(ReadState& state, const StatementText& statement)
    : m_state(state), m_statement(statement), m_text(statement.text), m_number(state.outcomes.size()) {
    state.outcomes.push_back(Outcome::Built);
}

std::string StatementReader::getName() const {
    return m_id == 0 ? std::string(m_keyword) : fmt::format("{}/{}", m_keyword, m_id);
}

SourcePosition StatementReader::getPosition() const {
    return m_statement.getPosition(0);
}

void StatementReader::addError(std::size_t offset, std::string message) {
    ++m_errors;
    m_state.addError(m_number, m_statement.getPosition(offset), std::move(message));
}

void StatementReader::addWarning(std::size_t offset, std::string message) {
    m_state.diagnostics.push_back({Severity::Warning, m_statement.getPosition(offset), std::move(message)});
}

void StatementReader::skipBlanks() {
    while (!atEnd() && isBlank(m_text[m_at])) ++m_at;
}

std::string_view StatementReader::readWord() {
    const std::size_t begin = m_at;
    while (!atEnd() && isWordCharacter(m_text[m_at])) ++m_at;
    return m_text.substr(begin, m_at - begin);
}

std::string_view StatementReader::readKeyword() {
    const std::string_view keyword = readWord();
    skipBlanks();
    if (keyword.empty() && !atEnd() && isComma(m_text[m_at]))
        addError(0, "a line that begins with a comma continues a statement, but none is open here");
    else if (keyword.empty())
        addError(0, quote(takeItem()) + " does not begin a statement; one begins with KEYWORD/");
    else if (!atEnd() && m_text[m_at] == '/')
        ++m_at;
    else
        addError(m_at, fmt::format("a slash is missing after {}", quote(keyword)));
    return keyword;
}

bool StatementReader::readHead(std::string_view fullKeyword, bool hasId) {
    m_keyword = fullKeyword;
    std::size_t ampersand = 0;
    while (ampersand < m_text.size() && m_text[ampersand] != '&')
        ampersand = std::max(ampersand + 1, skipQuotes(m_text, ampersand));
    if (ampersand < m_text.size()) {
        addError(ampersand, "'&' may only end a line, to continue it on the next");
        return false;
    }
    skipBlanks();
    if (hasId) {
        const std::size_t begin = m_at;
        while (!atEnd() && !isComma(m_text[m_at]) && !isBlank(m_text[m_at])) ++m_at;
        const Number<int> id = parseId(m_text.substr(begin, m_at - begin), 1);
        if (id.fault.empty())
            m_id = id.value;
        else
            addError(begin, fmt::format("id of {}: {}", m_keyword, id.fault));
    }
    skipBlanks();
    if (atEnd()) return true;
    m_comma = isComma(m_text[m_at]);
    if (m_comma)
        ++m_at;
    else if (hasId)
        addError(m_at, fmt::format("a comma is missing after {}", getName()));
    return true;
}

void StatementReader::registerId(const Owner& owner, bool floating) {
    if (m_id == 0) return;
    const SourcePosition here = getPosition();
    const auto [entry, isNew] =
        m_state.ids[m_keyword].try_emplace(m_id, IdEntry{m_number, here.line, owner, floating});
    if (!isNew)
        addError(0, fmt::format("{} is already given in line {}; choose another id", getName(),
                                entry->second.line));
}

void StatementReader::addSecond(int line) {
    addError(0, fmt::format("{} is already given in line {}; it may stand once", m_keyword, line));
}

void StatementReader::allowAnyOwner() {
    auto reference = m_state.references.rbegin();
    for (; reference != m_state.references.rend() && reference->statement == m_number; ++reference)
        reference->anyOwner = true;
}

void StatementReader::useJoints(std::string_view name, const std::vector<CouplerType>& coordinates,
                                const char* remedy) {
    std::size_t first = m_state.references.size(), k = 0;
    while (first > 0 && m_state.references[first - 1].statement == m_number) --first;
    for (; first < m_state.references.size(); ++first) {
        const Reference& reference = m_state.references[first];
        if (reference.rule->name != name) continue;
        std::optional<CouplerType> coordinate;
        if (!coordinates.empty()) coordinate = coordinates[k++];
        const bool isOnly = reference.rule->most == 1;
        const SourcePosition where = isOnly ? m_statement.getPosition(getOffset(name)) : reference.where;
        m_state.jointUses.push_back(
            {m_number, fmt::format("{} of {}", name, getName()), reference.id, coordinate, where, remedy});
    }
}

std::string StatementReader::readRawArguments() {
    std::string result;
    while (!atEnd()) {
        const std::string item = collapseBlanks(takeItem());
        if (item.empty()) continue;
        if (!result.empty()) result += ", ";
        result += item;
    }
    return result;
}

const StatementReader::Given* StatementReader::findGiven(std::string_view name) const {
    const auto found =
        std::find_if(m_given.begin(), m_given.end(), [&](const Given& g) { return g.rule->name == name; });
    return found == m_given.end() ? nullptr : &*found;
}

std::size_t StatementReader::getOffset(std::string_view name) const {
    const Given* const given = findGiven(name);
    return given ? given->offset : 0;
}

bool StatementReader::has(ArgumentKind kind) const {
    return std::any_of(m_given.begin(), m_given.end(), [&](const Given& g) { return g.rule->kind == kind; });
}

}  // namespace jprim
