// SPDX-License-Identifier: Apache-2.0
#include "jprim/marker/marker.h"

namespace jprim {

using SimTK::MobilizedBody;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;

Marker::Marker(const MobilizedBody& body, const Transform& X_BM) : m_body(body), m_X_BM(X_BM) {}

bool Marker::isOnBody() const {
    return !m_body.isEmptyHandle() && m_body.isInSubsystem();
}

Transform Marker::findPoseInGround(const State& state) const {
    return m_body.getBodyTransform(state) * m_X_BM;
}

SpatialVec Marker::findVelocityInGround(const State& state) const {
    return m_body.findFrameVelocityInGround(state, m_X_BM);
}

SpatialVec Marker::findAccelerationInGround(const State& state) const {
    return m_body.findFrameAccelerationInGround(state, m_X_BM);
}

}  // namespace jprim
