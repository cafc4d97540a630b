// SPDX-License-Identifier: Apache-2.0
#include "simulation/position_condition.h"

namespace jprim {

using SimTK::Vec3;

EquationLoads Directions::getNonzero() const {
    EquationLoads loads;
    for (SimTK::MobilizedBodyIndex b(0); b < onBodies.size(); ++b)
        if (onBodies[b][0] != Vec3(0) || onBodies[b][1] != Vec3(0))
            loads.onBodies.emplace_back(b, onBodies[b]);
    for (int j = 0; j < onSpeeds.size(); ++j)
        if (onSpeeds[j] != 0) loads.onSpeeds.emplace_back(j, onSpeeds[j]);
    return loads;
}

}  // namespace jprim
