// SPDX-License-Identifier: Apache-2.0
#include "jprim/force/expression_measure.h"

#include "jprim/base/error.h"
#include "marker/find_implementation.h"
#include "marker/require_on_body.h"
#include "marker/tracked_expression.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;
using SimTK::Vector_;

class ExpressionMeasureImpl : public SimTK::Force::Custom::Implementation {
public:
    ExpressionMeasureImpl(SimTK::GeneralForceSubsystem& forces, const Expression& expression)
        : m_forces(checkSystem(forces, expression).getSubsystemGuts()), m_expression(expression) {}

    Real calcValue(const State& state) const { return m_expression.calcValue(state); }
    const AngleMemory& getAngles() const { return m_expression.getAngles(); }

private:
    static const SimTK::GeneralForceSubsystem& checkSystem(const SimTK::GeneralForceSubsystem& forces,
                                                           const Expression& expression) {
        const char* element = "expression";
        if (expression.getImplementation().program.isVector())
            throw Error(element, "it is a vector where a number is needed");
        requireInSystem(expression, findSystem(forces, element), element);
        return forces;
    }
    void realizeTopology(State& state) const override { m_expression.allocate(findHandle(m_forces), state); }
    void calcForce(const State&, Vector_<SpatialVec>&, Vector_<Vec3>&, Vector&) const override {}
    Real calcPotentialEnergy(const State&) const override { return 0; }

    const SimTK::Subsystem::Guts& m_forces;  // the caller's handle of it may go away
    mutable TrackedExpression m_expression;  // mutable: its topology cache
};

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
