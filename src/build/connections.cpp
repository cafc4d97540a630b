// SPDX-License-Identifier: Apache-2.0
#include "build/connections.h"

#include <fmt/format.h>

#include <algorithm>

namespace jprim {

using SimTK::Real;
using SimTK::Rotation;

namespace {

// Which directions of I and J must agree in sense.
enum class Sense { None, ZAxes, AllAxes };

Sense getSense(JprimType type) {
    switch (type) {
        case JprimType::ParallelAxes:
            return Sense::ZAxes;
        case JprimType::Orientation:
            return Sense::AllAxes;
        default:
            return Sense::None;
    }
}

Sense getSense(JointType type) {
    switch (type) {
        case JointType::Revolute:
        case JointType::Cylindrical:
        case JointType::Planar:
            return Sense::ZAxes;
        case JointType::Translational:
        case JointType::Fixed:
            return Sense::AllAxes;
        default:
            return Sense::None;
    }
}

std::string findFlip(Sense sense, const Rotation& R_GI, const Rotation& R_GJ, int i, int j) {
    const Rotation R = ~R_GJ * R_GI;
    const Real angle = sense == Sense::ZAxes ? std::acos(std::clamp(R.z()[2], -1., 1.))
                                             : std::abs(R.convertRotationToAngleAxis()[0]);
    if (sense == Sense::None || angle <= SimTK::Pi / 2) return "";
    return fmt::format(
        "the {} of I={} and J={} are {:.4g} degrees apart and would assemble flipped; turn one of "
        "the markers so that they point the same way",
        sense == Sense::ZAxes ? "z axes" : "axes", i, j, angle * SimTK_RADIAN_TO_DEGREE);
}

Primitive makePrimitive(JprimType type, const Marker& I, const Marker& J, const std::string& name) {
    switch (type) {
        case JprimType::AtPoint:
            return AtPoint(I, J, name);
        case JprimType::InLine:
            return InLine(I, J, name);
        case JprimType::InPlane:
            return InPlane(I, J, name);
        case JprimType::Orientation:
            return Orientation(I, J, name);
        case JprimType::ParallelAxes:
            return ParallelAxes(I, J, name);
        case JprimType::Perpendicular:
            break;
    }
    return Perpendicular(I, J, name);
}

}  // namespace

std::string findFlip(JprimType type, const Rotation& R_GI, const Rotation& R_GJ, int i, int j) {
    return findFlip(getSense(type), R_GI, R_GJ, i, j);
}

std::string findFlip(JointType type, const Rotation& R_GI, const Rotation& R_GJ, int i, int j) {
    return findFlip(getSense(type), R_GI, R_GJ, i, j);
}

Joint makeConnection(JprimType type, const Marker& I, const Marker& J, const std::string& name) {
    return Joint(makePrimitive(type, I, J, name));
}

Joint makeConnection(JointType type, const Marker& I, const Marker& J, const std::string& name) {
    switch (type) {
        case JointType::Spherical:
            return Joint::Spherical(I, J, name);
        case JointType::Revolute:
            return Joint::Revolute(I, J, name);
        case JointType::Cylindrical:
            return Joint::Cylindrical(I, J, name);
        case JointType::Translational:
            return Joint::Translational(I, J, name);
        case JointType::Planar:
            return Joint::Planar(I, J, name);
        case JointType::Fixed:
            return Joint::Fixed(I, J, name);
        case JointType::Universal:
            return Joint::Universal(I, J, name);
        case JointType::Hooke:
            break;
    }
    return Joint::Hooke(I, J, name);
}

}  // namespace jprim
