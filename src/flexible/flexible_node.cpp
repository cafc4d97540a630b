// SPDX-License-Identifier: Apache-2.0
// With theta the Gibbs vector, 2 tan(angle/2) along the axis, and c = 1/(1 + theta.theta/4):
//
//     R_BN: the unit quaternion along (1, theta/2)
//     w = c (theta' + theta x theta'/2)
//     b = c (theta" + theta x theta"/2) + c' (theta' + theta x theta'/2),  c' = -c^2 theta.theta'/2
//     load on eta_k of [m, f]: S_t,k.f + S_r,k.(c (m + m x theta/2))
#include "flexible/flexible_node.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Transform;
using SimTK::Vec3;

FlexibleNode::FlexibleNode(const ModalNode& node, const ModalCoordinates& coordinates)
    : m_id(node.id),
      m_position(node.position),
      m_translation(node.translation),
      m_rotation(node.rotation),
      m_coordinates(coordinates) {
    for (Vec3& shape : m_translation) shape *= coordinates.getScale();
    for (Vec3& shape : m_rotation) shape *= coordinates.getScale();
}

Vec3 FlexibleNode::combine(const std::vector<Vec3>& shapes, const Real* factors) {
    Vec3 sum(0);
    for (const Vec3& shape : shapes) sum += *factors++ * shape;
    return sum;
}

Transform FlexibleNode::calcPose(const Real* eta) const {
    const Vec3 half = combine(m_rotation, eta) / 2;
    const SimTK::Quaternion q(SimTK::Vec4(1, half[0], half[1], half[2]));  // normalizes
    return Transform(SimTK::Rotation(q), m_position + combine(m_translation, eta));
}

SpatialVec FlexibleNode::calcVelocity(const Real* eta, const Real* etaDot) const {
    const Vec3 theta = combine(m_rotation, eta), rate = combine(m_rotation, etaDot);
    const Real c = 1 / (1 + theta.normSqr() / 4);
    return {c * (rate + theta % rate / 2), combine(m_translation, etaDot)};
}

SpatialVec FlexibleNode::calcAcceleration(const Real* eta, const Real* etaDot, const Real* etaDotDot) const {
    const Vec3 theta = combine(m_rotation, eta), rate = combine(m_rotation, etaDot);
    const Real c = 1 / (1 + theta.normSqr() / 4);
    const Real cDot = -c * c * SimTK::dot(theta, rate) / 2;
    SpatialVec A(cDot * (rate + theta % rate / 2), Vec3(0));
    if (etaDotDot == nullptr) return A;
    const Vec3 second = combine(m_rotation, etaDotDot);
    A[0] += c * (second + theta % second / 2);
    A[1] = combine(m_translation, etaDotDot);
    return A;
}

void FlexibleNode::addModalLoads(const Real* eta, const SpatialVec& F_N, Real* loads) const {
    const Vec3 theta = combine(m_rotation, eta);
    const Real c = 1 / (1 + theta.normSqr() / 4);
    const Vec3 onTheta = c * (F_N[0] + F_N[0] % theta / 2);
    for (size_t k = 0; k < m_translation.size(); ++k)
        loads[k] += SimTK::dot(m_translation[k], F_N[1]) + SimTK::dot(m_rotation[k], onTheta);
}

}  // namespace jprim
