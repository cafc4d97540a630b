// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FORCE_EXPRESSION_MEASURE_IMPL_H_
#define JPRIM_SRC_FORCE_EXPRESSION_MEASURE_IMPL_H_

#include "jprim/base/error.h"
#include "jprim/force/expression_measure.h"
#include "marker/require_on_body.h"
#include "marker/tracked_expression.h"

namespace jprim {

class ExpressionMeasureImpl final : public SimTK::Force::Custom::Implementation {
public:
    ExpressionMeasureImpl(SimTK::GeneralForceSubsystem& forces, const Expression& expression)
        : m_forces(checkSystem(forces, expression).getSubsystemGuts()), m_expression(expression) {}

    SimTK::Real calcValue(const SimTK::State& state) const { return m_expression.calcValue(state); }
    const AngleMemory& getAngles() const { return m_expression.getAngles(); }
    const TrackedExpression& getExpression() const { return m_expression; }

private:
    static const SimTK::GeneralForceSubsystem& checkSystem(const SimTK::GeneralForceSubsystem& forces,
                                                           const Expression& expression) {
        const char* element = "expression";
        if (expression.getImplementation().program.isVector())
            throw Error(element, "it is a vector where a number is needed");
        requireInSystem(expression, findSystem(forces, element), element);
        return forces;
    }
    void realizeTopology(SimTK::State& state) const override {
        m_expression.allocate(findHandle(m_forces), state);
    }
    void calcForce(const SimTK::State&, SimTK::Vector_<SimTK::SpatialVec>&, SimTK::Vector_<SimTK::Vec3>&,
                   SimTK::Vector&) const override {}
    SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

    const SimTK::Subsystem::Guts& m_forces;  // the caller's handle of it may go away
    mutable TrackedExpression m_expression;  // mutable: its topology cache
};

}  // namespace jprim

#endif
