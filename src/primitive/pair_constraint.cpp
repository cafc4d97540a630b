// SPDX-License-Identifier: Apache-2.0
#include "jprim/primitive/pair_constraint.h"

#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"
#include "jprim/marker/load.h"
#include "marker/find_implementation.h"
#include "marker/require_finite.h"
#include "primitive/pair_constraint_impl.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

const SpatialVec NoLoad(Vec3(0), Vec3(0));

MarkerPair findPairInGround(const PairConstraint& constraint, const State& state) {
    return MarkerPair(constraint.getMarkerI(state).findPoseInGround(state),
                      constraint.getMarkerJ(state).findPoseInGround(state));
}

}  // namespace

PairConstraint::PairConstraint(const char* adamsType, const std::vector<const PairEquations*>& equations,
                               const Marker& I, const Marker& J, const std::string& name)
    : TypedHandle(new PairConstraintImpl(adamsType, equations, I, J, name)) {}

bool PairConstraint::isInstanceOf(const SimTK::Constraint& constraint) {
    return findImplementation<PairConstraintImpl>(constraint) != nullptr;
}

const PairConstraintImpl& PairConstraint::getImpl() const {
    return static_cast<const PairConstraintImpl&>(getImplementation());
}

PairConstraintImpl& PairConstraint::updImpl() {
    return static_cast<PairConstraintImpl&>(updImplementation());
}

const std::string& PairConstraint::getName() const {
    return getImpl().getName();
}

PairConstraint& PairConstraint::setName(const std::string& name) {
    updImpl().setName(name);
    return *this;
}

const char* PairConstraint::getAdamsType() const {
    return getImpl().getAdamsType();
}

std::string PairConstraint::getDescription() const {
    return getImpl().getDescription();
}

int PairConstraint::getNumEquations() const {
    return getImpl().getNumEquations();
}

std::string PairConstraint::describeEquation(int k) const {
    if (k < 0 || k >= getNumEquations())
        throw Error(getDescription(),
                    fmt::format("has no equation {}; use 0 to {}", k, getNumEquations() - 1));
    return getImpl().describeEquation(k);
}

bool PairConstraint::isTranslational(int k) const {
    describeEquation(k);  // throws if there is none
    return getImpl().isTranslational(k);
}

//---------------------------------------------------------------------------------------- markers
Marker PairConstraint::getDefaultMarkerI() const {
    return getImpl().getMarkerI(getImpl().getDefaultPlacements().I);
}

Marker PairConstraint::getDefaultMarkerJ() const {
    return getImpl().getMarkerJ(getImpl().getDefaultPlacements().J);
}

PairConstraint& PairConstraint::setDefaultMarkerI(const Transform& X) {
    requireFinite(X, "marker I's", getDescription());
    updImpl().setDefaultPlacements({X, getImpl().getDefaultPlacements().J});
    return *this;
}

PairConstraint& PairConstraint::setDefaultMarkerJ(const Transform& X) {
    requireFinite(X, "marker J's", getDescription());
    updImpl().setDefaultPlacements({getImpl().getDefaultPlacements().I, X});
    return *this;
}

Marker PairConstraint::getMarkerI(const State& state) const {
    return getImpl().getMarkerI(getImpl().getPlacements(state).I);
}

Marker PairConstraint::getMarkerJ(const State& state) const {
    return getImpl().getMarkerJ(getImpl().getPlacements(state).J);
}

void PairConstraint::setMarkerI(State& state, const Transform& X) const {
    requireFinite(X, "marker I's", getDescription());
    getImpl().updPlacements(state).I = X;
}

void PairConstraint::setMarkerJ(State& state, const Transform& X) const {
    requireFinite(X, "marker J's", getDescription());
    getImpl().updPlacements(state).J = X;
}

//---------------------------------------------------------------------------------- single equations
void PairConstraint::setEquationScale(State& state, int k, Real scale) const {
    describeEquation(k);
    if (!(scale >= 0 && std::isfinite(scale)))
        throw Error(getDescription(),
                    fmt::format("{} is no scale of an equation; use a positive number", scale));
    getImpl().updPlacements(state).scales[size_t(k)] = scale;
}

Real PairConstraint::getEquationScale(const State& state, int k) const {
    describeEquation(k);
    return getImpl().getPlacements(state).scales[size_t(k)];
}

void PairConstraint::dropEquation(State& state, int k) const {
    setEquationScale(state, k, 0);
}

void PairConstraint::restoreEquation(State& state, int k) const {
    setEquationScale(state, k, 1);
}

bool PairConstraint::isEquationDropped(const State& state, int k) const {
    return getEquationScale(state, k) == 0;
}

Real PairConstraint::calcEquationError(const State& state, int k) const {
    describeEquation(k);
    PairConstraintImpl::Errors errors{};
    getImpl().calcErrors(findPairInGround(*this, state), errors);
    return errors[size_t(k)];
}

//-------------------------------------------------------------------------------------- reactions
SpatialVec PairConstraint::calcReactionOnI(const State& state) const {
    if (isDisabled(state)) return NoLoad;
    const MarkerPair pair = findPairInGround(*this, state);
    return pair.calcLoadOnI(getImpl().calcLoadOnI(state, pair));
}

SpatialVec PairConstraint::calcReactionOnJ(const State& state) const {
    if (isDisabled(state)) return NoLoad;
    const MarkerPair pair = findPairInGround(*this, state);
    return pair.calcLoadOnJ(getImpl().calcLoadOnI(state, pair));
}

SpatialVec PairConstraint::calcReactionOnJAtI(const State& state) const {
    return -calcReactionOnI(state);
}

SpatialVec PairConstraint::calcReactionOnI(const State& state, const Marker& axes) const {
    return expressLoadIn(state, calcReactionOnI(state), axes);
}

SpatialVec PairConstraint::calcReactionOnJ(const State& state, const Marker& axes) const {
    return expressLoadIn(state, calcReactionOnJ(state), axes);
}

SpatialVec PairConstraint::calcReactionOnJAtI(const State& state, const Marker& axes) const {
    return expressLoadIn(state, calcReactionOnJAtI(state), axes);
}

}  // namespace jprim
