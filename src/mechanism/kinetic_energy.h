// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_KINETIC_ENERGY_H_
#define JPRIM_SRC_MECHANISM_KINETIC_ENERGY_H_

#include <vector>

#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// A body with a negative principal moment of inertia.
struct NegativeInertia {
    SimTK::MobilizedBody body;
    SimTK::Mat33 inertia;  ///< about the mass centre, in the body's axes
};

/// Which of them take all kinetic energy from a motion that the constraints allow in the given positions, or in those
/// nearby that fit: then the mechanism has no accelerations. It is the mechanism's coordinates that count: a part that
/// only turns about z may have any moment about x.
///
/// The energy of a motion is held against what it would be with all negative moments taken positive, so that it does
/// not matter how large or heavy anything is.
std::vector<bool> findHarmful(const Mechanism& mechanism, const std::vector<NegativeInertia>& inertias);

}  // namespace jprim

#endif
