// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_ELEMENTS_EQUATION_H_
#define JPRIM_SRC_MECHANISM_ELEMENTS_EQUATION_H_

#include "mechanism/elements/element_context.h"

namespace jprim {

/// One equation f = 0, without markers and loads. Its scale makes a displacement of one length unit, or a turn of a part
/// that moves its farthest marker as far, change the error by about one: tolerances then mean the same for every
/// equation.
[[nodiscard]] Element makeEquation(const ElementId& id, const Expression& f, const ElementContext& context);

}  // namespace jprim

#endif
