// SPDX-License-Identifier: Apache-2.0
#include "jprim/joint/joint.h"

#include <fmt/format.h>

#include <algorithm>

#include "jprim/base/error.h"
#include "jprim/marker/load.h"
#include "marker/marker_frames.h"

namespace jprim {

using SimTK::CoordinateAxis;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

constexpr const char* HookeType = "HOOKE";

// The marker turned so that its new z axis is one of its old axes.
Marker turnZTo(const Marker& marker, const CoordinateAxis& axis) {
    const Transform& X_BM = marker.getPose();
    const Rotation R_BT(X_BM.R().getAxisUnitVec(axis), SimTK::ZAxis);
    return marker.withPose(Transform(R_BT, X_BM.p()));
}

}  // namespace

Joint::Joint(const char* adamsType, const std::string& name, std::vector<Primitive> primitives,
             std::vector<GeneralConstraint> equations)
    : m_adamsType(adamsType),
      m_name(name),
      m_primitives(std::move(primitives)),
      m_equations(std::move(equations)) {}

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
        HookeType, name,
        {AtPoint(I, J, name), Perpendicular(turnZTo(I, SimTK::XAxis), turnZTo(J, SimTK::YAxis), name)});
}

// With R_JI = Rz(a) Rx(b) Rz(c) the difference is (1 + cos b) sin(a + c), the sum (1 - cos b) sin(a - c).
Joint Joint::Convel(const Marker& I, const Marker& J, bool opposed, const std::string& name) {
    const Expression equation = composeExpression(I, J, [opposed](MarkerFrames& f) {
        const Operand a = f.element(PairI, PairJ, 1, 0), b = f.element(PairI, PairJ, 0, 1);
        return opposed ? f.updBuilder().add(a, b) : f.updBuilder().subtract(a, b);
    });
    return Joint("CONVEL", name, {AtPoint(I, J, name)}, {GeneralConstraint(equation, name)});
}

namespace {

// Travel of I along z_J = factor * angle + offset.
GeneralConstraint makeRolling(const Marker& I, const Marker& J,
                              const std::function<Operand(MarkerFrames&)>& angle, Real factor, Real offset,
                              const std::string& name) {
    const Expression equation = composeExpression(I, J, [&](MarkerFrames& f) {
        ProgramBuilder& b = f.updBuilder();
        const Operand travel = f.along(f.position(PairI, PairJ), PairJ, 2);
        const Operand rolled = b.multiply(b.number(factor), angle(f));
        return b.subtract(b.subtract(travel, rolled), b.number(offset));
    });
    return GeneralConstraint(equation, name);
}

}  // namespace

Joint Joint::Screw(const Marker& I, const Marker& J, Real pitch, Real offset, const std::string& name) {
    const auto angle = [](MarkerFrames& f) { return f.angleAboutZ(PairI, PairJ); };
    return Joint("SCREW", name, {}, {makeRolling(I, J, angle, pitch / (2 * SimTK::Pi), offset, name)});
}

// Seen from I, which turns, z_J turns the other way.
Joint Joint::Rackpin(const Marker& I, const Marker& J, Real diameter, Real offset, const std::string& name) {
    const auto angle = [](MarkerFrames& f) {
        ProgramBuilder& b = f.updBuilder();
        return b.negate(b.continuousAngle(f.element(PairI, PairJ, 2, 1), f.element(PairI, PairJ, 2, 0)));
    };
    return Joint("RACKPIN", name, {}, {makeRolling(I, J, angle, diameter / 2, offset, name)});
}

std::vector<SimTK::Constraint> Joint::getConstraints() const {
    std::vector<SimTK::Constraint> constraints(m_primitives.begin(), m_primitives.end());
    constraints.insert(constraints.end(), m_equations.begin(), m_equations.end());
    return constraints;
}

// The markers of HOOKE's PERPENDICULAR are turned; its words are about the joint's own.
std::string Joint::describeEquation(int p, int k) const {
    if (p < 0 || p >= int(m_primitives.size()))
        throw Error(getDescription(),
                    fmt::format("has no primitive {}; use 0 to {}", p, m_primitives.size() - 1));
    const bool isTurned = m_adamsType == HookeType && !m_primitives[p].isTranslational();
    const std::string words = m_primitives[p].describeEquation(k);
    return isTurned ? "rotation between Xi and Yj" : words;
}

void Joint::disable(State& state) const {
    for (const SimTK::Constraint& constraint : getConstraints()) constraint.disable(state);
}

void Joint::enable(State& state) const {
    for (const SimTK::Constraint& constraint : getConstraints()) constraint.enable(state);
}

bool Joint::isDisabled(const State& state) const {
    const std::vector<SimTK::Constraint> constraints = getConstraints();
    return std::all_of(constraints.begin(), constraints.end(), [&state](const SimTK::Constraint& constraint) {
        return constraint.isDisabled(state);
    });
}

//-------------------------------------------------------------------------------------- reactions
SpatialVec Joint::calcReactionOnI(const State& state) const {
    SpatialVec sum(Vec3(0), Vec3(0));
    for (const Primitive& primitive : m_primitives) sum += primitive.calcReactionOnI(state);
    for (const GeneralConstraint& equation : m_equations) sum += equation.calcReactionOn(state, PairI);
    return sum;
}

SpatialVec Joint::calcReactionOnJ(const State& state) const {
    SpatialVec sum(Vec3(0), Vec3(0));
    for (const Primitive& primitive : m_primitives) sum += primitive.calcReactionOnJ(state);
    for (const GeneralConstraint& equation : m_equations) sum += equation.calcReactionOn(state, PairJ);
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
