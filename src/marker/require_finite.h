// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_REQUIRE_FINITE_H_
#define JPRIM_SRC_MARKER_REQUIRE_FINITE_H_

#include <string>

#include "SimTKcommon.h"

namespace jprim {

/// @param what     what the message calls the value: "pitch"
/// @param element  named in the message
/// @throws Error   if the value is infinite or no number
void requireFinite(SimTK::Real value, const std::string& what, const std::string& element);

/// The same of a marker's pose. @param whose  in the message: "marker I's"
void requireFinite(const SimTK::Transform& X, const std::string& whose, const std::string& element);

}  // namespace jprim

#endif
