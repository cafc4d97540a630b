// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_JOINT_MOTION_H_
#define JPRIM_JOINT_MOTION_H_

#include <string>

#include "jprim/base/units.h"
#include "jprim/general/general_constraint.h"

namespace jprim {

/// A coordinate of marker I relative to marker J.
enum class Coordinate {
    X,  ///< of I's origin along J's axes
    Y,
    Z,
    Rotation,  ///< about the common z axis: the angle from x_J to x_I
    B1,        ///< body-fixed 1-2-3 angles: R_JI = Rx(B1) Ry(B2) Rz(B3)
    B2,
    B3
};

[[nodiscard]] Dimension getDimension(Coordinate coordinate);

/// The coordinate as an expression, in the system's units and rad; the keys of I and J are 1 and 2. Angles
/// are within half a turn, or with `countTurns` a Rotation counts whole turns.
[[nodiscard]] Expression makeCoordinate(const Marker& I, const Marker& J, Coordinate coordinate,
                                        bool countTurns = false);

/// Adams' MOTION: a coordinate, its rate or its acceleration is a function of time. One equation; of
/// positions, velocities or accelerations, and only what it prescribes is kept exactly. The reaction is the
/// load that drives I: a force along an axis of J or, at the coordinate's axis, a torque. Source:
/// Adams/Solver, statement MOTION.
class PrescribedMotion : public TypedConstraint<PrescribedMotion, GeneralConstraint> {
public:
    static constexpr const char* ClassName = "PrescribedMotion";
    static bool isInstanceOf(const SimTK::Constraint& constraint);

    /// An empty handle; good only to be assigned to.
    PrescribedMotion() = default;
    /// @param function  of nothing but TIME; an angle may go on for whole turns
    /// @param level     what the function gives: the coordinate, its rate or its acceleration
    /// @throws Error as GeneralConstraint and as primitives do
    PrescribedMotion(const Marker& I, const Marker& J, Coordinate coordinate, const Expression& function,
                     KinematicLevel level = KinematicLevel::Position, const std::string& name = "");

    /// [moment, force] on the marker's body at its origin, in Ground. Requires Stage::Acceleration.
    SimTK::SpatialVec calcReactionOnI(const SimTK::State& state) const;
    SimTK::SpatialVec calcReactionOnJ(const SimTK::State& state) const;
};

}  // namespace jprim

#endif
