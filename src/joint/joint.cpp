// SPDX-License-Identifier: Apache-2.0
#include "jprim/joint/joint.h"

#include "jprim/marker/load.h"
#include "marker/marker_frames.h"
#include "primitive/pair_equations.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;

Joint::Joint(const char* adamsType, const Parts& parts, const Marker& I, const Marker& J,
             const std::string& name)
    : m_adamsType(adamsType), m_constraint(PairConstraint(adamsType, parts, I, J, name)) {}

Joint::Joint(const char* adamsType, const GeneralConstraint& constraint)
    : m_adamsType(adamsType), m_constraint(constraint) {}

Joint::Joint(const Primitive& primitive) : m_adamsType(primitive.getAdamsType()), m_constraint(primitive) {}

const std::string& Joint::getName() const {
    return std::visit([](const auto& constraint) -> const std::string& { return constraint.getName(); },
                      m_constraint);
}

std::string Joint::getDescription() const {
    return getName().empty() ? m_adamsType : getName() + " " + m_adamsType;
}

Joint Joint::Spherical(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("SPHERICAL", {&getAtPointEquations()}, I, J, name);
}

Joint Joint::Revolute(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("REVOLUTE", {&getAtPointEquations(), &getParallelAxesEquations()}, I, J, name);
}

Joint Joint::Cylindrical(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("CYLINDRICAL", {&getInLineEquations(), &getParallelAxesEquations()}, I, J, name);
}

Joint Joint::Translational(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("TRANSLATIONAL", {&getInLineEquations(), &getOrientationEquations()}, I, J, name);
}

Joint Joint::Planar(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("PLANAR", {&getInPlaneEquations(), &getParallelAxesEquations()}, I, J, name);
}

Joint Joint::Fixed(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("FIXED", {&getAtPointEquations(), &getOrientationEquations()}, I, J, name);
}

Joint Joint::Universal(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("UNIVERSAL", {&getAtPointEquations(), &getPerpendicularEquations()}, I, J, name);
}

Joint Joint::Hooke(const Marker& I, const Marker& J, const std::string& name) {
    return Joint("HOOKE", {&getAtPointEquations(), &getCrossedBarsEquations()}, I, J, name);
}

Joint Joint::Convel(const Marker& I, const Marker& J, bool opposed, const std::string& name) {
    return Joint("CONVEL", {&getAtPointEquations(), &getConstantVelocityEquations(opposed)}, I, J, name);
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
    return Joint("SCREW", makeRolling(I, J, angle, pitch / (2 * SimTK::Pi), offset, name));
}

// Seen from I, which turns, z_J turns the other way.
Joint Joint::Rackpin(const Marker& I, const Marker& J, Real diameter, Real offset, const std::string& name) {
    const auto angle = [](MarkerFrames& f) {
        ProgramBuilder& b = f.updBuilder();
        return b.continuousAngle(b.negate(f.element(PairI, PairJ, 2, 1)), f.element(PairI, PairJ, 2, 0));
    };
    return Joint("RACKPIN", makeRolling(I, J, angle, diameter / 2, offset, name));
}

const SimTK::Constraint& Joint::getConstraint() const {
    return std::visit([](const auto& constraint) -> const SimTK::Constraint& { return constraint; },
                      m_constraint);
}

SimTK::Vector Joint::getTurns(const State& state) const {
    const GeneralConstraint* rolling = getGeneralConstraint();
    return rolling ? rolling->getTurns(state) : SimTK::Vector();
}

//-------------------------------------------------------------------------------------- reactions
SpatialVec Joint::calcReactionOnI(const State& state) const {
    if (const GeneralConstraint* rolling = getGeneralConstraint())
        return rolling->calcReactionOn(state, PairI);
    return getPairConstraint()->calcReactionOnI(state);
}

SpatialVec Joint::calcReactionOnJ(const State& state) const {
    if (const GeneralConstraint* rolling = getGeneralConstraint())
        return rolling->calcReactionOn(state, PairJ);
    return getPairConstraint()->calcReactionOnJ(state);
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
