// SPDX-License-Identifier: Apache-2.0
// PARALLEL_AXES, half-angle form. z is I's z axis in J, w the angular velocity of I in J; theta the angle
// between the z axes, s = sqrt(2 (1 + z_z)) = 2 cos(theta/2).
//
//     e      = 2/s (-z_y, z_x)                      |e| = 2 sin(theta/2)
//     E      = de/dz = [0, -2/s, 2 z_y/s^3 ; 2/s, 0, -2 z_x/s^3]
//     dz/dt  = w x z
//     de/dt  = E (w x z),                           load: torque z x (~E lambda)
//     d2e/dt2 = E (dw/dt x z + w x dz/dt) + dE/dt dz/dt
//     d(1/s)/dt = -dz_z/dt / s^3 ,  d(1/s^3)/dt = -3 dz_z/dt / s^5
//
// At theta = 180 deg every direction of e is as good as any other and turning it is infinitely fast: the
// formulas divide by s = 0. Within SmallestS of there z is taken to be tilted back so far, towards its own
// side or, with no side, towards x: size and continuity of e suffer by SmallestS^2, nothing becomes NaN.
#include <algorithm>
#include <cmath>

#include "jprim/primitive/primitives.h"
#include "primitive/pair_equations.h"

namespace jprim {
namespace {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Vec3;

constexpr Real SmallestS = 1e-4;

// I's z axis in J, kept away from -z_J, and the s that belongs to it.
struct TiltedAxis {
    explicit TiltedAxis(const MarkerPair& pair) : z(pair.getRotation().z()) {
        s = std::sqrt(std::max(Real(0), 2 * (1 + z[2])));
        if (s >= SmallestS) return;
        s = SmallestS;
        z[2] = SmallestS * SmallestS / 2 - 1;
        const Real radius = std::sqrt(1 - z[2] * z[2]);
        const Real norm = std::hypot(z[0], z[1]);
        z[0] = norm > 0 ? z[0] * (radius / norm) : radius;
        z[1] = norm > 0 ? z[1] * (radius / norm) : 0;
    }

    // The rows of E.
    Vec3 calcE0() const { return {0, -2 / s, 2 * z[1] / (s * s * s)}; }
    Vec3 calcE1() const { return {2 / s, 0, -2 * z[0] / (s * s * s)}; }

    Vec3 z;
    Real s;
};

class ParallelAxesEquations final : public PairEquations {
public:
    ParallelAxesEquations()
        : PairEquations(Kind::Rotational, {"rotation between Zi and Yj", "rotation between Zi and Xj"}) {}

    void calcErrors(const MarkerPair& pair, Real* e) const override {
        const TiltedAxis axis(pair);
        e[0] = -2 * axis.z[1] / axis.s;
        e[1] = 2 * axis.z[0] / axis.s;
    }

    void calcDirections(const MarkerPair& pair, SpatialVec* d) const override {
        const TiltedAxis axis(pair);
        d[0] = SpatialVec(axis.z % axis.calcE0(), Vec3(0));
        d[1] = SpatialVec(axis.z % axis.calcE1(), Vec3(0));
    }

    void calcBias(const MarkerPair& pair, const SpatialVec& V_J, Real* bias) const override {
        const TiltedAxis axis(pair);
        const Vec3& z = axis.z;
        const Real s3 = axis.s * axis.s * axis.s;
        const Vec3 zdot = V_J[0] % z;
        const Vec3 centripetal = V_J[0] % zdot;
        const Real oneOverSDot = -zdot[2] / s3;
        const Real oneOverS3Dot = -3 * zdot[2] / (s3 * axis.s * axis.s);
        const Vec3 E0dot(0, -2 * oneOverSDot, 2 * (zdot[1] / s3 + z[1] * oneOverS3Dot));
        const Vec3 E1dot(2 * oneOverSDot, 0, -2 * (zdot[0] / s3 + z[0] * oneOverS3Dot));
        bias[0] = SimTK::dot(axis.calcE0(), centripetal) + SimTK::dot(E0dot, zdot);
        bias[1] = SimTK::dot(axis.calcE1(), centripetal) + SimTK::dot(E1dot, zdot);
    }
};

}  // namespace

const PairEquations& getParallelAxesEquations() {
    static const ParallelAxesEquations equations;
    return equations;
}

ParallelAxes::ParallelAxes(const Marker& I, const Marker& J, const std::string& name)
    : TypedHandle(AdamsType, getParallelAxesEquations(), I, J, name) {}

}  // namespace jprim
