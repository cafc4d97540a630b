// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_VIOLATION_H_
#define JPRIM_SRC_SIMULATION_VIOLATION_H_

#include "jprim/simulation/assemble.h"

namespace jprim {

/// Makes `worst` the larger of both, lengths and angles apart, with the element of the largest.
void keepWorst(Violation& worst, const Violation& now);

/// The same with the error of one equation.
void keepWorst(Violation& worst, const ConstraintEquation& equation, SimTK::Real error);

/// Where the given poses do not fit a mobilizer, its joint is violated as equations in its place would be.
/// @param given  the State that comes nearest to the given poses. Requires Stage::Position
void addMisfits(const Mechanism& mechanism, const SimTK::State& given, Violation& violation);

/// The parts that are elsewhere in the State than given. Requires Stage::Position.
std::vector<MovedPart> findMovedParts(const Mechanism& mechanism, const SimTK::State& state);

}  // namespace jprim

#endif
