// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BUILD_NOT_SIMULATED_H_
#define JPRIM_SRC_BUILD_NOT_SIMULATED_H_

#include "jprim/base/diagnostic.h"
#include "jprim/dataset/dataset.h"

namespace jprim {

/// Reports every statement that can be read, but has no mechanics yet: an error for one that would change
/// the motion, a warning for one that would only write it. False if there was an error.
bool checkSimulated(const Dataset& dataset, Diagnostics& diagnostics);

}  // namespace jprim

#endif
