// SPDX-License-Identifier: Apache-2.0
#include "jprim/primitive/primitive.h"

#include <cstring>

#include "jprim/marker/load.h"
#include "jprim/primitive/primitives.h"
#include "primitive/pair_equations.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;

Primitive::Primitive(const char* adamsType, const PairEquations& equations, const Marker& I, const Marker& J,
                     const std::string& name)
    : TypedHandle(adamsType, std::vector<const PairEquations*>{&equations}, I, J, name) {}

bool Primitive::isOfType(const SimTK::Constraint& constraint, const char* adamsType) {
    return PairConstraint::isInstanceOf(constraint) &&
           std::strcmp(PairConstraint::downcast(constraint).getAdamsType(), adamsType) == 0;
}

bool Primitive::isInstanceOf(const SimTK::Constraint& constraint) {
    return AtPoint::isInstanceOf(constraint) || InLine::isInstanceOf(constraint) ||
           InPlane::isInstanceOf(constraint) || Orientation::isInstanceOf(constraint) ||
           ParallelAxes::isInstanceOf(constraint) || Perpendicular::isInstanceOf(constraint);
}

Primitive& Primitive::setName(const std::string& name) {
    PairConstraint::setName(name);
    return *this;
}

Primitive& Primitive::setDefaultMarkerI(const SimTK::Transform& X) {
    PairConstraint::setDefaultMarkerI(X);
    return *this;
}

Primitive& Primitive::setDefaultMarkerJ(const SimTK::Transform& X) {
    PairConstraint::setDefaultMarkerJ(X);
    return *this;
}

Real Primitive::JPRIM(const State& state, int jflag, int comp) const {
    return getReactionComponent(calcReactionOnI(state), calcReactionOnJ(state), jflag, comp,
                                getDescription());
}

Real Primitive::JPRIM(const State& state, int jflag, int comp, const Marker& rm) const {
    return getReactionComponent(calcReactionOnI(state, rm), calcReactionOnJ(state, rm), jflag, comp,
                                getDescription());
}

}  // namespace jprim
