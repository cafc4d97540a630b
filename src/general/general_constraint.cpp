// SPDX-License-Identifier: Apache-2.0
#include "jprim/general/general_constraint.h"

#include <fmt/format.h>

#include <cmath>

#include "general/check_expression.h"
#include "general/general_constraint_impl.h"
#include "jprim/base/error.h"
#include "jprim/marker/load.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;

namespace {

GeneralConstraintImpl* makeDriven(const Expression& coordinate, const Expression& function, int derivative,
                                  Real period, const std::string& name) {
    for (const std::string& problem : {findFunctionProblem(function.getImplementation()),
                                       function.getImplementation().findDerivativeProblem(2 - derivative)})
        if (!problem.empty()) throw Error(name, problem);
    if (coordinate.getImplementation().program.getLevel() != InputLevel::Position)
        throw Error(name, "a coordinate that follows a function must depend on positions only");
    return new GeneralConstraintImpl(coordinate, &function, derivative, period, name);
}

}  // namespace

GeneralConstraint::GeneralConstraint(GeneralConstraintImpl* implementation) : Custom(implementation) {}

GeneralConstraint::GeneralConstraint(const Expression& f, const std::string& name)
    : GeneralConstraint(new GeneralConstraintImpl(f, nullptr, 0, 0, name)) {}

GeneralConstraint::GeneralConstraint(const Expression& coordinate, const Expression& function, int derivative,
                                     Real period, const std::string& name)
    : GeneralConstraint(makeDriven(coordinate, function, derivative, period, name)) {}

const GeneralConstraintImpl& GeneralConstraint::getImpl() const {
    return static_cast<const GeneralConstraintImpl&>(getImplementation());
}

GeneralConstraintImpl& GeneralConstraint::updImpl() {
    return static_cast<GeneralConstraintImpl&>(updImplementation());
}

const std::string& GeneralConstraint::getName() const {
    return getImpl().getName();
}

bool GeneralConstraint::isHolonomic() const {
    return getImpl().isHolonomic();
}

GeneralConstraint& GeneralConstraint::setDefaultScale(Real scale) {
    updImpl().setScale(scale);
    return *this;
}

void GeneralConstraint::setEquationScale(State& state, Real scale) const {
    if (!(scale >= 0 && std::isfinite(scale)))
        throw Error(getName(), fmt::format("{} is no scale of an equation; use a positive number", scale));
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

std::string GeneralConstraint::findProblem(const State& state) const {
    return getImpl().findProblem(state);
}

}  // namespace jprim
