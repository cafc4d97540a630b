// SPDX-License-Identifier: Apache-2.0
#include "jprim/joint/joint.h"

#include <algorithm>

#include "jprim/marker/load.h"

namespace jprim {

using SimTK::CoordinateAxis;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

// The marker turned so that its new z axis is one of its old axes.
Marker turnZTo(const Marker& marker, const CoordinateAxis& axis) {
    const Transform& X_BM = marker.getPose();
    const Rotation R_BT(X_BM.R().getAxisUnitVec(axis), SimTK::ZAxis);
    return marker.withPose(Transform(R_BT, X_BM.p()));
}

}  // namespace

Joint::Joint(const char* adamsType, const std::string& name, std::vector<Primitive> primitives)
    : m_adamsType(adamsType), m_name(name), m_primitives(std::move(primitives)) {}

Joint::Joint(const Primitive& primitive)
    : Joint(primitive.getAdamsType(), primitive.getName(), {primitive}) {}

std::string Joint::getDescription() const {
    return m_name.empty() ? m_adamsType : m_name + " " + m_adamsType;
}

Joint Joint::Spherical(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("SPHERICAL", name, {AtPoint(I, J, name)});
}

Joint Joint::Revolute(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("REVOLUTE", name, {AtPoint(I, J, name), ParallelAxes(I, J, name)});
}

Joint Joint::Cylindrical(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("CYLINDRICAL", name, {InLine(I, J, name), ParallelAxes(I, J, name)});
}

Joint Joint::Translational(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("TRANSLATIONAL", name, {InLine(I, J, name), Orientation(I, J, name)});
}

Joint Joint::Planar(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("PLANAR", name, {InPlane(I, J, name), ParallelAxes(I, J, name)});
}

Joint Joint::Fixed(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("FIXED", name, {AtPoint(I, J, name), Orientation(I, J, name)});
}

Joint Joint::Universal(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("UNIVERSAL", name, {AtPoint(I, J, name), Perpendicular(I, J, name)});
}

Joint Joint::Hooke(const Marker& I, const Marker& J, const std::string& name) {
    return Joint(
        "HOOKE", name,
        {AtPoint(I, J, name), Perpendicular(turnZTo(I, SimTK::XAxis), turnZTo(J, SimTK::YAxis), name)});
}

void Joint::disable(State& state) const {
    for (const Primitive& primitive : m_primitives) primitive.disable(state);
}

void Joint::enable(State& state) const {
    for (const Primitive& primitive : m_primitives) primitive.enable(state);
}

bool Joint::isDisabled(const State& state) const {
    return std::all_of(m_primitives.begin(), m_primitives.end(),
                       [&state](const Primitive& primitive) { return primitive.isDisabled(state); });
}

//-------------------------------------------------------------------------------------- reactions
SpatialVec Joint::calcReactionOnI(const State& state) const {
    SpatialVec sum(Vec3(0), Vec3(0));
    for (const Primitive& primitive : m_primitives) sum += primitive.calcReactionOnI(state);
    return sum;
}

SpatialVec Joint::calcReactionOnJ(const State& state) const {
    SpatialVec sum(Vec3(0), Vec3(0));
    for (const Primitive& primitive : m_primitives) sum += primitive.calcReactionOnJ(state);
    return sum;
}

SpatialVec Joint::calcReactionOnJAtI(const State& state) const {
    return -calcReactionOnI(state);
}

SpatialVec Joint::calcReactionOnI(const State& state, const Marker& axes) const {
    return expressLoadIn(state, calcReactionOnI(state), axes);
}

SpatialVec Joint::calcReactionOnJ(const State& state, const Marker& axes) const {
    return expressLoadIn(state, calcReactionOnJ(state), axes);
}

SpatialVec Joint::calcReactionOnJAtI(const State& state, const Marker& axes) const {
    return expressLoadIn(state, calcReactionOnJAtI(state), axes);
}

Real Joint::JOINT(const State& state, int jflag, int comp) const {
    return getReactionComponent(calcReactionOnI(state), calcReactionOnJ(state), jflag, comp,
                                getDescription());
}

Real Joint::JOINT(const State& state, int jflag, int comp, const Marker& rm) const {
    return getReactionComponent(calcReactionOnI(state, rm), calcReactionOnJ(state, rm), jflag, comp,
                                getDescription());
}

}  // namespace jprim
