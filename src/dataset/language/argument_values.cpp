// SPDX-License-Identifier: Apache-2.0
// What stands after the equals sign of an argument.
#include <algorithm>

#include "base/format.h"
#include "base/numbers.h"
#include "base/text.h"
#include "dataset/language/statement_reader.h"

namespace jprim {
namespace {

bool isNumeric(ArgumentKind kind) {
    return kind == ArgumentKind::Real || kind == ArgumentKind::Angle || kind == ArgumentKind::Zero;
}

bool isReference(ArgumentKind kind) {
    return kind == ArgumentKind::Part || kind == ArgumentKind::PointMass || kind == ArgumentKind::FlexBody ||
           kind == ArgumentKind::Marker || kind == ArgumentKind::MarkerOrZero ||
           kind == ArgumentKind::Joint || kind == ArgumentKind::Variable || kind == ArgumentKind::Array ||
           kind == ArgumentKind::Matrix;
}

bool isId(ArgumentKind kind) {
    return isReference(kind) || kind == ArgumentKind::Id || kind == ArgumentKind::Count ||
           kind == ArgumentKind::Node;
}

bool isCountRight(const ArgumentRule& rule, std::size_t count) {
    return count == rule.least || count == rule.most || (rule.most == NoLimit && count > rule.least);
}

std::string describeCount(const ArgumentRule& rule) {
    const bool counts = rule.kind == ArgumentKind::Count;
    const char* const what = rule.kind == ArgumentKind::Node ? "node"
                             : isId(rule.kind) && !counts    ? "id"
                                                             : "number";
    if (rule.most == 1) return fmt::format("1 {}", what);
    if (rule.most == NoLimit) return fmt::format("at least {} {}s", rule.least, what);
    if (rule.least == rule.most) return fmt::format("{} {}s", rule.most, what);
    return fmt::format("{} or {} {}s", rule.least, rule.most, what);
}

}  // namespace

bool StatementReader::readValue(const ArgumentRule& rule, ArgumentValue& value) {
    if (isNumeric(rule.kind) || isId(rule.kind)) return readNumbers(rule, value);
    if (rule.words) return readWords(rule, value);
    if (rule.kind == ArgumentKind::Names) return readNames(rule, value);
    if (rule.kind == ArgumentKind::Expression || rule.kind == ArgumentKind::Subroutine)
        return readExpression(rule, value);
    value.text = takeItem();
    return true;
}

// The word that begins at this offset, after blanks.
StatementReader::Name StatementReader::peekName(std::size_t offset) const {
    Name name;
    while (offset < m_text.size() && isBlank(m_text[offset])) ++offset;
    const std::size_t begin = offset;
    while (offset < m_text.size() && isWordCharacter(m_text[offset])) ++offset;
    name.word = m_text.substr(begin, offset - begin);
    while (offset < m_text.size() && isBlank(m_text[offset])) ++offset;
    name.atEnd = begin == m_text.size();
    if (!name.atEnd) name.first = m_text[begin];
    name.equals = offset < m_text.size() && m_text[offset] == '=' && isLetter(name.first);
    return name;
}

// A list goes on while numbers follow, and while it is too short and no other argument follows.
bool StatementReader::isNextValue(const ArgumentRule& rule, std::size_t count) const {
    const Name next = peekName(m_at);
    if (!m_comma || next.atEnd) return false;
    if (!isLetter(next.first)) return !isComma(next.first) || count < rule.most;
    if (count >= rule.most || next.equals) return false;
    const WordMatch match = findWord(*m_rules, next.word);
    return !(match.found && isBare((*m_rules)[match.index].kind));
}

bool StatementReader::readNumbers(const ArgumentRule& rule, ArgumentValue& value) {
    bool good = true;
    do {
        skipBlanks();
        good = readNumber(rule, value) && good;
    } while (m_errors < MostErrors && isNextValue(rule, value.offsets.size()));
    if (good && !isCountRight(rule, value.offsets.size())) {
        const bool node = rule.kind == ArgumentKind::Node;
        addError(m_given.back().offset,
                 fmt::format("{} takes {}, not {}{}", describe(rule), describeCount(rule),
                             value.offsets.size(), node ? "; nodes cannot be averaged yet" : ""));
        return false;
    }
    if (good && isReference(rule.kind)) addReferences(rule, value);
    return good;
}

bool StatementReader::readNumber(const ArgumentRule& rule, ArgumentValue& value) {
    const std::size_t offset = m_at;
    const std::string_view item = takeItem();
    value.offsets.push_back(offset);
    std::string fault;
    if (item.empty()) {
        fault = "a value is empty";
    } else if (isId(rule.kind)) {
        const Number<int> id = parseId(item, rule.kind == ArgumentKind::MarkerOrZero ? 0 : 1);
        value.ids.push_back(id.value);
        fault = id.fault;
        if (rule.kind == ArgumentKind::Count && !fault.empty())
            fault = quote(item) + " is not a whole number from 1";
    } else {
        const Number<double> number = parseReal(item, rule.kind == ArgumentKind::Angle);
        value.numbers.push_back(number.value);
        value.degrees = value.degrees || toUpper(item.back()) == 'D';
        fault = number.fault;
        if (fault.empty() && rule.kind == ArgumentKind::Zero && number.value != 0)
            fault = quote(item) + " has an effect that is not supported yet; only 0 is accepted";
    }
    if (!fault.empty()) addError(offset, fmt::format("{}: {}", describe(rule), fault));
    return fault.empty();
}

void StatementReader::addReferences(const ArgumentRule& rule, const ArgumentValue& value) {
    for (std::size_t k = 0; k < value.ids.size(); ++k)
        if (value.ids[k] != 0)
            m_state.references.push_back(
                {m_number, m_keyword, m_id, value.ids[k], &rule, m_statement.getPosition(value.offsets[k])});
}

bool StatementReader::readWords(const ArgumentRule& rule, ArgumentValue& value) {
    const int errors = m_errors;
    std::string_view rest = takeItem();
    if (!m_hasValue) return true;
    for (bool more = true; more && m_errors < MostErrors;) {
        const std::size_t colon = std::min(rest.find(':'), rest.size());
        const std::string_view word = trim(rest.substr(0, colon));
        const std::size_t offset = static_cast<std::size_t>(word.data() - m_text.data());
        more = colon < rest.size();
        rest.remove_prefix(more ? colon + 1 : colon);
        const WordMatch match = word.empty() ? WordMatch() : findWord(*rule.words, word);
        const bool again =
            std::find(value.words.begin(), value.words.end(), match.index) != value.words.end();
        if (!match.found)
            addError(offset, fmt::format("{}: unknown word {}{}", describe(rule), quote(word),
                                         suggestWord(*rule.words, word)));
        else if (rule.kind == ArgumentKind::Words && again)
            addError(offset, fmt::format("{}: {} is given twice", describe(rule), quote(word)));
        else
            value.words.push_back(match.index);
        value.offsets.push_back(offset);
    }
    return m_errors == errors;
}

// A list of names goes on until another argument begins. A bare word is one only in full and while none of its
// group is given: names are often short words themselves.
bool StatementReader::isNextName() const {
    const Name next = peekName(m_at);
    if (!m_comma || next.atEnd || next.equals) return false;
    const std::string_view item = trim(m_text.substr(m_at, findItemEnd(m_text, m_at) - m_at));
    const WordMatch match = findWord(*m_rules, item);
    const bool inFull = match.found && (*m_rules)[match.index].name.size() == item.size();
    return !inFull || !isBare((*m_rules)[match.index].kind) || has(ArgumentKind::Choice);
}

bool StatementReader::readListedName(const ArgumentRule& rule, ArgumentValue& value) {
    skipBlanks();
    const std::size_t offset = m_at;
    const std::string_view item = takeItem();
    value.offsets.push_back(offset);
    if (item.empty() || item.front() != '"') {
        value.names.emplace_back(item);
        return true;
    }
    const std::size_t end = skipQuotes(item, 0);
    if (end == item.size()) {
        value.names.emplace_back(item.substr(1, end - 2));
        return true;
    }
    if (end == 0)
        addError(offset, fmt::format("{}: the closing quote of {} is missing", describe(rule), quote(item)));
    else
        addError(offset + end,
                 fmt::format("{}: a comma is missing after {}", describe(rule), quote(item.substr(0, end))));
    return false;
}

bool StatementReader::readNames(const ArgumentRule& rule, ArgumentValue& value) {
    bool good = true;
    do {
        good = readListedName(rule, value) && good;
    } while (rule.most > 1 && m_errors < MostErrors && isNextName());
    if (good && value.names.size() > rule.most) {
        addError(m_given.back().offset, fmt::format("{} takes at most {} names, not {}", describe(rule),
                                                    rule.most, value.names.size()));
        return false;
    }
    return good;
}

// Goes past the backslash or comma at `end`, and past the comma that may follow a backslash.
void StatementReader::endExpression(std::size_t end) {
    m_at = end;
    m_comma = !atEnd() && isComma(m_text[m_at]);
    if (atEnd()) return;
    ++m_at;
    skipBlanks();
    if (m_comma || atEnd() || !isComma(m_text[m_at])) return;
    m_comma = true;
    ++m_at;
}

// USER(r1, r2, ...) instead of an expression calls a subroutine that was compiled for Adams. Nothing more of
// the statement is read, because its other arguments may be those of the subroutine.
bool StatementReader::checkNotUser(const ArgumentRule& rule) {
    constexpr const char* gaps = " \t\r\v\f\n";
    const std::size_t begin = std::min(m_text.find_first_not_of(gaps, m_at), m_text.size());
    const std::string_view word = peekName(begin).word;
    const std::size_t next = m_text.find_first_not_of(gaps, begin + word.size());
    const bool isUser = word.size() == 4 && startsWith(word, "USER");
    const bool calls = isUser && next != m_text.npos && m_text[next] == '(';
    if (!calls && rule.kind != ArgumentKind::Subroutine) return true;
    addError(begin, fmt::format("{} calls a user subroutine, and none can be run; write it as an expression",
                                describe(rule)));
    m_at = m_text.size();
    m_comma = false;
    return false;
}

// An expression ends at a backslash. It also ends at a comma outside parentheses that a name and '='
// follow: no expression has an '=', so nothing else can be meant.
bool StatementReader::readExpression(const ArgumentRule& rule, ArgumentValue& value) {
    if (!checkNotUser(rule)) return false;
    const std::size_t begin = m_at;
    const int errors = m_errors;
    std::size_t depth = 0;
    std::size_t end = begin;
    for (; end < m_text.size() && m_text[end] != '\\'; ++end) {
        const char c = m_text[end];
        if (c == '(' || c == '[') ++depth;
        if ((c == ')' || c == ']') && depth > 0) --depth;
        const bool separates = isComma(c) && depth == 0;
        if (separates && peekName(end + 1).equals) break;
        if (c != '=' && !(separates && c == ',')) continue;
        addError(end, fmt::format("'{}' cannot stand in {}; a '\\' or ')' may be missing before it", c,
                                  describe(rule)));
        break;
    }
    if (m_errors > errors) {
        m_at = m_text.size();
        m_comma = false;
        return false;
    }
    value.expression = cutExpression(m_statement, begin, end);
    const std::string& text = value.expression.text;
    if (text.empty())
        addError(m_given.back().offset, describe(rule) + " is empty");
    else if (text.back() == ',')
        addError(m_text.rfind(',', end - 1),
                 describe(rule) + " ends in a comma; something is missing after it");
    endExpression(end);
    return m_errors == errors;
}

}  // namespace jprim
