// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_ANALYSIS_EQUATION_LOADS_H_
#define JPRIM_SRC_ANALYSIS_EQUATION_LOADS_H_

#include <utility>
#include <vector>

#include "jprim/analysis/constraint_equations.h"

namespace jprim {

/// What a multiplier of 1 of one equation puts on bodies and speeds, the row of the constraint Jacobian before a tree adds
/// it up: the equation's rate is the sum of F . V over bodies and of f u over speeds. Only what is not zero.
struct EquationLoads {
    /// [moment, force] in Ground at the body's origin.
    std::vector<std::pair<SimTK::MobilizedBodyIndex, SimTK::SpatialVec>> onBodies;
    std::vector<std::pair<int, SimTK::Real>> onSpeeds;
};

/// Of each equation. Each constraint is asked for its own loads alone, while Simbody's operator of the whole system asks
/// all constraints for each multiplier. Requires Stage::Velocity.
std::vector<EquationLoads> calcEquationLoads(const SimTK::SimbodyMatterSubsystem& matter,
                                             const SimTK::State& state,
                                             const std::vector<ConstraintEquation>& equations);

}  // namespace jprim

#endif
