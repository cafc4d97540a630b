// SPDX-License-Identifier: Apache-2.0
#include "jprim/joint/motion.h"

#include "general/general_constraint_impl.h"
#include "marker/marker_frames.h"
#include "marker/require_on_body.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;

namespace {

// With R = R_JI: B1 = atan2(-R12, R22), B2 = atan2(R02, |(R00, R01)|), B3 = atan2(-R01, R00).
Operand composeAngle(MarkerFrames& f, Coordinate coordinate) {
    ProgramBuilder& b = f.updBuilder();
    const auto R = [&f](int row, int column) { return f.element(PairI, PairJ, row, column); };
    if (coordinate == Coordinate::Rotation) return b.atan2(R(1, 0), R(0, 0));
    if (coordinate == Coordinate::B1) return b.atan2(b.negate(R(1, 2)), R(2, 2));
    if (coordinate == Coordinate::B3) return b.atan2(b.negate(R(0, 1)), R(0, 0));
    return b.atan2(R(0, 2), b.norm(b.vector(R(0, 0), R(0, 1), b.number(0))));
}

}  // namespace

Dimension getDimension(Coordinate coordinate) {
    return coordinate <= Coordinate::Z ? Dimension::Length : Dimension::Angle;
}

Expression makeCoordinate(const Marker& I, const Marker& J, Coordinate coordinate, bool countTurns) {
    return composeExpression(I, J, [&](MarkerFrames& f) {
        if (getDimension(coordinate) == Dimension::Length)
            return f.along(f.position(PairI, PairJ), PairJ, int(coordinate));
        const bool counted = countTurns && coordinate == Coordinate::Rotation;
        return counted ? f.angleAboutZ(PairI, PairJ) : composeAngle(f, coordinate);
    });
}

namespace {

Expression makeMotionCoordinate(const Marker& I, const Marker& J, Coordinate coordinate,
                                const std::string& name) {
    requireTwoBodies(I, J, describeGeneral(DrivenCoordinate, name));
    return makeCoordinate(I, J, coordinate);
}

}  // namespace

PrescribedMotion::PrescribedMotion(const Marker& I, const Marker& J, Coordinate coordinate,
                                   const Expression& function, KinematicLevel level, const std::string& name)
    : TypedHandle(DrivenCoordinate, makeMotionCoordinate(I, J, coordinate, name), function, level,
                  getDimension(coordinate) == Dimension::Length ? Real(0) : 2 * SimTK::Pi, name) {}

bool PrescribedMotion::isInstanceOf(const SimTK::Constraint& constraint) {
    return isOfType(constraint, DrivenCoordinate);
}

SpatialVec PrescribedMotion::calcReactionOnI(const State& state) const {
    return calcReactionOn(state, PairI);
}

SpatialVec PrescribedMotion::calcReactionOnJ(const State& state) const {
    return calcReactionOn(state, PairJ);
}

}  // namespace jprim
