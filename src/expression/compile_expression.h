// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_COMPILE_EXPRESSION_H_
#define JPRIM_SRC_EXPRESSION_COMPILE_EXPRESSION_H_

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "expression/program.h"

namespace jprim {

/// What is wrong with an expression, and where: `offset` counts characters from the beginning of the text.
struct ExpressionError : std::runtime_error {
    ExpressionError(std::size_t offset, const std::string& message);

    std::size_t offset;
    std::string message;
};

/// An argument of a call.
struct Argument {
    std::size_t offset = 0;
    std::optional<int> id;  ///< if it is written as an unsigned whole number
    Operand value;
};

/// A name in an expression, with its arguments if it has any.
struct Call {
    std::string name;  ///< in upper case
    std::size_t offset = 0;
    std::vector<Argument> arguments;
    bool hasParentheses = false;
};

/// Refuses a call that has not between `least` and `most` arguments, or that lacks its parentheses although
/// it needs arguments.
/// @throws ExpressionError
void requireArguments(const Call& call, std::size_t least, std::size_t most);

/// The argument as an id: a whole number, written without sign; 0 included.
/// @throws ExpressionError
int requireId(const Call& call, std::size_t argument);

/// The argument as a scalar.
/// @throws ExpressionError
Operand requireScalar(const Call& call, std::size_t argument);

/// Supplies the names that the language itself does not know: measures of a mechanism, variables, splines.
class Vocabulary {
public:
    virtual ~Vocabulary() = default;

    /// The value of a call; nothing if the name is unknown. May compile another text into the same builder, and
    /// must itself see that this comes to an end.
    /// @throws ExpressionError for bad arguments
    virtual std::optional<Operand> call(ProgramBuilder& builder, const Call& call) = 0;

    /// The spline of this id; null if there is none.
    virtual const InterpolatingSpline* findSpline(int id) = 0;

    /// The names that call() knows, in upper case, for suggestions.
    virtual std::vector<std::string> getNames() const = 0;

    /// Why an expression of this use must not contain a value; empty if it may. Asked of each name and sign, so
    /// that the mistake is found where it stands.
    virtual std::string findProblem(const ProgramBuilder&, Operand) const { return ""; }
};

/// Translates an Adams function expression.
///
///     sum     = product { ("+" | "-") product }
///     product = signed { ("*" | "/" | "%") signed }
///     signed  = { "+" | "-" } power
///     power   = primary [ "**" signed ]
///     primary = number | name [ "(" arguments ")" ] | "(" sum ")" | "[" sum "," sum "," sum "]"
///
/// Names are not case sensitive and blanks mean nothing between words and signs. Numbers may carry the suffix
/// D, degrees. `*` of two vectors is their dot product and `%` their cross product. The language's own names:
///
/// - TIME PI DTOR RTOD
/// - ABS ACOS AINT ANINT ASIN ATAN ATAN2 COS COSH DIM EXP LOG LOG10 MAX MIN MOD SIGN SIN SINH SQRT TAN TANH
/// - STEP STEP5 HAVSIN IF IMPACT BISTOP POLY CHEBY SHF FORSIN FORCOS AKISPL CUBSPL
/// - UV, the direction of a vector
///
/// Brackets and powers may be nested 200 deep, and a text may have 100,000 characters; the time taken is
/// proportional to its length. A constant part without a finite value, such as 1/0, is an error.
/// @throws ExpressionError
Operand compileExpression(std::string_view text, ProgramBuilder& builder, Vocabulary& vocabulary);

}  // namespace jprim

#endif
