// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_LANGUAGE_H_
#define JPRIM_SRC_EXPRESSION_LANGUAGE_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expression/compile_expression.h"

namespace jprim {

/// The value of a call of one of the language's own functions and constants; nothing for other names.
/// @throws ExpressionError for bad arguments
std::optional<Operand> callLanguage(ProgramBuilder& builder, const Call& call, Vocabulary& vocabulary);

/// The language's own names, in upper case.
std::vector<std::string> getLanguageNames();

/// True for a function that Adams knows and we do not.
bool isKnownToAdamsOnly(std::string_view name);

}  // namespace jprim

#endif
