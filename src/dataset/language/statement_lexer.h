// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_LANGUAGE_STATEMENT_LEXER_H_
#define JPRIM_SRC_DATASET_LANGUAGE_STATEMENT_LEXER_H_

#include <cstddef>
#include <string_view>

#include "jprim/base/diagnostic.h"
#include "jprim/dataset/source_text.h"

namespace jprim {

/// Stands in StatementText::text for the comma that begins a continuation line: a separator in a list, but
/// nothing at all inside an expression.
constexpr char ContinuationComma = '\n';

inline bool isComma(char c) {
    return c == ',' || c == ContinuationComma;
}

/// Where a text in double quotes that begins at this offset ends, behind the closing quote; the offset itself if none
/// begins there. Quotes enclose an item: the opening one stands after a '=', a comma or nothing, the closing one in the
/// same line. What is between them separates, continues and ends nothing.
std::size_t skipQuotes(std::string_view text, std::size_t at);

/// The offset of the next comma that stands in no quotes, or the end of the text.
std::size_t findItemEnd(std::string_view text, std::size_t begin);

/// One statement on one line: comments and line breaks taken out.
using StatementText = SourceText;

/// The text from `begin` to `end` with every run of blanks and line marks as one space, and none at the ends.
ExpressionText cutExpression(const StatementText& statement, std::size_t begin, std::size_t end);

/// True if the text of a statement is this word, alone or with a slash.
bool isWordAlone(std::string_view text, std::string_view word);

/// True for the statement that ends a dataset.
inline bool isEnd(std::string_view text) {
    return isWordAlone(text, "END");
}

/// Cuts a text into statements, by the rules for comments, continuation lines and semicolons. Knows nothing
/// of what a statement means.
class StatementLexer {
public:
    explicit StatementLexer(std::string_view text) : m_text(text) {}

    /// The rest of the current line as it stands, without trailing blanks, for lines that are no statements.
    /// Not to be mixed with next(), which may have looked ahead.
    std::string_view takeLine();

    bool atEnd() const { return m_at == m_text.size(); }

    /// Just before the first character that was not read yet.
    SourcePosition getPosition() const { return {m_line, static_cast<int>(m_at - m_lineBegin) + 1}; }

    /// Reads the next statement into `statement`, reusing its memory. False at the end of the text.
    bool next(StatementText& statement);

private:
    // What one line has of one statement: no comment, no blanks at the ends, no closing semicolon.
    struct Piece {
        std::string_view text;
        SourcePosition where;
        bool semicolon = false;
    };

    bool peek();
    Piece scanPiece();

    std::string_view m_text;
    std::size_t m_at = 0;
    std::size_t m_lineBegin = 0;
    int m_line = 1;
    Piece m_piece;
    bool m_hasPiece = false;
};

}  // namespace jprim

#endif
