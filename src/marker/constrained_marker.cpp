// SPDX-License-Identifier: Apache-2.0
#include "marker/constrained_marker.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

SpatialVec ConstrainedMarker::calcVelocity(const State& state, const Transform& X_AB, const SpatialVec& V_AB,
                                           const Transform& X) const {
    const Real* eta = getEta(state);
    const Vec3 s = X_AB.R() * calcPoseInBody(node.get(), X, eta).p();
    if (!node) return SimTK::shiftVelocityBy(V_AB, s);
    const Real* etaDot = node->getCoordinates().getEtaDot(state);
    return composeVelocity(V_AB, s, X_AB.R() * calcVelocityInBody(*node, X, eta, etaDot));
}

SpatialVec ConstrainedMarker::calcAccelerationBias(const State& state, const Transform& X_AB,
                                                   const SpatialVec& V_AB, const Transform& X) const {
    const SpatialVec none(Vec3(0), Vec3(0));
    const Real* eta = getEta(state);
    const Vec3 s = X_AB.R() * calcPoseInBody(node.get(), X, eta).p();
    if (!node) return SimTK::shiftAccelerationBy(none, V_AB[0], s);
    const Real* etaDot = node->getCoordinates().getEtaDot(state);
    return composeAcceleration(none, V_AB[0], s, X_AB.R() * calcVelocityInBody(*node, X, eta, etaDot),
                               X_AB.R() * calcAccelerationInBody(*node, X, eta, etaDot, nullptr));
}

void ConstrainedMarker::addModalLoads(const State& state, const Transform& X_AB, const Transform& X,
                                      const SpatialVec& F_A, Real* loads) const {
    if (!node) return;
    jprim::addModalLoads(*node, X, getEta(state), ~X_AB.R() * F_A, loads);
}

}  // namespace jprim
