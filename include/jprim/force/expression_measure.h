// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_FORCE_EXPRESSION_MEASURE_H_
#define JPRIM_FORCE_EXPRESSION_MEASURE_H_

#include "jprim/marker/expression.h"
#include "jprim/marker/typed_handle.h"

namespace jprim {

class ExpressionMeasureImpl;

/// An expression as a member of a system, where its angles AX, AY and AZ count whole turns from step to step
/// of an integrator, whether or not it is disabled. To Simbody it is a force element that applies no force; the
/// handle holds no data.
class ExpressionMeasure : public TypedForce<ExpressionMeasure> {
public:
    /// An empty handle; good only to be assigned to.
    ExpressionMeasure() = default;
    static constexpr const char* ClassName = "ExpressionMeasure";
    static bool isInstanceOf(const SimTK::Force& force);

    /// @throws Error if the expression is a vector, or if one of its markers is on no body or in another system than
    ///         the forces
    ExpressionMeasure(SimTK::GeneralForceSubsystem& forces, const Expression& expression);

    /// Requires Stage::Position, Stage::Velocity or Stage::Acceleration, as the highest derivative in the
    /// expression does.
    SimTK::Real calcValue(const SimTK::State& state) const;

    /// @name Turns
    /// How far the angles AX, AY and AZ in the expression have turned, as GeneralConstraint has them. They are
    /// remembered: a State to which nothing but q and u is copied has to be given them too.
    ///@{
    SimTK::Vector getTurns(const SimTK::State& state) const;
    void setTurns(SimTK::State& state, const SimTK::Vector& turns) const;
    void resetTurns(SimTK::State& state) const;
    ///@}

private:
    const ExpressionMeasureImpl& getImpl() const;
    ExpressionMeasure(SimTK::GeneralForceSubsystem& forces, ExpressionMeasureImpl* implementation);
};

}  // namespace jprim

#endif
