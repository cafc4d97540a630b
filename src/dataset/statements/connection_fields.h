// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_STATEMENTS_CONNECTION_FIELDS_H_
#define JPRIM_SRC_DATASET_STATEMENTS_CONNECTION_FIELDS_H_

#include "dataset/fields.h"

/// @file
/// What constraints and forces have in common: two markers, and a function.
namespace jprim {

/// I or J: markers of different bodies.
constexpr ArgumentRule endMarker(std::string_view name) {
    return ArgumentRule(name, ArgumentKind::Marker, ExactOnly).on(MarkerLink::OtherPart);
}

/// FUNCTION: an expression that must be given.
constexpr ArgumentRule functionRule() {
    return ArgumentRule("FUNCTION", ArgumentKind::Expression, 2).required();
}

/// USER(...) in the place of other arguments, which cannot be run.
constexpr ArgumentRule subroutineRule() {
    return ArgumentRule("FUNCTION", ArgumentKind::Subroutine, 2);
}

template <class S>
std::vector<Field<S>> endMarkers() {
    return {field(endMarker("I").required(), &S::i), field(endMarker("J").required(), &S::j)};
}

}  // namespace jprim

#endif
