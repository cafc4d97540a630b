// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_FLEXIBLE_NODE_H_
#define JPRIM_SRC_FLEXIBLE_FLEXIBLE_NODE_H_

#include <vector>

#include "flexible/modal_coordinates.h"
#include "jprim/flexible/modal_basis.h"

namespace jprim {

/// A node of a flexible body in a system: a frame N that moves in the body frame B with the coordinates eta
/// of the State. Undeformed it has B's axes. Its displacement is S_t eta; its rotation has the Gibbs vector
/// theta = S_r eta, which to first order is the small rotation itself.
///
/// All vectors are in B. A SpatialVec is [angular, linear] of N's origin.
class FlexibleNode {
public:
    FlexibleNode(const ModalNode& node, const ModalCoordinates& coordinates);

    int getId() const { return m_id; }
    const SimTK::Vec3& getPosition() const { return m_position; }  ///< undeformed
    const ModalCoordinates& getCoordinates() const { return m_coordinates; }
    int getNumModes() const { return m_coordinates.getNumModes(); }

    /// X_BN.
    SimTK::Transform calcPose(const SimTK::Real* eta) const;
    /// [w_BN, v_BN].
    SimTK::SpatialVec calcVelocity(const SimTK::Real* eta, const SimTK::Real* etaDot) const;
    /// [b_BN, a_BN]; without second derivatives of eta if etaDotDot is null.
    SimTK::SpatialVec calcAcceleration(const SimTK::Real* eta, const SimTK::Real* etaDot,
                                       const SimTK::Real* etaDotDot) const;
    /// Adds to `loads` what a load [moment, force] at N's origin does to each coordinate: the transpose of
    /// calcVelocity()'s dependence on etaDot.
    void addModalLoads(const SimTK::Real* eta, const SimTK::SpatialVec& F_N, SimTK::Real* loads) const;

private:
    static SimTK::Vec3 combine(const std::vector<SimTK::Vec3>& shapes, const SimTK::Real* factors);

    int m_id;
    SimTK::Vec3 m_position;
    std::vector<SimTK::Vec3> m_translation;  // S_t, S_r: of unit eta
    std::vector<SimTK::Vec3> m_rotation;
    ModalCoordinates m_coordinates;
};

}  // namespace jprim

#endif
