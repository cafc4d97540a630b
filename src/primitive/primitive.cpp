// SPDX-License-Identifier: Apache-2.0
#include "jprim/primitive/primitive.h"

#include "jprim/marker/load.h"
#include "primitive/pair_equations.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;

Primitive::Primitive(const char* adamsType, const PairEquations& equations, const Marker& I, const Marker& J,
                     const std::string& name)
    : PairConstraint(adamsType, {&equations}, I, J, name) {}

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
