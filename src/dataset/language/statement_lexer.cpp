// SPDX-License-Identifier: Apache-2.0
#include "dataset/language/statement_lexer.h"

#include <algorithm>

#include "base/text.h"

namespace jprim {

std::size_t skipQuotes(std::string_view text, std::size_t at) {
    if (text[at] != '"') return at;
    std::size_t before = at;
    while (before > 0 && isBlank(text[before - 1])) --before;
    const bool opens = before == 0 || text[before - 1] == '=' || isComma(text[before - 1]);
    const std::size_t end = opens ? text.find_first_of("\"\n", at + 1) : text.npos;
    return end == text.npos || text[end] == '\n' ? at : end + 1;
}

std::size_t findItemEnd(std::string_view text, std::size_t begin) {
    std::size_t at = begin;
    while (at < text.size() && !isComma(text[at])) at = std::max(at + 1, skipQuotes(text, at));
    return at;
}

ExpressionText cutExpression(const StatementText& statement, std::size_t begin, std::size_t end) {
    ExpressionText cut;
    std::size_t last = begin;
    auto next = statement.segments.begin();
    // A segment of the cut begins where one of the statement does, and where blanks were left out.
    const auto append = [&](char c, std::size_t at) {
        bool begins = cut.text.empty() || at != last + 1;
        for (; next != statement.segments.end() && next->begin <= at; ++next) begins = true;
        if (begins) cut.segments.push_back({cut.text.size(), statement.getPosition(at)});
        cut.text += c;
        last = at;
    };
    std::size_t gap = end;  // where the blanks before this character begin, if there are any
    for (std::size_t at = begin; at < end; ++at) {
        const char c = statement.text[at];
        if (isBlank(c) || c == ContinuationComma) {
            gap = std::min(gap, at);
            continue;
        }
        if (gap < at && !cut.text.empty()) append(' ', gap);
        gap = end;
        append(c, at);
    }
    return cut;
}

bool isWordAlone(std::string_view text, std::string_view word) {
    if (!text.empty() && text.back() == '/') text = trim(text.substr(0, text.size() - 1));
    return text.size() == word.size() && startsWith(word, text);
}

std::string_view StatementLexer::takeLine() {
    const std::size_t newline = std::min(m_text.find('\n', m_at), m_text.size());
    std::string_view line = m_text.substr(m_at, newline - m_at);
    m_at = newline;
    if (newline < m_text.size()) {
        m_lineBegin = ++m_at;
        ++m_line;
    }
    while (!line.empty() && isBlank(line.back())) line.remove_suffix(1);
    return line;
}

StatementLexer::Piece StatementLexer::scanPiece() {
    Piece piece;
    while (m_at < m_text.size() && isBlank(m_text[m_at])) ++m_at;
    const std::size_t begin = m_at;
    piece.where = {m_line, static_cast<int>(begin - m_lineBegin) + 1};
    const auto ends = [](char c) { return c == '\n' || c == '!' || c == ';'; };
    const std::string_view line = m_text.substr(m_lineBegin);
    while (m_at < m_text.size() && !ends(m_text[m_at]))
        m_at = std::max(m_at + 1, m_lineBegin + skipQuotes(line, m_at - m_lineBegin));
    piece.text = trim(m_text.substr(begin, m_at - begin));
    piece.semicolon = m_at < m_text.size() && m_text[m_at] == ';';
    if (piece.semicolon)
        ++m_at;
    else
        takeLine();
    return piece;
}

// Makes m_piece the next piece that says something. It stays there until next() has used it, so no
// part of the text is looked at twice.
bool StatementLexer::peek() {
    while (!m_hasPiece && m_at < m_text.size()) {
        m_piece = scanPiece();
        m_hasPiece = !m_piece.text.empty() || m_piece.semicolon;
    }
    return m_hasPiece;
}

bool StatementLexer::next(StatementText& statement) {
    statement.text.clear();
    statement.segments.clear();
    char expects = 0;  // ',' or '&': how the line before asked for this one
    while (peek()) {
        std::string_view text = m_piece.text;
        const bool open = !statement.segments.empty();
        const bool comma = !text.empty() && text.front() == ',';
        // A comma left over before END does not swallow it.
        if (open && !comma && !text.empty() && (!expects || isEnd(text))) return true;
        m_hasPiece = false;
        const bool ampersand = !m_piece.semicolon && text.back() == '&';
        if (ampersand) text = trim(text.substr(0, text.size() - 1));
        if (!text.empty()) {
            if (open && !comma) statement.text += ' ';
            statement.segments.push_back({statement.text.size(), m_piece.where});
            const std::size_t begin = statement.text.size();
            statement.text += text;
            // After a closing comma the opening one says nothing new; after '&' it is a comma like any other.
            if (open && comma && expects != '&') statement.text[begin] = expects ? ' ' : ContinuationComma;
            expects = text.back() == ',' ? ',' : char(0);
        }
        if (ampersand) expects = '&';
        if (m_piece.semicolon && !statement.segments.empty()) return true;
    }
    return !statement.segments.empty();
}

}  // namespace jprim
