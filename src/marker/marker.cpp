// SPDX-License-Identifier: Apache-2.0
#include "jprim/marker/marker.h"

#include "base/format.h"
#include "marker/marker_motion.h"
#include "marker/require_finite.h"

namespace jprim {

using SimTK::MobilizedBody;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

void requireFinitePose(const Transform& X, const MobilizedBody& body) {
    const bool isOnBody = !body.isEmptyHandle() && body.isInSubsystem();
    requireFinite(X, "its",
                  isOnBody ? fmt::format("marker on body {}", int(body.getMobilizedBodyIndex())) : "marker");
}

}  // namespace

Marker::Marker(const MobilizedBody& body, const Transform& X_BM) : m_body(body), m_X(X_BM) {
    requireFinitePose(m_X, m_body);
}

Marker::Marker(const FlexibleBody& body, int node, const Transform& X_NM)
    : m_body(body.getBody()), m_node(body.findNode(node)), m_X(X_NM) {
    requireFinitePose(m_X, m_body);
}

bool Marker::isOnBody() const {
    return !m_body.isEmptyHandle() && m_body.isInSubsystem();
}

Marker Marker::withPose(const Transform& X) const {
    Marker marker(*this);
    requireFinitePose(X, m_body);
    marker.m_X = X;
    return marker;
}

Transform Marker::findPoseInBody(const State& state) const {
    return m_node ? m_node->calcPose(m_node->getCoordinates().getEta(state)) * m_X : m_X;
}

Transform Marker::getUndeformedPoseInBody() const {
    return m_node ? Transform(m_node->getPosition()) * m_X : m_X;
}

Transform Marker::findPoseInGround(const State& state) const {
    return m_body.getBodyTransform(state) * findPoseInBody(state);
}

SpatialVec Marker::findVelocityInGround(const State& state) const {
    if (!m_node) return m_body.findFrameVelocityInGround(state, m_X);
    const ModalCoordinates& c = m_node->getCoordinates();
    const SimTK::Rotation& R_GB = m_body.getBodyRotation(state);
    const Vec3 s = R_GB * findPoseInBody(state).p();
    const SpatialVec V_BM = calcVelocityInBody(*m_node, m_X, c.getEta(state), c.getEtaDot(state));
    return composeVelocity(m_body.getBodyVelocity(state), s, R_GB * V_BM);
}

SpatialVec Marker::findAccelerationInGround(const State& state) const {
    if (!m_node) return m_body.findFrameAccelerationInGround(state, m_X);
    const ModalCoordinates& c = m_node->getCoordinates();
    const SimTK::Rotation& R_GB = m_body.getBodyRotation(state);
    const Vec3 s = R_GB * findPoseInBody(state).p();
    const SpatialVec V_BM = calcVelocityInBody(*m_node, m_X, c.getEta(state), c.getEtaDot(state));
    const SpatialVec A_BM =
        calcAccelerationInBody(*m_node, m_X, c.getEta(state), c.getEtaDot(state), c.getEtaDotDot(state));
    return composeAcceleration(m_body.getBodyAcceleration(state), m_body.getBodyAngularVelocity(state), s,
                               R_GB * V_BM, R_GB * A_BM);
}

void Marker::applyLoad(const State& state, const SpatialVec& load_G, SimTK::Vector_<SpatialVec>& bodyForces,
                       SimTK::Vector& mobilityForces) const {
    const Transform& X_GB = m_body.getBodyTransform(state);
    const Vec3 s = X_GB.R() * findPoseInBody(state).p();
    bodyForces[m_body.getMobilizedBodyIndex()] += SimTK::shiftForceBy(load_G, -s);
    if (!m_node) return;
    const ModalCoordinates& c = m_node->getCoordinates();
    addModalLoads(*m_node, m_X, c.getEta(state), ~X_GB.R() * load_G,
                  &mobilityForces[c.getFirstUIndex(state)]);
}

}  // namespace jprim
