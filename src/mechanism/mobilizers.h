// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_MOBILIZERS_H_
#define JPRIM_SRC_MECHANISM_MOBILIZERS_H_

#include "SimTKsimbody.h"
#include "jprim/mechanism/mechanism.h"
#include "mechanism/tree_plan.h"

namespace jprim {

/// A planned mobilizer as one of Simbody's. Its coordinates are those of I relative to J, also if it is
/// reversed; but for the turn that makes z the axis of a Slider or a Universal, its frames are the markers'.
/// @param X_PF  pose on the parent of the marker that is there
/// @param X_BM  pose on the new body of the other
SimTK::MobilizedBody addMobilizer(const PlannedMobilizer& planned, SimTK::MobilizedBody& parent,
                                  const SimTK::Transform& X_PF, const SimTK::Body& body,
                                  const SimTK::Transform& X_BM);

/// The load of a joint that is a mobilizer: the directions that it does not let move. (What a MOTION or a force
/// between the same markers does is theirs.)
class TreeJoint {
public:
    /// @param body      the body that the mobilizer moves
    /// @param reversed  that body carries J
    TreeJoint(const SimTK::MobilizedBody& body, const Marker& I, const Marker& J, bool reversed)
        : m_body(body), m_I(I), m_J(J), m_reversed(reversed) {}

    /// The share [moment, force] of an element, in Ground, on I at I's origin or on J at J's. Requires
    /// Stage::Acceleration.
    SimTK::SpatialVec calcLoadOnI(const SimTK::State& state, LoadShare share) const;
    SimTK::SpatialVec calcLoadOnJ(const SimTK::State& state, LoadShare share) const;

private:
    SimTK::Vec3 calcLever(const SimTK::State& state) const {  // r, from J to I
        return m_I.findPoseInGround(state).p() - m_J.findPoseInGround(state).p();
    }

    SimTK::MobilizedBody m_body;
    Marker m_I, m_J;
    bool m_reversed;
};

}  // namespace jprim

#endif
