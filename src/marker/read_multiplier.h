// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_READ_MULTIPLIER_H_
#define JPRIM_SRC_MARKER_READ_MULTIPLIER_H_

#include <cmath>

#include "SimTKcommon.h"

namespace jprim {

/// A multiplier from Simbody, which has none where no equation of the system holds anything (all are dropped, or
/// no mobility can move them): it then solves with a matrix of zeros and leaves NaN. There is no load then.
inline SimTK::Real readMultiplier(SimTK::Real lambda) {
    return std::isnan(lambda) ? 0 : lambda;
}

}  // namespace jprim

#endif
