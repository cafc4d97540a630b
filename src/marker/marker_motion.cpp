// SPDX-License-Identifier: Apache-2.0
#include "marker/marker_motion.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Transform;
using SimTK::Vec3;

SpatialVec calcVelocityInBody(const FlexibleNode& node, const Transform& X_NM, const Real* eta,
                              const Real* etaDot) {
    const Vec3 d = node.calcPose(eta).R() * X_NM.p();
    return SimTK::shiftVelocityBy(node.calcVelocity(eta, etaDot), d);
}

SpatialVec calcAccelerationInBody(const FlexibleNode& node, const Transform& X_NM, const Real* eta,
                                  const Real* etaDot, const Real* etaDotDot) {
    const Vec3 d = node.calcPose(eta).R() * X_NM.p();
    return SimTK::shiftAccelerationBy(node.calcAcceleration(eta, etaDot, etaDotDot),
                                      node.calcVelocity(eta, etaDot)[0], d);
}

void addModalLoads(const FlexibleNode& node, const Transform& X_NM, const Real* eta, const SpatialVec& F_M,
                   Real* loads) {
    const Vec3 d = node.calcPose(eta).R() * X_NM.p();
    node.addModalLoads(eta, SimTK::shiftForceBy(F_M, -d), loads);
}

SpatialVec composeVelocity(const SpatialVec& V_AB, const Vec3& s, const SpatialVec& RV_BM) {
    return SimTK::shiftVelocityBy(V_AB, s) + RV_BM;
}

SpatialVec composeAcceleration(const SpatialVec& A_AB, const Vec3& w_AB, const Vec3& s,
                               const SpatialVec& RV_BM, const SpatialVec& RA_BM) {
    const SpatialVec coriolis(w_AB % RV_BM[0], 2. * (w_AB % RV_BM[1]));
    return SimTK::shiftAccelerationBy(A_AB, w_AB, s) + RA_BM + coriolis;
}

}  // namespace jprim
