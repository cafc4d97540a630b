// SPDX-License-Identifier: Apache-2.0
#include "jprim/primitive/primitive.h"

#include <fmt/format.h>

#include "jprim/base/error.h"
#include "jprim/marker/load.h"
#include "primitive/primitive_impl.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

Primitive::Primitive(PrimitiveImpl* implementation) : Custom(implementation) {}

const PrimitiveImpl& Primitive::getImpl() const {
    return static_cast<const PrimitiveImpl&>(getImplementation());
}

PrimitiveImpl& Primitive::updImpl() {
    return static_cast<PrimitiveImpl&>(updImplementation());
}

const std::string& Primitive::getName() const {
    return getImpl().getName();
}

Primitive& Primitive::setName(const std::string& name) {
    updImpl().setName(name);
    return *this;
}

const char* Primitive::getAdamsType() const {
    return getImpl().getAdamsType();
}

bool Primitive::isTranslational() const {
    return getImpl().isTranslational();
}

int Primitive::getNumEquations() const {
    return getImpl().getNumEquations();
}

std::string Primitive::describeEquation(int k) const {
    if (k < 0 || k >= getNumEquations())
        throw Error(getImpl().getDescription(),
                    fmt::format("has no equation {}; use 0 to {}", k, getNumEquations() - 1));
    return getImpl().describeEquation(k);
}

//---------------------------------------------------------------------------------------- markers
Marker Primitive::getDefaultMarkerI() const {
    return getImpl().getMarkerI(getImpl().getDefaultPlacements().I);
}

Marker Primitive::getDefaultMarkerJ() const {
    return getImpl().getMarkerJ(getImpl().getDefaultPlacements().J);
}

Primitive& Primitive::setDefaultMarkerI(const Transform& X) {
    updImpl().setDefaultPlacements({X, getImpl().getDefaultPlacements().J, {}});
    return *this;
}

Primitive& Primitive::setDefaultMarkerJ(const Transform& X) {
    updImpl().setDefaultPlacements({getImpl().getDefaultPlacements().I, X, {}});
    return *this;
}

Marker Primitive::getMarkerI(const State& state) const {
    return getImpl().getMarkerI(getImpl().getPlacements(state).I);
}

Marker Primitive::getMarkerJ(const State& state) const {
    return getImpl().getMarkerJ(getImpl().getPlacements(state).J);
}

void Primitive::setMarkerI(State& state, const Transform& X) const {
    getImpl().updPlacements(state).I = X;
}

void Primitive::setMarkerJ(State& state, const Transform& X) const {
    getImpl().updPlacements(state).J = X;
}

//---------------------------------------------------------------------------------- single equations
void Primitive::dropEquation(State& state, int k) const {
    describeEquation(k);  // throws if there is none
    getImpl().updPlacements(state).isDropped[size_t(k)] = true;
}

void Primitive::restoreEquation(State& state, int k) const {
    describeEquation(k);
    getImpl().updPlacements(state).isDropped[size_t(k)] = false;
}

bool Primitive::isEquationDropped(const State& state, int k) const {
    describeEquation(k);
    return getImpl().getPlacements(state).isDropped[size_t(k)];
}

Real Primitive::calcEquationError(const State& state, int k) const {
    describeEquation(k);
    const MarkerPair pair(getMarkerI(state).findPoseInGround(state),
                          getMarkerJ(state).findPoseInGround(state));
    PrimitiveImpl::Errors errors(0);
    getImpl().calcErrors(pair, errors);
    return errors[k];
}

//-------------------------------------------------------------------------------------- reactions
namespace {

const SpatialVec NoLoad(Vec3(0), Vec3(0));

MarkerPair findPairInGround(const Primitive& primitive, const State& state) {
    return MarkerPair(primitive.getMarkerI(state).findPoseInGround(state),
                      primitive.getMarkerJ(state).findPoseInGround(state));
}

}  // namespace

SpatialVec Primitive::calcReactionOnI(const State& state) const {
    if (isDisabled(state)) return NoLoad;
    const MarkerPair pair = findPairInGround(*this, state);
    return pair.calcLoadOnI(getImpl().calcLoadOnI(state, pair));
}

SpatialVec Primitive::calcReactionOnJ(const State& state) const {
    if (isDisabled(state)) return NoLoad;
    const MarkerPair pair = findPairInGround(*this, state);
    return pair.calcLoadOnJ(getImpl().calcLoadOnI(state, pair));
}

SpatialVec Primitive::calcReactionOnJAtI(const State& state) const {
    return -calcReactionOnI(state);
}

SpatialVec Primitive::calcReactionOnI(const State& state, const Marker& axes) const {
    return expressLoadIn(state, calcReactionOnI(state), axes);
}

SpatialVec Primitive::calcReactionOnJ(const State& state, const Marker& axes) const {
    return expressLoadIn(state, calcReactionOnJ(state), axes);
}

SpatialVec Primitive::calcReactionOnJAtI(const State& state, const Marker& axes) const {
    return expressLoadIn(state, calcReactionOnJAtI(state), axes);
}

Real Primitive::JPRIM(const State& state, int jflag, int comp) const {
    return getReactionComponent(calcReactionOnI(state), calcReactionOnJ(state), jflag, comp,
                                getImpl().getDescription());
}

Real Primitive::JPRIM(const State& state, int jflag, int comp, const Marker& rm) const {
    return getReactionComponent(calcReactionOnI(state, rm), calcReactionOnJ(state, rm), jflag, comp,
                                getImpl().getDescription());
}

}  // namespace jprim
