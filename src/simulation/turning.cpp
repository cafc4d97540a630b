// SPDX-License-Identifier: Apache-2.0
#include "simulation/turning.h"

#include <algorithm>
#include <cmath>

namespace jprim {

using SimTK::Real;
using SimTK::State;

Real calcLargestAngularVelocity(const Mechanism& mechanism, const State& state) {
    Real w = 0;
    for (const MechanismPart& part : mechanism.getParts())
        if (!part.ground) w = std::max(w, part.body.getBodyAngularVelocity(state).norm());
    return w;
}

Real calcTimeOfARadian(const Mechanism& mechanism, const State& state) {
    const Real w = calcLargestAngularVelocity(mechanism, state);
    Real a = 0;
    for (const MechanismPart& part : mechanism.getParts())
        if (!part.ground) a = std::max(a, part.body.getBodyAngularAcceleration(state).norm());
    const Real rate = w + std::sqrt(w * w + 2 * a);
    return rate > 0 ? 2 / rate : SimTK::Infinity;
}

}  // namespace jprim
