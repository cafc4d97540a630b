// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_ANALYSIS_NEARBY_POSITIONS_H_
#define JPRIM_SRC_ANALYSIS_NEARBY_POSITIONS_H_

#include <Eigen/Core>

#include "analysis/scaled_equations.h"
#include "linear_algebra/rank.h"

namespace jprim {

/// The equations at another admissible position.
struct NearbyPosition {
    /// The scaled Jacobian there; in the rows and columns of immobile blocks that of the position itself.
    Eigen::MatrixXd A;
    /// For freedoms V of the position that lead nowhere: dA V, with dA the change of A along one of them.
    /// No columns if all lead somewhere.
    Eigen::MatrixXd obstruction;
};

/// Moves along a random free direction and back on the constraints; tries again with another where that
/// leads nowhere. If no try comes back on the constraints, the position itself is returned.
/// @param state  admissible
/// @param here   the scaled Jacobian's Decomposition there, with vectors
/// @param uncertainty  up to which positions are admissible
NearbyPosition findNearbyPosition(const SimTK::SimbodyMatterSubsystem& matter, const ScaledEquations& scaled,
                                  const SimTK::State& state, const Decomposition& here,
                                  double uncertainty = 0);

}  // namespace jprim

#endif
