// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_ELEMENT_KINDS_H_
#define JPRIM_SRC_DATASET_ELEMENT_KINDS_H_

#include "dataset/spelling_table.h"
#include "jprim/dataset/element_id.h"

namespace jprim {

/// The keywords of elements, as ACTIVATE and DEACTIVATE abbreviate them.
const SpellingTable<ElementKind>& getElementKinds();

}  // namespace jprim

#endif
