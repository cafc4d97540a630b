// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_STATEMENT_LEXER_H_
#define JPRIM_SRC_DATASET_STATEMENT_LEXER_H_

#include <cstddef>
#include <string_view>

#include "jprim/base/diagnostic.h"
#include "jprim/dataset/source_text.h"

namespace jprim {

/// Stands in Statement::text for the comma that begins a continuation line: a separator in a list, but
/// nothing at all inside an expression.
constexpr char ContinuationComma = '\n';

inline bool isComma(char c) {
    return c == ',' || c == ContinuationComma;
}

/// One statement on one line: comments and line breaks taken out.
using Statement = SourceText;

/// The text from `begin` to `end` with every run of blanks and line marks as one space, and none at the ends.
ExpressionText cutExpression(const Statement& statement, std::size_t begin, std::size_t end);

/// True for the text of the statement that ends a dataset: END, alone or with a slash.
bool isEnd(std::string_view text);

/// Cuts the text of a dataset into its title and its statements, by the rules for comments,
/// continuation lines and semicolons. Knows nothing of what a statement means.
class StatementLexer {
public:
    explicit StatementLexer(std::string_view text);

    /// The first line, without trailing blanks.
    std::string_view getTitle() const { return m_title; }

    /// Reads the next statement into `statement`, reusing its memory. False at the end of the text.
    bool next(Statement& statement);

    /// Just after the last character of the text. Valid once next() has returned false.
    SourcePosition getEnd() const;

private:
    // What one line has of one statement: no comment, no blanks at the ends, no closing semicolon.
    struct Piece {
        std::string_view text;
        SourcePosition where;
        bool semicolon = false;
    };

    bool peek();
    Piece scanPiece();
    std::string_view takeLine();

    std::string_view m_text;
    std::string_view m_title;
    std::size_t m_at = 0;
    std::size_t m_lineBegin = 0;
    int m_line = 1;
    Piece m_piece;
    bool m_hasPiece = false;
};

}  // namespace jprim

#endif
