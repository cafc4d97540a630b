// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_POWER_H_
#define JPRIM_SRC_MECHANISM_POWER_H_

#include <vector>

#include "jprim/flexible/flexible_body.h"
#include "jprim/force/marker_force.h"

namespace jprim {

/// What puts loads on a system's bodies, sorted by what is known of its energy.
struct Loads {
    SimTK::Vec3 gravity{0};                      ///< the acceleration
    std::vector<MarkerForce> forces;             ///< with a potential or without
    std::vector<FlexibleBody> flexibleBodies;    ///< modes that are springs and dampers
    std::vector<SimTK::Constraint> constraints;  ///< that may do work
};

/// The power of all loads that the potential energy does not tell of: all power, and what the potential energy gains.
/// Requires Stage::Dynamics, and multipliers where there are constraints.
SimTK::Real calcPowerWithoutPotential(const SimTK::MultibodySystem& system, const Loads& loads,
                                      const SimTK::State& state);

}  // namespace jprim

#endif
