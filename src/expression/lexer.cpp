// SPDX-License-Identifier: Apache-2.0
#include "expression/lexer.h"

#include <string>

#include "base/numbers.h"
#include "base/text.h"
#include "expression/compile_expression.h"

namespace jprim {
namespace {

// The character at an offset, or 0 behind the end.
char peek(std::string_view text, std::size_t at) {
    return at < text.size() ? text[at] : '\0';
}

// True for the sign in `1E+3`: it belongs to the number.
bool isExponentSign(std::string_view text, std::size_t at, char letter) {
    return (text[at] == '+' || text[at] == '-') && toUpper(text[at - 1]) == letter &&
           isDigit(peek(text, at + 1));
}

}  // namespace

void ExpressionLexer::skipBlanks() {
    while (m_at < m_text.size() && (isBlank(m_text[m_at]) || m_text[m_at] == '\n')) ++m_at;
}

Token ExpressionLexer::next() {
    skipBlanks();
    const std::size_t begin = m_at;
    if (begin == m_text.size()) return {Token::Kind::End, begin, {}, 0};
    if (isDigit(m_text[begin]) || m_text[begin] == '.') return scanNumber(begin);
    if (!isLetter(m_text[begin])) return scanSign(begin);
    while (m_at < m_text.size() && isWordCharacter(m_text[m_at])) ++m_at;
    return {Token::Kind::Name, begin, m_text.substr(begin, m_at - begin), 0};
}

// Takes everything that touches the number, so that `2X` or `1.2.3` is refused as a whole.
Token ExpressionLexer::scanNumber(std::size_t begin) {
    while (m_at < m_text.size() && (isWordCharacter(m_text[m_at]) || m_text[m_at] == '.' ||
                                    (m_at > begin && isExponentSign(m_text, m_at, 'E'))))
        ++m_at;
    const std::string_view text = m_text.substr(begin, m_at - begin);
    if (m_at < m_text.size() && isExponentSign(m_text, m_at, 'D'))
        throw ExpressionError(begin, quote(m_text.substr(begin, m_at + 2 - begin)) +
                                         " may be degrees or an exponent; write a blank behind the D of "
                                         "degrees, or E for an exponent");
    const Number<double> number = parseReal(text, true);
    if (!number.fault.empty()) throw ExpressionError(begin, number.fault);
    return {Token::Kind::Number, begin, text, number.value};
}

Token ExpressionLexer::scanSign(std::size_t begin) {
    const std::string_view sign = m_text.substr(begin, 1);
    if (sign == "^") throw ExpressionError(begin, "'^' has no meaning here; a power is written **");
    if (std::string_view("+-*/%()[],:").find(sign.front()) == std::string_view::npos)
        throw ExpressionError(begin, quote(sign) + " has no meaning in an expression");
    ++m_at;
    if (sign != "*") return {Token::Kind::Sign, begin, sign, 0};
    skipBlanks();  // blanks may stand within `**`
    if (peek(m_text, m_at) != '*') return {Token::Kind::Sign, begin, sign, 0};
    ++m_at;
    return {Token::Kind::Sign, begin, "**", 0};
}

}  // namespace jprim
