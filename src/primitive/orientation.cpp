// SPDX-License-Identifier: Apache-2.0
// ORIENTATION, half-angle form. (q0, v) is the unit quaternion of R with q0 >= 0, w the angular velocity of
// I in J, both in J. The textbook form, three vanishing dot products of axes, also vanishes when I is turned
// by 180 degrees; this one vanishes only at R = 1.
//
//     e      = 2 v
//     de/dt  = q0 w + w x v = (q0 1 - [v]) w
//     load   = torque ~(q0 1 - [v]) lambda = q0 lambda + v x lambda
//     dq0/dt = -1/2 w.v ,  dv/dt = 1/2 (q0 w + w x v)
//     d2e/dt2 = q0 dw/dt + dw/dt x v + dq0/dt w + w x dv/dt
#include "jprim/primitive/primitives.h"
#include "primitive/pair_equations.h"

namespace jprim {
namespace {

using SimTK::Quaternion;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Vec3;

class OrientationEquations final : public PairEquations {
public:
    OrientationEquations()
        : PairEquations(Kind::Rotational,
                        {"rotation between Zi and Yj", "rotation between Zi and Xj", "rotation about Zj"}) {}

    void calcErrors(const MarkerPair& pair, Real* e) const override {
        Vec3::updAs(e) = 2. * calcQuaternion(pair).getSubVec<3>(1);
    }

    void calcDirections(const MarkerPair& pair, SpatialVec* d) const override {
        const Quaternion q = calcQuaternion(pair);
        d[0] = SpatialVec(Vec3(q[0], q[3], -q[2]), Vec3(0));
        d[1] = SpatialVec(Vec3(-q[3], q[0], q[1]), Vec3(0));
        d[2] = SpatialVec(Vec3(q[2], -q[1], q[0]), Vec3(0));
    }

    void calcBias(const MarkerPair& pair, const SpatialVec& V_J, Real* bias) const override {
        const Quaternion q = calcQuaternion(pair);
        const Vec3 v = q.getSubVec<3>(1);
        const Vec3& w = V_J[0];
        const Real q0dot = -0.5 * SimTK::dot(w, v);
        const Vec3 vdot = 0.5 * (q[0] * w + w % v);
        Vec3::updAs(bias) = q0dot * w + w % vdot;
    }

private:
    // SimTK returns the one of the two quaternions whose scalar part is not negative.
    static Quaternion calcQuaternion(const MarkerPair& pair) {
        return pair.getRotation().convertRotationToQuaternion();
    }
};

}  // namespace

const PairEquations& getOrientationEquations() {
    static const OrientationEquations equations;
    return equations;
}

Orientation::Orientation(const Marker& I, const Marker& J, const std::string& name)
    : TypedHandle(AdamsType, getOrientationEquations(), I, J, name) {}

}  // namespace jprim
