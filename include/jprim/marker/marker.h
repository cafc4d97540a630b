// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MARKER_MARKER_H_
#define JPRIM_MARKER_MARKER_H_

#include <memory>

#include "SimTKsimbody.h"
#include "jprim/flexible/flexible_body.h"
#include "jprim/simbody_abi.h"

namespace jprim {

/// A frame M fixed to a body B, or to a node N of a flexible body: Adams' MARKER. A value: copies refer to
/// the same body, and nothing changes when the marker goes away. Lengths are in the system's length unit:
/// metres, unless a Mechanism has another (Mechanism::getLengthUnit).
class Marker {
public:
    /// A marker on no body; good only to be assigned to.
    Marker() = default;

    /// @param body  any mobilized body, Ground included
    /// @param X_BM  the marker's pose in the body frame B; B itself by default
    /// @throws Error if the pose is not finite
    explicit Marker(const SimTK::MobilizedBody& body, const SimTK::Transform& X_BM = SimTK::Transform());

    /// A marker that moves with a node of a flexible body: a rigid lever of length X_NM.p() welded to the
    /// node. (For a marker that follows the mean axes, give the flexible body's getBody().)
    /// @param body  the flexible body
    /// @param node  id of a node of its basis
    /// @param X_NM  the marker's pose in the node's frame, which undeformed has the axes of the mesh
    /// @throws Error if the basis has no such node or the pose is not finite
    Marker(const FlexibleBody& body, int node, const SimTK::Transform& X_NM = SimTK::Transform());

    /// True if the marker has a body and that body belongs to a matter subsystem.
    bool isOnBody() const;
    /// True if the marker is on a node of a flexible body.
    bool isFlexible() const { return m_node != nullptr; }

    /// The mobilized body; of a flexible body that of its mean axes.
    const SimTK::MobilizedBody& getBody() const { return m_body; }
    /// X_BM, or X_NM of a flexible marker.
    const SimTK::Transform& getPose() const { return m_X; }
    /// The same marker with another X_BM or X_NM. @throws Error if that is not finite
    Marker withPose(const SimTK::Transform& X) const;

    /// Pose in the body frame: deformed as in the State, which must have been realized to Stage::Model; or
    /// undeformed.
    SimTK::Transform findPoseInBody(const SimTK::State& state) const;
    SimTK::Transform getUndeformedPoseInBody() const;

    /// Pose in Ground. Requires Stage::Position.
    SimTK::Transform findPoseInGround(const SimTK::State& state) const;
    /// [angular velocity, velocity of the origin] in Ground. Requires Stage::Velocity.
    SimTK::SpatialVec findVelocityInGround(const SimTK::State& state) const;
    /// [angular acceleration, acceleration of the origin] in Ground. Requires Stage::Acceleration.
    SimTK::SpatialVec findAccelerationInGround(const SimTK::State& state) const;

    /// Adds a load [moment, force] in Ground at the marker's origin to the forces of a
    /// SimTK::Force::Custom::Implementation: on the body, and on the modal coordinates of a flexible marker.
    /// Requires Stage::Position.
    void applyLoad(const SimTK::State& state, const SimTK::SpatialVec& load_G,
                   SimTK::Vector_<SimTK::SpatialVec>& bodyForces, SimTK::Vector& mobilityForces) const;

    /// For implementing constraints; null if the marker is not flexible.
    const std::shared_ptr<const FlexibleNode>& getNode() const { return m_node; }

private:
    SimTK::MobilizedBody m_body;
    std::shared_ptr<const FlexibleNode> m_node;
    SimTK::Transform m_X;
};

}  // namespace jprim

#endif
