// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_CONFORMANCE_H_
#define JPRIM_TESTS_SUPPORT_CONFORMANCE_H_

#include <Simbody.h>

#include <functional>

#include "jprim/marker/marker.h"

namespace jprim::testing {

/// How far one constraint, of positions or of velocities, is from the identities that every constraint must satisfy off its
/// manifold, at random poses and velocities. Errors are relative to the size of what is compared.
struct Conformance {
    double rateError = 0;          ///< de/dt against central differences of e along the motion
    double accelerationError = 0;  ///< d2e/dt2 against central differences of de/dt
    double powerError = 0;         ///< Jacobian of the errors against the transpose of the forces
    double netLoad = 0;            ///< sum of the constraint forces, as a wrench about a far point
    int rank = 0;                  ///< of the constraint Jacobian
    int equations = 0;
};

/// Adds the constraint to be tested between two markers and returns it.
using AddConstraint = std::function<SimTK::Constraint(const Marker& I, const Marker& J)>;

/// What carries the markers. AncestorMoves: I and J are both on children of a moving body, so that the frame
/// in which Simbody hands over poses, their ancestor, is not Ground. Flexible…: on nodes of flexible beams.
enum class Tree { AncestorMoves, IOnGround, JOnGround, FlexibleI, FlexibleJ, FlexibleBoth };

const char* getName(Tree tree);

/// Measures one constraint at one random state.
Conformance measureConformance(const AddConstraint& add, Tree tree, int seed);

/// A random rotation, uniform over SO(3), and a random vector with components in [-1, 1].
SimTK::Rotation makeRandomRotation(SimTK::Random& random);
SimTK::Vec3 makeRandomVec3(SimTK::Random& random);

/// Of equations that are expressions.
namespace expressions {
// Differences of sixth order leave about 1e-11 on smooth functions of order one; angles near the poles of their
// sequence have large higher derivatives.
constexpr double DifferenceTolerance = 1e-7;
constexpr double RoundingTolerance = 1e-12;
}  // namespace expressions

}  // namespace jprim::testing

#endif
