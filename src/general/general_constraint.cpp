// SPDX-License-Identifier: Apache-2.0
#include "jprim/general/general_constraint.h"

#include <cmath>
#include <cstring>

#include "base/format.h"
#include "general/check_expression.h"
#include "general/general_constraint_impl.h"
#include "jprim/base/error.h"
#include "jprim/marker/load.h"
#include "marker/find_implementation.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;

namespace {

GeneralConstraintImpl* makeEquation(const char* adamsType, const Expression& f, const std::string& name) {
    return new GeneralConstraintImpl(adamsType, f, nullptr, KinematicLevel::Position, 0, name);
}

GeneralConstraintImpl* makeDriven(const char* adamsType, const Expression& coordinate,
                                  const Expression& function, KinematicLevel level, Real period,
                                  const std::string& name) {
    const std::string element = describeGeneral(adamsType, name);
    const std::string problem = findFunctionProblem(function.getImplementation());
    if (!problem.empty()) throw Error(element, problem);
    if (coordinate.getImplementation().program.getLevel() != KinematicLevel::Position)
        throw Error(element, "a coordinate that follows a function must depend on positions only");
    if (level < KinematicLevel::Position || level > KinematicLevel::Acceleration)
        throw Error(element, fmt::format("derivative {} of a coordinate cannot be prescribed; use 0 for the "
                                         "coordinate itself, 1 for its rate or 2 for its acceleration",
                                         int(level)));
    const std::string lacking = function.getImplementation().findDerivativeProblem(2 - int(level));
    if (!lacking.empty()) throw Error(element, lacking);
    if (!(period >= 0) || !std::isfinite(period))
        throw Error(element, fmt::format("its period is {}; it must be positive, or 0 for none", period));
    return new GeneralConstraintImpl(adamsType, coordinate, &function, level, period, name);
}

}  // namespace

GeneralConstraint::GeneralConstraint(GeneralConstraintImpl* implementation) : TypedHandle(implementation) {}

GeneralConstraint::GeneralConstraint(const char* adamsType, const Expression& f, const std::string& name)
    : GeneralConstraint(makeEquation(adamsType, f, name)) {}

GeneralConstraint::GeneralConstraint(const char* adamsType, const Expression& coordinate,
                                     const Expression& function, KinematicLevel level, Real period,
                                     const std::string& name)
    : GeneralConstraint(makeDriven(adamsType, coordinate, function, level, period, name)) {}

GeneralConstraint::GeneralConstraint(const Expression& f, const std::string& name)
    : GeneralConstraint(Gcon, f, name) {}

GeneralConstraint::GeneralConstraint(const Expression& coordinate, const Expression& function,
                                     KinematicLevel level, Real period, const std::string& name)
    : GeneralConstraint(Gcon, coordinate, function, level, period, name) {}

bool GeneralConstraint::isInstanceOf(const SimTK::Constraint& constraint) {
    return findImplementation<GeneralConstraintImpl>(constraint) != nullptr;
}

bool GeneralConstraint::isOfType(const SimTK::Constraint& constraint, const char* adamsType) {
    return isInstanceOf(constraint) && std::strcmp(downcast(constraint).getAdamsType(), adamsType) == 0;
}

const GeneralConstraintImpl& GeneralConstraint::getImpl() const {
    return static_cast<const GeneralConstraintImpl&>(getImplementation());
}

GeneralConstraintImpl& GeneralConstraint::updImpl() {
    return static_cast<GeneralConstraintImpl&>(updImplementation());
}

const std::string& GeneralConstraint::getName() const {
    return getImpl().getName();
}

const char* GeneralConstraint::getAdamsType() const {
    return getImpl().getAdamsType();
}

std::string GeneralConstraint::getDescription() const {
    return getImpl().getDescription();
}

bool GeneralConstraint::isHolonomic() const {
    return getImpl().isHolonomic();
}

GeneralConstraint& GeneralConstraint::setDefaultScale(Real scale) {
    if (scale == 0 || !std::isfinite(scale))
        throw Error(getDescription(),
                    fmt::format("its scale is {}; it must be a finite number other than 0", scale));
    updImpl().setScale(scale);
    return *this;
}

void GeneralConstraint::setEquationScale(State& state, Real scale) const {
    if (!(scale >= 0 && std::isfinite(scale)))
        throw Error(getDescription(),
                    fmt::format("{} is no scale of an equation; use a positive number", scale));
    getImpl().setStateScale(state, scale);
}

Real GeneralConstraint::getEquationScale(const State& state) const {
    return getImpl().getStateScale(state);
}

void GeneralConstraint::dropEquation(State& state) const {
    setEquationScale(state, 0);
}

void GeneralConstraint::restoreEquation(State& state) const {
    setEquationScale(state, 1);
}

bool GeneralConstraint::isEquationDropped(const State& state) const {
    return getEquationScale(state) == 0;
}

Real GeneralConstraint::calcEquationError(const State& state) const {
    return getImpl().calcEquationError(state);
}

Vector GeneralConstraint::getTurns(const State& state) const {
    return getImpl().getTurns(state);
}

void GeneralConstraint::setTurns(State& state, const Vector& turns) const {
    getImpl().setTurns(state, turns);
}

void GeneralConstraint::resetTurns(State& state) const {
    setTurns(state, Vector(getImpl().getNumAngles(), Real(0)));
}

SpatialVec GeneralConstraint::calcReactionOn(const State& state, int marker) const {
    if (isDisabled(state)) return SpatialVec(Vec3(0), Vec3(0));
    return getImpl().calcLoadOn(state, marker);
}

SpatialVec GeneralConstraint::calcReactionOn(const State& state, int marker, const Marker& axes) const {
    return expressLoadIn(state, calcReactionOn(state, marker), axes);
}

const Marker& GeneralConstraint::getMarker(int key) const {
    return getImpl().getMarker(key);
}

std::string GeneralConstraint::findProblem(const State& state) const {
    return getImpl().findProblem(state);
}

}  // namespace jprim
