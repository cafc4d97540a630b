// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_LEXER_H_
#define JPRIM_SRC_EXPRESSION_LEXER_H_

#include <cstddef>
#include <string_view>

namespace jprim {

/// A word of an expression.
struct Token {
    enum class Kind { End, Number, Name, Sign };

    Kind kind = Kind::End;
    std::size_t offset = 0;
    std::string_view text;  ///< of the sign `* *`: `**`
    double value = 0;       ///< of a number; degrees are radians already

    bool is(std::string_view sign) const { return kind == Kind::Sign && text == sign; }
};

/// Cuts an expression into tokens: numbers, names and the signs + - * / % ** ( ) [ ] , :
class ExpressionLexer {
public:
    explicit ExpressionLexer(std::string_view text) : m_text(text) {}

    /// The next token; at the end of the text again and again End.
    /// @throws ExpressionError for a character or a number that the language does not know
    Token next();

private:
    Token scanNumber(std::size_t begin);
    Token scanSign(std::size_t begin);
    void skipBlanks();

    std::string_view m_text;
    std::size_t m_at = 0;
};

}  // namespace jprim

#endif
