// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/coordinates.h"

namespace jprim {

using SimTK::Real;

namespace {

Coordinate getCoordinate(MotionAxis axis, JointType jointType) {
    switch (axis) {
        case MotionAxis::Joint:
            return jointType == JointType::Translational ? Coordinate::Z : Coordinate::Rotation;
        case MotionAxis::Rotation: return Coordinate::Rotation;
        case MotionAxis::X: return Coordinate::X;
        case MotionAxis::Y: return Coordinate::Y;
        case MotionAxis::B1: return Coordinate::B1;
        case MotionAxis::B2: return Coordinate::B2;
        case MotionAxis::B3: return Coordinate::B3;
        case MotionAxis::Translation:
        case MotionAxis::Z: break;
    }
    return Coordinate::Z;
}

InitialCoordinate makeInitialCoordinate(const ElementId& id, const MotionCoordinate& of,
                                        const std::optional<double>& value, const std::optional<double>& rate,
                                        const ElementContext& context) {
    const UnitSystem& units = context.getUnits();
    const Real unit = units.getDisplacement(getDimension(of.coordinate));
    InitialCoordinate given{id,
                            makeCoordinate(context.getMarker(of.i), context.getMarker(of.j), of.coordinate),
                            getDimension(of.coordinate),
                            {},
                            {}};
    if (value) given.value = *value * unit;
    if (rate) given.rate = *rate * unit / units.time;
    return given;
}

}  // namespace

MotionCoordinate findMotionCoordinate(const MotionStatement& s, const ElementContext& context) {
    if (s.joint == 0) return {s.i, s.j, getCoordinate(s.axis, JointType::Revolute)};
    const JointStatement& joint = context.getJoint(s.joint);
    return {joint.i, joint.j, getCoordinate(s.axis, joint.type)};
}

std::vector<InitialCoordinate> makeInitialCoordinates(const ElementContext& context) {
    std::vector<InitialCoordinate> coordinates;
    for (const MotionStatement& s : context.dataset.motions)
        if (s.icdisp || s.icvel)
            coordinates.push_back(makeInitialCoordinate(
                {ElementKind::Motion, s.id}, findMotionCoordinate(s, context), s.icdisp, s.icvel, context));
    for (const JointStatement& s : context.dataset.joints) {
        const auto add = [&](const std::optional<JointInitialValue>& given, Coordinate coordinate) {
            if (given && (given->displacement || given->velocity))
                coordinates.push_back(makeInitialCoordinate({ElementKind::Joint, s.id},
                                                            {s.i, s.j, coordinate}, given->displacement,
                                                            given->velocity, context));
        };
        add(s.ic, s.type == JointType::Translational ? Coordinate::Z : Coordinate::Rotation);
        add(s.icTranslation, Coordinate::Z);
        add(s.icRotation, Coordinate::Rotation);
    }
    return coordinates;
}

}  // namespace jprim
