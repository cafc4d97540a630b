// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_ELEMENTS_CONNECTION_H_
#define JPRIM_SRC_MECHANISM_ELEMENTS_CONNECTION_H_

#include <functional>

#include "mechanism/elements/element_context.h"

namespace jprim {

/// A JPRIM or JOINT: a mobilizer of the tree, the equations that `makeEquations` gives, or of these what a loop that the
/// tree keeps in a plane has left to do.
[[nodiscard]] Element makeConnection(const ElementId& id, const char* type, int i, int j,
                                     LoopEquations inPlane, const std::function<Joint()>& makeEquations,
                                     const ElementContext& context);

}  // namespace jprim

#endif
