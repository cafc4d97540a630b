// SPDX-License-Identifier: Apache-2.0
#include "jprim/general/general_constraint.h"

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

void GeneralConstraint::dropEquation(State& state) const {
    getImpl().setDropped(state, true);
}

void GeneralConstraint::restoreEquation(State& state) const {
    getImpl().setDropped(state, false);
}

bool GeneralConstraint::isEquationDropped(const State& state) const {
    return getImpl().isDropped(state);
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
