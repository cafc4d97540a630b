// SPDX-License-Identifier: Apache-2.0
#include "simulation/body_jacobian.h"

namespace jprim {

using SimTK::MobilizedBody;
using SimTK::MobilizedBodyIndex;
using SimTK::SpatialVec;
using SimTK::Vec3;

// A body moves as its parent does and by its own mobilizer.
BodyJacobian::BodyJacobian(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state)
    : m_columns(size_t(matter.getNumBodies())) {
    for (MobilizedBodyIndex b(1); b < matter.getNumBodies(); ++b) {
        const MobilizedBody& body = matter.getMobilizedBody(b);
        const MobilizedBody& parent = body.getParentMobilizedBody();
        const Vec3 lever = body.getBodyOriginLocation(state) - parent.getBodyOriginLocation(state);
        auto& columns = m_columns[size_t(b)];
        for (const auto& [speed, V] : m_columns[size_t(parent.getMobilizedBodyIndex())])
            columns.emplace_back(speed, SpatialVec(V[0], V[1] + V[0] % lever));
        for (SimTK::MobilizerUIndex k(0); k < body.getNumU(state); ++k)
            columns.emplace_back(int(body.getFirstUIndex(state)) + int(k), body.getHCol(state, k));
    }
}

void BodyJacobian::addRow(const Directions& directions, double factor, int row, Triplets& entries) const {
    for (int j = 0; j < directions.onSpeeds.size(); ++j)
        if (directions.onSpeeds[j] != 0) entries.emplace_back(row, j, factor * directions.onSpeeds[j]);
    for (size_t b = 1; b < m_columns.size(); ++b) {
        const SpatialVec& direction = directions.onBodies[int(b)];
        if (direction[0] == Vec3(0) && direction[1] == Vec3(0)) continue;
        for (const auto& [speed, V] : m_columns[b])
            entries.emplace_back(row, speed, factor * (~direction[0] * V[0] + ~direction[1] * V[1]));
    }
}

void BodyJacobian::addBody(MobilizedBodyIndex body, double turnFactor, double shiftFactor, int row,
                           Triplets& entries) const {
    for (const auto& [speed, V] : m_columns[size_t(body)])
        for (int k = 0; k < 6; ++k) {
            const double value = k < 3 ? turnFactor * V[0][k] : shiftFactor * V[1][k - 3];
            if (value != 0) entries.emplace_back(row + k, speed, value);
        }
}

}  // namespace jprim
