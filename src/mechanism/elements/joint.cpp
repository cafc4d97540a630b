// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "jprim/marker/marker_pair.h"
#include "mechanism/elements/connection.h"
#include "mechanism/elements/elements.h"

namespace jprim {
namespace {

// A SCREW or RACKPIN keeps the travel and angle that the markers are given with: only what is added to them
// must go together. The z axes of a CONVEL, which may point down the two shafts or both the same way, say by
// their given directions which.
Joint makeJoint(const JointStatement& s, const std::string& name, const ElementContext& context) {
    const Marker &I = context.getMarker(s.i), &J = context.getMarker(s.j);
    const MarkerPair given(context.poses.getPose(s.i), context.poses.getPose(s.j));
    const SimTK::Rotation& R = given.getRotation();
    const double length = context.getUnits().length, travel = given.getPosition()[2];
    switch (s.type) {
        case JointType::Spherical: return Joint::Spherical(I, J, name);
        case JointType::Revolute: return Joint::Revolute(I, J, name);
        case JointType::Cylindrical: return Joint::Cylindrical(I, J, name);
        case JointType::Translational: return Joint::Translational(I, J, name);
        case JointType::Planar: return Joint::Planar(I, J, name);
        case JointType::Fixed: return Joint::Fixed(I, J, name);
        case JointType::Universal: return Joint::Universal(I, J, name);
        case JointType::Convel: return Joint::Convel(I, J, R[2][2] < 0, name);
        case JointType::Screw: {
            const double pitch = *s.pitch * length, angle = std::atan2(R[1][0], R[0][0]);
            return Joint::Screw(I, J, pitch, travel - pitch * angle / (2 * SimTK::Pi), name);
        }
        case JointType::Rackpin: {
            const double diameter = *s.diameter * length, angle = -std::atan2(R[2][1], R[2][0]);
            return Joint::Rackpin(I, J, diameter, travel - diameter / 2 * angle, name);
        }
        case JointType::Hooke: break;
    }
    return Joint::Hooke(I, J, name);
}

}  // namespace

Element makeElement(const JointStatement& s, const ElementContext& context) {
    const ElementId id{ElementKind::Joint, s.id};
    return makeConnection(
        id, getAdamsName(s.type), s.i, s.j, findLoopEquations(s.type),
        [&] { return makeJoint(s, id.getText(), context); }, context);
}

}  // namespace jprim
