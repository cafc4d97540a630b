// SPDX-License-Identifier: Apache-2.0
#include "jprim/force/expression_measure.h"

#include "force/expression_measure_impl.h"
#include "marker/find_implementation.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;
using SimTK::Vector;

ExpressionMeasure::ExpressionMeasure(SimTK::GeneralForceSubsystem& forces,
                                     ExpressionMeasureImpl* implementation)
    : TypedHandle(forces, implementation) {}

ExpressionMeasure::ExpressionMeasure(SimTK::GeneralForceSubsystem& forces, const Expression& expression)
    : ExpressionMeasure(forces, new ExpressionMeasureImpl(forces, expression)) {}

const ExpressionMeasureImpl& ExpressionMeasure::getImpl() const {
    return static_cast<const ExpressionMeasureImpl&>(getImplementation());
}

bool ExpressionMeasure::isInstanceOf(const SimTK::Force& force) {
    return findImplementation<ExpressionMeasureImpl>(force) != nullptr;
}

Real ExpressionMeasure::calcValue(const State& state) const {
    return getImpl().calcValue(state);
}

Vector ExpressionMeasure::getTurns(const State& state) const {
    return getImpl().getAngles().getTurns(state);
}

void ExpressionMeasure::setTurns(State& state, const Vector& turns) const {
    getImpl().getAngles().setTurns(state, turns, "expression");
}

void ExpressionMeasure::resetTurns(State& state) const {
    setTurns(state, Vector(getImpl().getAngles().getNumAngles(), Real(0)));
}

}  // namespace jprim
