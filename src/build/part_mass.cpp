// SPDX-License-Identifier: Apache-2.0
#include "build/part_mass.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "jprim/build/build_mechanism.h"

namespace jprim {

using SimTK::Mat33;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::Vec3;

namespace {

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;

Solver solve(const Mat33& inertia) {
    Eigen::Matrix3d m;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) m(i, j) = inertia(i, j);
    return Solver(m);
}

// Datasets carry six digits or so; a thin rod's moments may miss the triangle inequality by their last.
constexpr Real DigitsLost = 1e-5;

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

std::string findMassProblem(Real mass, const Mat33& inertia, Real unit) {
    if (!std::isfinite(mass) || !std::isfinite(inertia.norm()))
        return "mass or inertia about the mass centre is too large to be a number";
    constexpr Real Smallest = 1e-200;  // Simbody divides by the mass, and by squares of it
    if (mass != 0 && mass < Smallest) return "the mass is too small to divide by";
    const Eigen::Vector3d moments = solve(inertia).eigenvalues() / unit;  // ascending
    if (moments[0] < -DigitsLost * moments[2] || moments[2] < 0)
        return fmt::format("one of its principal moments about the mass centre is negative ({:.6g})",
                           moments[0]);
    if (moments[2] > (moments[0] + moments[1]) * (1 + DigitsLost))
        return fmt::format(
            "its largest principal moment about the mass centre ({:.6g}) is larger than "
            "the sum of the other two ({:.6g})",
            moments[2], moments[0] + moments[1]);
    return "";
}

SolvableMass makeSolvable(Real mass, const Mat33& inertia, Real size, Real lightestMass) {
    SolvableMass result{mass, inertia, mass == 0, false};
    if (result.massReplaced) result.mass = MasslessFraction * lightestMass;
    const Real shape = (result.massReplaced ? 1 : MasslessFraction) * result.mass * size * size;

    const Solver solver = solve(inertia);
    const Real largest = solver.eigenvalues()[2];
    const Real smallest = largest > 0 ? MasslessFraction * largest : shape;
    result.inertiaReplaced = solver.eigenvalues()[0] < smallest;
    if (!result.inertiaReplaced) return result;
    const Eigen::Vector3d raised = solver.eigenvalues().array().max(0) + smallest;
    const Eigen::Matrix3d m = solver.eigenvectors() * raised.asDiagonal() * solver.eigenvectors().transpose();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result.inertia(i, j) = (m(i, j) + m(j, i)) / 2;
    return result;
}

}  // namespace jprim
