// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_CONSTRAINED_MARKER_H_
#define JPRIM_SRC_MARKER_CONSTRAINED_MARKER_H_

#include <memory>

#include "marker/marker_motion.h"

namespace jprim {

/// A marker of a custom constraint, in the terms in which Simbody talks to constraints: the body is a
/// constrained body with its pose and velocity in the ancestor A, and the coordinates of a flexible marker
/// are consecutive ones among the constrained coordinates. `X` is always X_BM of a rigid marker and X_NM of a
/// flexible one.
struct ConstrainedMarker {
    SimTK::ConstrainedBodyIndex body;
    std::shared_ptr<const FlexibleNode> node;  ///< null if the marker is fixed to the body
    int firstCoordinate = 0;

    int getNumCoordinates() const { return node ? node->getNumModes() : 0; }

    /// The coordinates, or null of a rigid marker.
    const SimTK::Real* getEta(const SimTK::State& state) const {
        return node ? node->getCoordinates().getEta(state) : nullptr;
    }
    const SimTK::Real* findEta(const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>& q) const {
        return node ? q.cbegin() + firstCoordinate : nullptr;
    }

    /// X_AM.
    SimTK::Transform calcPose(const SimTK::Transform& X_AB, const SimTK::Transform& X,
                              const SimTK::Real* eta) const {
        return X_AB * calcPoseInBody(node.get(), X, eta);
    }
    /// V_AM.
    SimTK::SpatialVec calcVelocity(const SimTK::State& state, const SimTK::Transform& X_AB,
                                   const SimTK::SpatialVec& V_AB, const SimTK::Transform& X) const;
    /// A_AM where neither the body nor the coordinates accelerate.
    SimTK::SpatialVec calcAccelerationBias(const SimTK::State& state, const SimTK::Transform& X_AB,
                                           const SimTK::SpatialVec& V_AB, const SimTK::Transform& X) const;
    /// Adds to `loads` what a load [moment, force] in A at M's origin does to each coordinate; nothing for a
    /// rigid marker.
    void addModalLoads(const SimTK::State& state, const SimTK::Transform& X_AB, const SimTK::Transform& X,
                       const SimTK::SpatialVec& F_A, SimTK::Real* loads) const;
};

}  // namespace jprim

#endif
