// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_COORDINATE_DIRECTION_H_
#define JPRIM_SRC_SIMULATION_COORDINATE_DIRECTION_H_

#include "marker/marker_expression.h"
#include "simulation/position_condition.h"

namespace jprim {

/// Adds the directions of a coordinate: the sum of direction . V over its markers. Requires Stage::Position.
void addCoordinateDirections(const MarkerExpression& coordinate, const SimTK::State& state,
                             Directions& directions);

}  // namespace jprim

#endif
