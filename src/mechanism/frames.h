// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_FRAMES_H_
#define JPRIM_SRC_MECHANISM_FRAMES_H_

#include <optional>
#include <string>

#include "SimTKcommon.h"
#include "jprim/dataset/dataset.h"

namespace jprim {

/// What a PART or MARKER statement says about a frame: an origin and either angles or points on axes.
struct FrameStatement {
    std::optional<Triple> origin;
    std::optional<Triple> reuler;
    std::optional<Triple> zPoint;
    std::optional<Triple> xPoint;
    bool xFirst = false;  ///< USEXP: xPoint lies on the axis, zPoint only in the half plane
};

/// The frame in SI. Where only one point is given, the other axis leans towards the like-named axis of the
/// base frame.
/// @param[out] problem  what is wrong with the points; untouched if nothing is
SimTK::Transform makeFrame(const FrameStatement& statement, double lengthToSI, std::string& problem);

}  // namespace jprim

#endif
