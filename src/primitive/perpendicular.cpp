// SPDX-License-Identifier: Apache-2.0
// PERPENDICULAR. z is I's z axis in J, w the angular velocity of I in J, e_z the unit vector (0,0,1).
//
//     e       = z_z
//     de/dt   = (w x z)_z = (z x e_z).w,            load: torque lambda (z x e_z)
//     d2e/dt2 = (dw/dt x z + w x (w x z))_z
#include "jprim/primitive/primitives.h"
#include "primitive/primitive_impl.h"

namespace jprim {
namespace {

using SimTK::SpatialVec;
using SimTK::Vec3;

class PerpendicularImpl : public PrimitiveImpl {
public:
    PerpendicularImpl(const Marker& I, const Marker& J, const std::string& name)
        : PrimitiveImpl("PERPENDICULAR", Kind::Rotational, {"rotation between Zi and Zj"}, I, J, name) {}

    Implementation* clone() const override { return new PerpendicularImpl(*this); }

    void calcErrors(const MarkerPair& pair, Errors& e) const override { e[0] = pair.getRotation().z()[2]; }

    void calcDirections(const MarkerPair& pair, Directions& d) const override {
        const Vec3 z = pair.getRotation().z();
        d[0] = SpatialVec(z % Vec3(0, 0, 1), Vec3(0));
    }

    void calcBias(const MarkerPair& pair, const SpatialVec& V_J, Errors& bias) const override {
        const Vec3& w = V_J[0];
        const Vec3 z = pair.getRotation().z();
        bias[0] = (w % (w % z))[2];
    }
};

}  // namespace

Perpendicular::Perpendicular(const Marker& I, const Marker& J, const std::string& name)
    : Primitive(new PerpendicularImpl(I, J, name)) {}

}  // namespace jprim
