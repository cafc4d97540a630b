// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_PRIMITIVE_PRIMITIVES_H_
#define JPRIM_PRIMITIVE_PRIMITIVES_H_

#include "jprim/primitive/primitive.h"

/// @file
/// The six joint primitives. With r from J's origin to I's, R the orientation of I in J, p = r in J's axes
/// and z the z axis of I in J, each constructor adds the equations below between two markers.
///
/// All constructors throw Error, naming the primitive, if a marker is on no body, if both markers are on
/// one body or if their bodies belong to different systems. Ground is a body like any other.
namespace jprim {

/// ATPOINT: the origins coincide. Three equations e = p [length]; removes 3 translations.
/// Reaction: a force in any direction, no moment about I's origin.
class AtPoint : public TypedConstraint<AtPoint, Primitive> {
public:
    static constexpr const char *ClassName = "AtPoint", *AdamsType = "ATPOINT";
    static bool isInstanceOf(const SimTK::Constraint& constraint) { return isOfType(constraint, AdamsType); }

    AtPoint() = default;
    AtPoint(const Marker& I, const Marker& J, const std::string& name = "");
};

/// INLINE: I's origin stays on J's z axis. Two equations e = (p_x, p_y) [length]; removes 2 translations.
/// Not symmetric: the line belongs to J. Reaction: a force normal to z_J, no moment about I's origin.
class InLine : public TypedConstraint<InLine, Primitive> {
public:
    static constexpr const char *ClassName = "InLine", *AdamsType = "INLINE";
    static bool isInstanceOf(const SimTK::Constraint& constraint) { return isOfType(constraint, AdamsType); }

    InLine() = default;
    InLine(const Marker& I, const Marker& J, const std::string& name = "");
};

/// INPLANE: I's origin stays in J's xy plane. One equation e = p_z [length]; removes 1 translation.
/// Not symmetric: the plane belongs to J. Reaction: a force along z_J, no moment about I's origin.
class InPlane : public TypedConstraint<InPlane, Primitive> {
public:
    static constexpr const char *ClassName = "InPlane", *AdamsType = "INPLANE";
    static bool isInstanceOf(const SimTK::Constraint& constraint) { return isOfType(constraint, AdamsType); }

    InPlane() = default;
    InPlane(const Marker& I, const Marker& J, const std::string& name = "");
};

/// ORIENTATION: the axes of I equal the axes of J. Three equations e = 2 v, |e| = 2 sin(theta/2), where
/// (q0, v) is the unit quaternion of R with q0 >= 0; removes 3 rotations. The only root is theta = 0. At
/// theta = 180 deg |e| = 2 and the sign of e is arbitrary: a maximum, from exactly which an assembler finds
/// no way down (any nearby start will do). Reaction: a torque in any direction, no force.
class Orientation : public TypedConstraint<Orientation, Primitive> {
public:
    static constexpr const char *ClassName = "Orientation", *AdamsType = "ORIENTATION";
    static bool isInstanceOf(const SimTK::Constraint& constraint) { return isOfType(constraint, AdamsType); }

    Orientation() = default;
    Orientation(const Marker& I, const Marker& J, const std::string& name = "");
};

/// PARALLEL_AXES: z_I is parallel to z_J **and points the same way**. Two equations
/// e = 2 (-z_y, z_x) / s with s = sqrt(2 (1 + z_z)), |e| = 2 sin(theta/2) for the angle theta between the
/// axes; removes 2 rotations. The only root is theta = 0. At theta = 180 deg |e| = 2 and the direction of e
/// is arbitrary. Reaction: a torque normal to z_J (on the manifold), no force.
class ParallelAxes : public TypedConstraint<ParallelAxes, Primitive> {
public:
    static constexpr const char *ClassName = "ParallelAxes", *AdamsType = "PARALLEL_AXES";
    static bool isInstanceOf(const SimTK::Constraint& constraint) { return isOfType(constraint, AdamsType); }

    ParallelAxes() = default;
    ParallelAxes(const Marker& I, const Marker& J, const std::string& name = "");
};

/// PERPENDICULAR: z_I is perpendicular to z_J. One equation e = z_z = cos(theta); removes 1 rotation.
/// theta = +90 and -90 deg are both solutions. Singular where the axes are parallel.
/// Reaction: a torque along z_I x z_J, no force.
class Perpendicular : public TypedConstraint<Perpendicular, Primitive> {
public:
    static constexpr const char *ClassName = "Perpendicular", *AdamsType = "PERPENDICULAR";
    static bool isInstanceOf(const SimTK::Constraint& constraint) { return isOfType(constraint, AdamsType); }

    Perpendicular() = default;
    Perpendicular(const Marker& I, const Marker& J, const std::string& name = "");
};

}  // namespace jprim

#endif
