// SPDX-License-Identifier: Apache-2.0
#include "dataset/writer/statement_writer.h"

#include "base/format.h"

namespace jprim {

void StatementWriter::begin(std::string_view keyword, int id) {
    m_line = id == 0 ? fmt::format("{}/", keyword) : fmt::format("{}/{}", keyword, id);
    m_first = id == 0;
    m_backslash = false;
}

void StatementWriter::add(std::string_view argument) {
    if (argument.empty()) return;
    // The slash of a statement without id is followed by its first argument, without a comma.
    const std::string_view separator = m_backslash ? "\\" : m_first ? "" : ", ";
    if (m_line.size() + separator.size() + argument.size() > LongestLine && !m_first) {
        m_line += m_backslash ? "\\" : "";
        breakLine();
        m_line += " ";
    } else {
        m_line += separator;
    }
    m_line += argument;
    m_first = m_backslash = false;
}

void StatementWriter::addExpression(std::string_view name, std::string_view expression) {
    std::size_t space = expression.find(' ');
    add(fmt::format("{}={}", name, expression.substr(0, space)));
    while (space != expression.npos) {
        const std::size_t begin = space + 1;
        space = expression.find(' ', begin);
        const std::string_view word = expression.substr(begin, space - begin);
        if (m_line.size() + 1 + word.size() > LongestLine) breakLine();
        m_line += ' ';
        m_line += word;
    }
    m_backslash = true;
}

void StatementWriter::end() {
    m_text += m_line;
    m_text += '\n';
}

void StatementWriter::breakLine() {
    end();
    m_line = ",";
}

void StatementWriter::add(std::string_view name, const std::optional<double>& number) {
    if (number) add(fmt::format("{}={}", name, *number));
}

void StatementWriter::add(std::string_view name, int id) {
    if (id != 0) add(fmt::format("{}={}", name, id));
}

void StatementWriter::add(std::string_view name, const std::string& text) {
    if (!text.empty()) add(fmt::format("{}={}", name, text));
}

void StatementWriter::add(std::string_view name, const std::optional<Triple>& triple) {
    if (!triple) return;
    const Triple& t = *triple;
    const std::string all = fmt::format("{}={}, {}, {}", name, t[0], t[1], t[2]);
    // A list stays on one line unless it alone is too long for it.
    if (all.size() + 2 <= LongestLine) return add(all);
    add(name, std::vector<double>(t.begin(), t.end()));
}

void StatementWriter::add(std::string_view name, const std::optional<ExpressionText>& expression) {
    if (expression) addExpression(name, expression->text);
}

// A name that has a quote in it was given without quotes, so it has nothing in it that needs them.
void StatementWriter::add(std::string_view name, const std::vector<std::string>& names) {
    for (std::size_t k = 0; k < names.size(); ++k) {
        const std::string mark = names[k].find('"') == std::string::npos ? "\"" : "";
        add((k == 0 ? fmt::format("{}=", name) : "") + mark + names[k] + mark);
    }
}

void StatementWriter::add(std::string_view name, const std::vector<int>& ids) {
    for (std::size_t k = 0; k < ids.size(); ++k)
        add(k == 0 ? fmt::format("{}={}", name, ids[k]) : fmt::format("{}", ids[k]));
}

void StatementWriter::add(std::string_view name, const std::vector<double>& numbers) {
    for (std::size_t k = 0; k < numbers.size(); ++k)
        add(k == 0 ? fmt::format("{}={}", name, numbers[k]) : fmt::format("{}", numbers[k]));
}

}  // namespace jprim
