// SPDX-License-Identifier: Apache-2.0
#include "mechanism/part_mass.h"

#include <algorithm>
#include <cmath>

#include "jprim/mechanism/build_mechanism.h"
#include "linear_algebra/conversion.h"
#include "linear_algebra/eigenvalues.h"

namespace jprim {

using SimTK::Mat33;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::Vec3;

namespace {

Real getLargest(const Vec3& ascending) {
    return std::max(ascending[2], -ascending[0]);
}

// Datasets carry six digits or so: what a shift to the mass centre leaves of a moment that should be zero.
constexpr Real DigitsLost = 1e-5;
// Of the largest moment: a positive one is zero; a sum of two that is the third.
constexpr Real Vanishing = 1e-9, Rounding = 1e-9;

}  // namespace

Mat33 calcCentralInertia(const PartMass& part) {
    const std::array<double, 6> ip = part.ip.value_or(std::array<double, 6>{});
    const Mat33 aboutMarker(ip[0], -ip[3], -ip[4],  //
                            -ip[3], ip[1], -ip[5],  //
                            -ip[4], -ip[5], ip[2]);
    const Vec3 c = ~part.X_BI.R() * (part.X_BC.p() - part.X_BI.p());
    const Mat33 central = aboutMarker - part.mass * (SimTK::dot(c, c) * Mat33(1) - SimTK::outer(c, c));
    return Mat33(part.X_BI.R()) * central * Mat33(~part.X_BI.R());
}

Vec3 calcPrincipalMoments(const Mat33& inertia) {
    return toVec3(calcPrincipalAxes(toEigen(inertia)).values);
}

Real calcTriangleExcess(const Vec3& moments) {
    const Real excess = moments[2] - moments[1] - moments[0];
    return excess > Rounding * getLargest(moments) ? excess : 0;
}

bool hasNegativeMoment(const Vec3& moments) {
    return moments[0] < -DigitsLost * getLargest(moments);
}

std::string findMassProblem(Real mass, const Mat33& inertia) {
    if (!std::isfinite(mass) || !std::isfinite(inertia.norm()))
        return "mass or inertia about the mass centre is too large to be a number";
    constexpr Real Smallest = 1e-200;  // Simbody divides by the mass, and by squares of it
    if (mass != 0 && mass < Smallest) return "the mass is too small to divide by";
    return "";
}

SolvableMass makeSolvable(Real mass, const Mat33& inertia, Real size, Real lightestMass) {
    SolvableMass result{mass, inertia, mass == 0, false};
    if (result.massReplaced) result.mass = MasslessFraction * lightestMass;
    const Real shape = (result.massReplaced ? 1 : MasslessFraction) * result.mass * size * size;

    const PrincipalAxes principal = calcPrincipalAxes(toEigen(inertia));
    Eigen::Vector3d moments = principal.values;
    const Real largest = moments.cwiseAbs().maxCoeff();
    const Real little = largest > 0 ? MasslessFraction * largest : shape;
    for (Real& moment : moments) {
        if (moment > Vanishing * largest || moment < -DigitsLost * largest) continue;
        moment = little;
        result.inertiaReplaced = true;
    }
    if (!result.inertiaReplaced) return result;
    const Eigen::Matrix3d m = principal.axes * moments.asDiagonal() * principal.axes.transpose();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result.inertia(i, j) = (m(i, j) + m(j, i)) / 2;
    return result;
}

}  // namespace jprim
