// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_ANGLE_MEMORY_H_
#define JPRIM_SRC_MARKER_ANGLE_MEMORY_H_

#include <string>

#include "marker/marker_expression.h"

namespace jprim {

/// The turns of an expression's angles AX, AY and AZ, each sought within half a turn of where it was at the last
/// step that an integrator completed. That is kept in the State, so a trial step that is thrown away leaves no
/// trace and States do not disturb each other. A Measure of the markers' matter subsystem follows the angles at every
/// position, whether or not the element that the expression belongs to is disabled.
class AngleMemory {
public:
    /// Remembers nothing, as does that of an expression without angles.
    AngleMemory() = default;
    explicit AngleMemory(const MarkerExpression& expression);

    /// Before an evaluation.
    void recall(const SimTK::State& state, Evaluation& evaluation) const;

    int getNumAngles() const;
    /// The angles [turns] at a State's position. Requires Stage::Position.
    SimTK::Vector getTurns(const SimTK::State& state) const;
    /// Each angle will be sought within half a turn of the one given. @throws Error naming the element for another
    /// number of turns, or one that is not finite
    void setTurns(SimTK::State& state, const SimTK::Vector& turns, const std::string& element) const;

private:
    class Follower;
    const Follower& getFollower() const;

    SimTK::AbstractMeasure m_follower;
};

/// @throws Error naming the element unless there are as many turns as angles, all of them finite
void checkTurns(const SimTK::Vector& turns, int numAngles, const std::string& element);

}  // namespace jprim

#endif
