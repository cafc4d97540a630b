// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_REQUIRE_ON_BODY_H_
#define JPRIM_SRC_MARKER_REQUIRE_ON_BODY_H_

#include <string>

#include "jprim/marker/expression.h"

namespace jprim {

/// @param label    what the message calls the marker: "marker I"
/// @param element  named in the message
/// @throws Error   if the marker is on no body, or on one that belongs to no matter subsystem
void requireOnBody(const Marker& marker, const std::string& label, const std::string& element);

/// @throws Error also if it belongs to another system
void requireInSystem(const Marker& marker, const std::string& label, const SimTK::System& system,
                     const std::string& element);

/// The same of all markers of an expression.
void requireInSystem(const Expression& expression, const SimTK::System& system, const std::string& element);

/// @throws Error naming the element if the forces belong to no system
const SimTK::System& findSystem(const SimTK::GeneralForceSubsystem& forces, const std::string& element);

/// The handle of a subsystem that its system keeps, whatever became of those through which elements were added.
inline const SimTK::Subsystem& findHandle(const SimTK::Subsystem::Guts& subsystem) {
    return subsystem.getSystem().getSubsystem(subsystem.getMySubsystemIndex());
}

/// For what acts between two bodies of one system.
/// @throws Error if a marker is on no body, if both are on one or if their bodies belong to different systems
void requireTwoBodies(const Marker& I, const Marker& J, const std::string& element);

}  // namespace jprim

#endif
