// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "mechanism/bodies/bodies.h"

namespace jprim {

using SimTK::Real;

Real findLightestMass(const Dataset& dataset, const UnitSystem& units) {
    Real lightest = SimTK::Infinity;
    const auto weigh = [&](const auto& statements) {
        for (const auto& s : statements)
            if (s.mass.value_or(0) > 0) lightest = std::min(lightest, *s.mass * units.mass);
    };
    weigh(dataset.parts);
    weigh(dataset.pointMasses);
    return lightest == SimTK::Infinity ? 1 : lightest;
}

MechanismPart startPart(const std::string& name, const RigidCoordinates& statement, int place,
                        const BodyContext& context) {
    const UnitSystem& units = context.contents.units;
    MechanismPart part;
    part.name = name;
    part.givenPose = context.poses.getPartPose(place);
    part.exact = statement.exact;
    for (int k = 0; k < 3; ++k) {
        if (statement.v[k]) part.v[k] = *statement.v[k] * units.getVelocity();
        if (statement.w[k]) part.w[k] = *statement.w[k] * units.getAngularVelocity();
    }
    return part;
}

}  // namespace jprim
