// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_ELEMENTS_ELEMENTS_H_
#define JPRIM_SRC_MECHANISM_ELEMENTS_ELEMENTS_H_

#include "mechanism/elements/element_context.h"

/// @file
/// What each statement means in mechanics: a kind of element is one file. All throw Error or FunctionError for a mistake
/// in the statement.
namespace jprim {

[[nodiscard]] Element makeElement(const JprimStatement& statement, const ElementContext& context);
[[nodiscard]] Element makeElement(const JointStatement& statement, const ElementContext& context);
[[nodiscard]] Element makeElement(const GconStatement& statement, const ElementContext& context);
[[nodiscard]] Element makeElement(const MotionStatement& statement, const ElementContext& context);
[[nodiscard]] Element makeElement(const CouplerStatement& statement, const ElementContext& context);
[[nodiscard]] Element makeElement(const SforceStatement& statement, const ElementContext& context);
[[nodiscard]] Element makeElement(const VectorForceStatement& statement, const ElementContext& context);
[[nodiscard]] Element makeElement(const SpringdamperStatement& statement, const ElementContext& context);
[[nodiscard]] Element makeElement(const BushingStatement& statement, const ElementContext& context);

[[nodiscard]] ElementId getElementId(const VectorForceStatement& statement);

}  // namespace jprim

#endif
