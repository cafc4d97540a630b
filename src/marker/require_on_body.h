// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_REQUIRE_ON_BODY_H_
#define JPRIM_SRC_MARKER_REQUIRE_ON_BODY_H_

#include <string>

#include "jprim/marker/marker.h"

namespace jprim {

/// @param label    what the message calls the marker: "marker I"
/// @param element  named in the message
/// @throws Error   if the marker is on no body, or on one that belongs to no matter subsystem
void requireOnBody(const Marker& marker, const std::string& label, const std::string& element);

}  // namespace jprim

#endif
