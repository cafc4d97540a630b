// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BUILD_LENGTH_UNIT_H_
#define JPRIM_SRC_BUILD_LENGTH_UNIT_H_

#include "jprim/dataset/dataset.h"

namespace jprim {

/// The length [m] to build the mechanism in: 1, or the power of 1000 of it that suits the largest distance of
/// a marker from its part's mass centre. Tolerances of assembly and integration are absolute numbers, and
/// Simbody weighs lengths against angles; both assume that a part's size is of order one.
/// @param lengthToSI  the dataset's unit of length [m]
double chooseLengthUnit(const Dataset& dataset, double lengthToSI);

}  // namespace jprim

#endif
