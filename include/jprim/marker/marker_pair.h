// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MARKER_MARKER_PAIR_H_
#define JPRIM_MARKER_MARKER_PAIR_H_

#include "SimTKsimbody.h"
#include "jprim/simbody_abi.h"

namespace jprim {

/// To the load F = [m, f] at I's origin the opposite one at J's: [-m - r x f, -f], with r from J's origin to I's. The
/// lever r x f makes it the same wrench.
inline SimTK::SpatialVec calcOppositeLoad(const SimTK::SpatialVec& F, const SimTK::Vec3& r) {
    return {-F[0] - r % F[1], -F[1]};
}

/// Motion of marker I relative to marker J, **seen from J and expressed in J**, and the way back: a load
/// between the two, as it acts on each. Every cross product of relative motion in jprim is in this header.
///
/// The inputs are poses, velocities and accelerations in any frame A. What comes out does not depend on
/// which, so the errors of a constraint built on it are the same in every frame.
///
/// A SpatialVec is [angular, linear]: of a motion, about and of the marker's origin; of a load, [moment
/// about that origin, force].
class MarkerPair {
public:
    /// @param X_AI,X_AJ  poses of the markers in A
    MarkerPair(const SimTK::Transform& X_AI, const SimTK::Transform& X_AJ)
        : m_R_AJ(X_AJ.R()), m_r_A(X_AI.p() - X_AJ.p()), m_R(~X_AJ.R() * X_AI.R()), m_p(~X_AJ.R() * m_r_A) {}

    /// R = R_JI: orientation of I in J.
    const SimTK::Rotation& getRotation() const { return m_R; }
    /// p = ~R_AJ r: from J's origin to I's, in J.
    const SimTK::Vec3& getPosition() const { return m_p; }

    /// [w, v] in J: w = ~R_AJ (w_AI - w_AJ), v = dp/dt = ~R_AJ (v_AI - v_AJ - w_AJ x r).
    SimTK::SpatialVec calcVelocity(const SimTK::SpatialVec& V_AI, const SimTK::SpatialVec& V_AJ) const {
        return {~m_R_AJ * (V_AI[0] - V_AJ[0]), ~m_R_AJ * calcVelocityOfISeenFromJ(V_AI, V_AJ)};
    }

    /// [dw/dt, d2p/dt2] in J, the derivatives as J sees them:
    /// ~R_AJ (b_AI - b_AJ - w_AJ x (w_AI - w_AJ)) and
    /// ~R_AJ (a_AI - a_AJ - b_AJ x r - w_AJ x (w_AJ x r) - 2 w_AJ x (v_AI - v_AJ - w_AJ x r)).
    SimTK::SpatialVec calcAcceleration(const SimTK::SpatialVec& V_AI, const SimTK::SpatialVec& V_AJ,
                                       const SimTK::SpatialVec& A_AI, const SimTK::SpatialVec& A_AJ) const {
        const SimTK::Vec3& w_AJ = V_AJ[0];
        const SimTK::Vec3 rdot_A = calcVelocityOfISeenFromJ(V_AI, V_AJ);
        const SimTK::Vec3 angular = A_AI[0] - A_AJ[0] - w_AJ % (V_AI[0] - V_AJ[0]);
        const SimTK::Vec3 linear =
            A_AI[1] - A_AJ[1] - A_AJ[0] % m_r_A - w_AJ % (w_AJ % m_r_A) - 2. * (w_AJ % rdot_A);
        return {~m_R_AJ * angular, ~m_R_AJ * linear};
    }

    /// The load F_J = [moment, force] on I at I's origin, given in J: the same in A.
    SimTK::SpatialVec calcLoadOnI(const SimTK::SpatialVec& F_J) const { return m_R_AJ * F_J; }

    /// The opposite load, at J's origin, in A.
    SimTK::SpatialVec calcLoadOnJ(const SimTK::SpatialVec& F_J) const {
        return calcOppositeLoad(m_R_AJ * F_J, m_r_A);
    }

private:
    SimTK::Vec3 calcVelocityOfISeenFromJ(const SimTK::SpatialVec& V_AI, const SimTK::SpatialVec& V_AJ) const {
        return V_AI[1] - V_AJ[1] - V_AJ[0] % m_r_A;
    }

    SimTK::Rotation m_R_AJ;
    SimTK::Vec3 m_r_A;
    SimTK::Rotation m_R;
    SimTK::Vec3 m_p;
};

}  // namespace jprim

#endif
