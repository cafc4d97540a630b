// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MARKER_MARKER_H_
#define JPRIM_MARKER_MARKER_H_

#include "SimTKsimbody.h"

namespace jprim {

/// A frame M fixed to a body B: Adams' MARKER. A value: copies refer to the same body, and nothing changes
/// when the marker goes away. Lengths are in the system's length unit (SI throughout jprim).
class Marker {
public:
    /// A marker on no body; good only to be assigned to.
    Marker() = default;

    /// @param body  any mobilized body, Ground included
    /// @param X_BM  the marker's pose in the body frame B; B itself by default
    explicit Marker(const SimTK::MobilizedBody& body, const SimTK::Transform& X_BM = SimTK::Transform());

    /// True if the marker has a body and that body belongs to a matter subsystem.
    bool isOnBody() const;

    const SimTK::MobilizedBody& getBody() const { return m_body; }
    const SimTK::Transform& getPose() const { return m_X_BM; }

    /// Pose in Ground. Requires Stage::Position.
    SimTK::Transform findPoseInGround(const SimTK::State& state) const;
    /// [angular velocity, velocity of the origin] in Ground. Requires Stage::Velocity.
    SimTK::SpatialVec findVelocityInGround(const SimTK::State& state) const;
    /// [angular acceleration, acceleration of the origin] in Ground. Requires Stage::Acceleration.
    SimTK::SpatialVec findAccelerationInGround(const SimTK::State& state) const;

private:
    SimTK::MobilizedBody m_body;
    SimTK::Transform m_X_BM;
};

}  // namespace jprim

#endif
