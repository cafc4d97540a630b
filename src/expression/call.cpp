// SPDX-License-Identifier: Apache-2.0
// What a vocabulary may ask of the arguments of a call.
#include <limits>

#include "base/format.h"
#include "expression/compile_expression.h"

namespace jprim {

ExpressionError::ExpressionError(std::size_t where, const std::string& what)
    : std::runtime_error(what), offset(where), message(what) {}

void requireArguments(const Call& call, std::size_t least, std::size_t most) {
    if (least > 0 && !call.hasParentheses)
        throw ExpressionError(call.offset, call.name + " needs its arguments, in parentheses");
    const std::size_t given = call.arguments.size();
    if (least <= given && given <= most) return;
    const std::string range = most == 0       ? "no arguments"
                              : most == 1     ? "1 argument"
                              : least == most ? fmt::format("{} arguments", most)
                                              : fmt::format("{} to {} arguments", least, most);
    // At the first argument too many, or at the name.
    throw ExpressionError(given > most ? call.arguments[most].offset : call.offset,
                          fmt::format("{} takes {}, not {}", call.name, range, given));
}

int requireId(const Call& call, std::size_t argument) {
    const Argument& a = call.arguments.at(argument);
    if (a.id) return *a.id;
    throw ExpressionError(a.offset,
                          fmt::format("argument {} of {} must be a whole number from 0 to {}, written "
                                      "without sign",
                                      argument + 1, call.name, std::numeric_limits<int>::max()));
}

Operand requireScalar(const Call& call, std::size_t argument) {
    const Argument& a = call.arguments.at(argument);
    if (!a.value.isVector) return a.value;
    throw ExpressionError(
        a.offset, fmt::format("argument {} of {} must be a scalar, not a vector", argument + 1, call.name));
}

}  // namespace jprim
