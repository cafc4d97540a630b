// SPDX-License-Identifier: Apache-2.0
#include "mechanism/frames.h"

#include "jprim/marker/angles.h"

namespace jprim {

using SimTK::CoordinateAxis;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;

namespace {

Vec3 toVec3(const Triple& t) {
    return {t[0], t[1], t[2]};
}

// Directions closer to parallel than this span no plane.
constexpr Real SmallestSine = 1e-9;

struct Direction {
    CoordinateAxis axis;
    std::optional<Vec3> vector;
};

// The frame whose first axis has the first direction and whose second axis is as near to the second as can
// be. A missing second direction is the base frame's axis, or its y axis if that is along the first.
Rotation makeAxes(const Direction& first, Direction second, std::string& problem) {
    if (first.vector->norm() == 0) {
        problem = std::string("the point for the ") + (first.axis == SimTK::ZAxis ? "z" : "x") +
                  " axis lies at the origin of the frame; give another point";
        return Rotation();
    }
    const UnitVec3 along(*first.vector);
    const auto isAlong = [&along](const Vec3& v) { return (along % v).norm() <= SmallestSine * v.norm(); };
    if (!second.vector) {
        second.vector = Vec3(UnitVec3(second.axis));
        if (isAlong(*second.vector)) *second.vector = Vec3(0, 1, 0);
    } else if (isAlong(*second.vector)) {
        problem =
            "the points for the x and the z axis lie on one line through the origin of the frame; "
            "give another point";
        return Rotation();
    }
    return Rotation(along, first.axis, *second.vector, second.axis);
}

}  // namespace

Transform makeFrame(const FrameStatement& statement, double lengthToSI, std::string& problem) {
    const Vec3 origin = toVec3(statement.origin.value_or(Triple{}));
    const Transform translated(lengthToSI * origin);
    if (statement.reuler) return Transform(makeRotation313(toVec3(*statement.reuler)), translated.p());

    Direction z{SimTK::ZAxis, std::nullopt}, x{SimTK::XAxis, std::nullopt};
    if (statement.zPoint) z.vector = toVec3(*statement.zPoint) - origin;
    if (statement.xPoint) x.vector = toVec3(*statement.xPoint) - origin;
    if (!z.vector && !x.vector) return translated;
    const bool xLeads = x.vector && (statement.xFirst || !z.vector);
    const Rotation R = xLeads ? makeAxes(x, z, problem) : makeAxes(z, x, problem);
    return Transform(R, translated.p());
}

}  // namespace jprim
