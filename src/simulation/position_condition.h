// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_POSITION_CONDITION_H_
#define JPRIM_SRC_SIMULATION_POSITION_CONDITION_H_

#include <string>

#include "SimTKsimbody.h"
#include "analysis/equation_loads.h"

namespace jprim {

/// The directions of a value: its rate is the sum of onBodies . V over all bodies, V = [w, v] in Ground of a body's
/// origin, and of onSpeeds . u.
struct Directions {
    Directions(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state)
        : onBodies(matter.getNumBodies(), SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(0))),
          onSpeeds(state.getNU(), SimTK::Real(0)) {}

    [[nodiscard]] EquationLoads getNonzero() const;

    SimTK::Vector_<SimTK::SpatialVec> onBodies;
    SimTK::Vector onSpeeds;
};

/// Equations on positions that are no constraints: coordinates with given values at the start.
class PositionCondition {
public:
    virtual ~PositionCondition() = default;

    /// One for each equation [length units, rad]; 0 where it is met. Requires Stage::Position.
    virtual SimTK::Vector calcErrors(const SimTK::State& state) const = 0;
    /// Adds those of one error. Requires Stage::Position.
    virtual void addDirections(const SimTK::State& state, int equation, Directions& directions) const = 0;
};

}  // namespace jprim

#endif
