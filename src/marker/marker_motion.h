// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_MARKER_MOTION_H_
#define JPRIM_SRC_MARKER_MARKER_MOTION_H_

#include "flexible/flexible_node.h"

/// @file
/// How a marker M moves in its body frame B, and with it. This is where rigid and flexible markers differ,
/// and nowhere else: `node` is null for a marker fixed to B, and then the coordinates eta are not looked at.
/// A SpatialVec is [angular, linear] of M's origin; names without a frame are in B.
namespace jprim {

/// X_BM. `X` is X_BM of a rigid marker and X_NM of a flexible one.
inline SimTK::Transform calcPoseInBody(const FlexibleNode* node, const SimTK::Transform& X,
                                       const SimTK::Real* eta) {
    return node == nullptr ? X : node->calcPose(eta) * X;
}

/// V_BM of a flexible marker.
SimTK::SpatialVec calcVelocityInBody(const FlexibleNode& node, const SimTK::Transform& X_NM,
                                     const SimTK::Real* eta, const SimTK::Real* etaDot);

/// A_BM of a flexible marker; without second derivatives of eta if etaDotDot is null.
SimTK::SpatialVec calcAccelerationInBody(const FlexibleNode& node, const SimTK::Transform& X_NM,
                                         const SimTK::Real* eta, const SimTK::Real* etaDot,
                                         const SimTK::Real* etaDotDot);

/// Adds to `loads` what a load [moment, force] in B at M's origin does to each coordinate.
void addModalLoads(const FlexibleNode& node, const SimTK::Transform& X_NM, const SimTK::Real* eta,
                   const SimTK::SpatialVec& F_M, SimTK::Real* loads);

/// A marker's motion in a frame A from its body's: V_AM = V_AB moved by s = R_AB p_BM, plus R_AB V_BM.
SimTK::SpatialVec composeVelocity(const SimTK::SpatialVec& V_AB, const SimTK::Vec3& s,
                                  const SimTK::SpatialVec& RV_BM);

/// A_AM = A_AB moved by s, plus R_AB A_BM, plus w_AB x R_AB [w_BM, 2 v_BM].
SimTK::SpatialVec composeAcceleration(const SimTK::SpatialVec& A_AB, const SimTK::Vec3& w_AB,
                                      const SimTK::Vec3& s, const SimTK::SpatialVec& RV_BM,
                                      const SimTK::SpatialVec& RA_BM);

}  // namespace jprim

#endif
