// SPDX-License-Identifier: Apache-2.0
#include "analysis/body_jacobian.h"

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

void BodyJacobian::addRow(const EquationLoads& loads, double factor, int row, Triplets& entries) const {
    for (const auto& [speed, f] : loads.onSpeeds) entries.emplace_back(row, speed, factor * f);
    for (const auto& [body, F] : loads.onBodies)
        for (const auto& [speed, V] : m_columns[size_t(body)])
            entries.emplace_back(row, speed, factor * (~F[0] * V[0] + ~F[1] * V[1]));
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
