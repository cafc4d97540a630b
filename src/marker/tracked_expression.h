// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_TRACKED_EXPRESSION_H_
#define JPRIM_SRC_MARKER_TRACKED_EXPRESSION_H_

#include <vector>

#include "jprim/marker/expression.h"
#include "marker/angle_memory.h"

namespace jprim {

/// An expression evaluated at States of one system, with what that needs in a State: memory to work in, and
/// the turns of its angles.
class TrackedExpression {
public:
    explicit TrackedExpression(const Expression& expression)
        : m_expression(expression), m_angles(expression.getImplementation()) {}

    const MarkerExpression& get() const { return m_expression.getImplementation(); }
    const AngleMemory& getAngles() const { return m_angles; }

    /// In realizeTopology().
    void allocate(const SimTK::Subsystem& subsystem, SimTK::State& state);

    /// Require the stage that Expression::calcValue() does.
    SimTK::Real calcValue(const SimTK::State& state) const;
    SimTK::Vec3 calcVector(const SimTK::State& state) const;

    /// The time derivative of a scalar of positions along the motion. Requires Stage::Velocity.
    SimTK::Real calcRate(const SimTK::State& state) const;

    /// A value whose sign decides something: of Program's switches, or another that matters.
    struct Switch {
        SimTK::Real value;
        SimTK::Real rate;  ///< if the State tells it
        KinematicLevel level;
    };
    /// The program's switches and, if it is wanted, a scalar result. Requires the stage that calcValue() does; rates of
    /// positions are told at Stage::Velocity, those of velocities at Stage::Acceleration.
    void addSwitches(const SimTK::State& state, bool withResult, std::vector<Switch>& switches) const;

private:
    Evaluation& prepare(const SimTK::State& state) const;

    Expression m_expression;
    AngleMemory m_angles;
    SimTK::SubsystemIndex m_subsystem;
    SimTK::CacheEntryIndex m_evaluation;
};

}  // namespace jprim

#endif
