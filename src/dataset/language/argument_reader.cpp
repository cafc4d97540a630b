// SPDX-License-Identifier: Apache-2.0
// The arguments of a statement, by its table of rules. What stands after an equals sign is read in
// argument_values.cpp.
#include "base/format.h"
#include "base/text.h"
#include "dataset/language/statement_reader.h"

namespace jprim {
namespace {

constexpr std::size_t NoRow = static_cast<std::size_t>(-1);

}  // namespace

std::string StatementReader::describe(const ArgumentRule& rule) const {
    return fmt::format("{} of {}", rule.name, getName());
}

// Everything up to the next comma, which is passed too.
std::string_view StatementReader::takeItem() {
    const std::size_t begin = m_at;
    m_at = findItemEnd(m_text, m_at);
    const std::string_view item = trim(m_text.substr(begin, m_at - begin));
    m_comma = !atEnd();
    if (m_comma) ++m_at;
    return item;
}

// After a mistake: to the next argument. What looks like a number still belongs to this one.
void StatementReader::skipArgument() {
    do {
        takeItem();
        skipBlanks();
    } while (!atEnd() && !isLetter(m_text[m_at]));
}

// False if nothing follows. Empty arguments are reported once for each row of commas.
bool StatementReader::beginArgument() {
    if (m_errors >= MostErrors) return false;
    skipBlanks();
    if (!atEnd() && isComma(m_text[m_at])) {
        addError(m_at, fmt::format("an argument of {} is empty; there is a comma too many", getName()));
        while (!atEnd() && (isComma(m_text[m_at]) || isBlank(m_text[m_at]))) ++m_at;
    } else if (atEnd() && m_comma) {
        addError(m_at - 1, fmt::format("{} ends in a comma; an argument is missing", getName()));
    }
    return !atEnd();
}

const ArgumentRule* StatementReader::readArgumentName(std::size_t& offset) {
    offset = m_at;
    std::string_view name = readWord();
    skipBlanks();
    const bool ends = atEnd() || isComma(m_text[m_at]) || m_text[m_at] == '=';
    if (name.empty() || !ends) {
        const std::size_t at = m_at;
        if (!name.empty())
            addError(at, fmt::format("a comma or '=' is missing after {} in {}", quote(name), getName()));
        else
            addError(at, fmt::format("{} is not an argument of {}", quote(takeItem()), getName()));
        return nullptr;
    }
    const WordMatch match = findWord(*m_rules, name);
    if (match.found) return &(*m_rules)[match.index];
    if (!match.rival.empty())
        addError(offset, fmt::format("{} is ambiguous in {}: {} or {}?", quote(name), getName(),
                                     (*m_rules)[match.index].name, match.rival));
    else
        addError(offset, fmt::format("unknown argument {} of {}{}", quote(name), getName(),
                                     suggestWord(*m_rules, name)));
    return nullptr;
}

// An argument may be given once, and of those that exclude each other only one.
bool StatementReader::checkGiven(const ArgumentRule& rule, std::size_t offset) {
    for (const Given& earlier : m_given) {
        const ArgumentRule* const given = earlier.rule;
        if (given == &rule && rule.repeatable) break;
        if (given == &rule)
            addError(offset, fmt::format("{} is given twice", describe(rule)));
        else if (rule.kind == ArgumentKind::Choice && given->kind == ArgumentKind::Choice &&
                 rule.group == given->group)
            addError(offset, fmt::format("{} cannot be both {} and {}", getName(), given->name, rule.name));
        else
            continue;
        return false;
    }
    m_given.push_back({&rule, offset});
    return true;
}

bool StatementReader::readEquals(const ArgumentRule& rule, std::size_t offset) {
    const bool equals = !atEnd() && m_text[m_at] == '=';
    const bool bare = isBare(rule.kind) || (!equals && rule.least == 0);
    m_hasValue = equals;
    if (equals == bare)
        addError(offset, bare ? fmt::format("{} takes no value", describe(rule))
                              : fmt::format("{} needs a value: {}=", describe(rule), rule.name));
    if (equals == bare) return false;
    if (equals) ++m_at;
    skipBlanks();
    return true;
}

bool StatementReader::readArgument(ArgumentValue& value) {
    value.clear();
    value.row = NoRow;
    if (!beginArgument()) return false;
    std::size_t offset = 0;
    const ArgumentRule* const rule = readArgumentName(offset);
    if (rule && rule->kind == ArgumentKind::Unsupported)
        addError(offset, fmt::format("{} is not supported yet", describe(*rule)));
    const bool usable = rule && rule->kind != ArgumentKind::Unsupported;
    if (!usable || !checkGiven(*rule, offset) || !readEquals(*rule, offset)) {
        skipArgument();
        return true;
    }
    value.offset = m_given.back().valueOffset = atEnd() ? offset : m_at;
    const bool isGood = readValue(*rule, value);
    m_given.back().degrees = value.degrees;
    if (isGood) value.row = static_cast<std::size_t>(rule - m_rules->data());
    return true;
}

void StatementReader::checkNotBoth(const char* name, const char* other) {
    if (has(name) && has(other))
        addError(getOffset(name), fmt::format("{} takes {} or {}, not both", getName(), name, other));
}

void StatementReader::checkAllowed(const char* name, bool allowed, const char* owners) {
    if (has(name) && !allowed)
        addError(getOffset(name), fmt::format("{} of {} is for {} only", name, getName(), owners));
}

void StatementReader::checkNeeded(const char* name, bool needed) {
    if (needed && !has(name)) addError(0, fmt::format("{} needs {}: {}=", getName(), name, name));
}

bool StatementReader::checkMandatory() {
    // After an error the missing argument may be the misspelt one.
    if (hasErrors()) return false;
    std::string choices;
    bool chosen = false;
    for (const ArgumentRule& rule : *m_rules) {
        if (!rule.mandatory) continue;
        if (rule.kind == ArgumentKind::Choice) {
            choices += (choices.empty() ? "" : ", ") + std::string(rule.name);
            chosen = chosen || has(rule.name);
        } else if (!has(rule.name))
            addError(0, fmt::format("{} needs {}: {}=", getName(), rule.name, rule.name));
    }
    if (!choices.empty() && !chosen) addError(0, fmt::format("{} needs a type: {}", getName(), choices));
    return !hasErrors();
}

}  // namespace jprim
