// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BASE_SORT_DIAGNOSTICS_H_
#define JPRIM_SRC_BASE_SORT_DIAGNOSTICS_H_

#include <cstddef>

#include "jprim/base/diagnostic.h"

namespace jprim {

/// Brings the diagnostics from this one on into the order of the file: what is checked last may stand first.
void sortByPosition(std::size_t first, Diagnostics& diagnostics);

}  // namespace jprim

#endif
