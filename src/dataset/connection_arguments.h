// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_CONNECTION_ARGUMENTS_H_
#define JPRIM_SRC_DATASET_CONNECTION_ARGUMENTS_H_

#include "dataset/statement_reader.h"

/// @file
/// What constraints and forces have in common: two markers, and a function.
namespace jprim {

/// I or J: markers of different bodies.
constexpr ArgumentRule endMarker(std::string_view name) {
    return ArgumentRule(name, ArgumentKind::Marker, ExactOnly).on(MarkerLink::OtherPart);
}

template <class Statement>
void setI(Statement& s, const ArgumentValue& v) {
    s.i = v.getId();
}
template <class Statement>
void setJ(Statement& s, const ArgumentValue& v) {
    s.j = v.getId();
}

/// FUNCTION: an expression that must be given.
constexpr ArgumentRule functionRule() {
    return ArgumentRule("FUNCTION", ArgumentKind::Expression, 2).required();
}

template <class Statement>
void setFunction(Statement& s, const ArgumentValue& v) {
    s.function = v.expression;
}

/// An argument that is given must be one that the statement's type has; `owners` says which types have it.
void checkAllowed(StatementReader& reader, const char* name, bool allowed, const char* owners);

}  // namespace jprim

#endif
