// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BUILD_PART_MASS_H_
#define JPRIM_SRC_BUILD_PART_MASS_H_

#include <optional>
#include <string>

#include "SimTKcommon.h"

namespace jprim {

/// Mass and inertia of a part as a dataset states them, in SI.
struct PartMass {
    SimTK::Real mass = 0;
    SimTK::Transform X_BC;                    ///< CM marker in the body frame
    SimTK::Transform X_BI;                    ///< inertia marker in the body frame
    std::optional<std::array<double, 6>> ip;  ///< about the inertia marker's origin [kg m^2]
};

/// The tensor of inertia about the mass centre in the body's axes. IP's products are positive integrals
/// +Int(xy dm), so they enter with a minus; I_c = I_i - m (c.c 1 - c ~c) with c from the inertia marker to
/// the mass centre.
SimTK::Mat33 calcCentralInertia(const PartMass& part);

/// Why no body can have this inertia about its mass centre, or empty. The message gives moments in units of
/// `unit`.
std::string findInertiaProblem(const SimTK::Mat33& inertia, SimTK::Real unit);

/// The inertia with its principal moments raised to at least `smallest`.
SimTK::Mat33 raisePrincipalMoments(const SimTK::Mat33& inertia, SimTK::Real smallest, bool& wasRaised);

}  // namespace jprim

#endif
