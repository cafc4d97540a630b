// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_ELEMENTS_FORCE_H_
#define JPRIM_SRC_MECHANISM_ELEMENTS_FORCE_H_

#include "mechanism/elements/element_context.h"

namespace jprim {

/// A force between markers: the law is written as expressions in the dataset's units, times the unit of its result.
/// @param j         0 if there is no reaction; a floating marker is where I is, wherever its part has it
/// @param doesWork  it may change the energy, beside its potential
[[nodiscard]] Element makeForce(const ElementId& id, int i, int j, const ForceLaw& law, bool doesWork,
                                const ElementContext& context);

}  // namespace jprim

#endif
