// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MECHANISM_FIND_MISTAKES_H_
#define JPRIM_MECHANISM_FIND_MISTAKES_H_

#include "jprim/base/diagnostic.h"
#include "jprim/dataset/dataset.h"

namespace jprim {

/// Finds what else is wrong in a dataset that was read with errors, of which no mechanism can be built: mistakes in
/// functions, in files of modes, nodes that are not in these, and points that define no axes. What names a statement
/// with errors is not wrong on that account.
///
/// @param         dataset      as far as it was read
/// @param[in,out] diagnostics  those of reading; all together are put in the order of the file
void findMistakes(const Dataset& dataset, Diagnostics& diagnostics);

}  // namespace jprim

#endif
