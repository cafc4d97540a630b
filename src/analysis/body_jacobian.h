// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_ANALYSIS_BODY_JACOBIAN_H_
#define JPRIM_SRC_ANALYSIS_BODY_JACOBIAN_H_

#include <Eigen/SparseCore>
#include <utility>
#include <vector>

#include "analysis/equation_loads.h"

namespace jprim {

/// V = [w, v] of all bodies' origins in Ground by the speeds, V_B = J_B u, at one State. Only what is not zero: of a
/// body that hangs on Ground by itself no more than its own speeds.
class BodyJacobian {
public:
    using Triplets = std::vector<Eigen::Triplet<double>>;

    /// Requires Stage::Position.
    BodyJacobian(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state);

    /// Adds a row that multiplies u to the sum of F . V and f u, times a factor.
    void addRow(const EquationLoads& loads, double factor, int row, Triplets& entries) const;
    /// Adds the six rows of V of a body, those of v times another factor than those of w.
    void addBody(SimTK::MobilizedBodyIndex body, double turnFactor, double shiftFactor, int row,
                 Triplets& entries) const;

private:
    std::vector<std::vector<std::pair<int, SimTK::SpatialVec>>> m_columns;  // of each body: speed and its V
};

}  // namespace jprim

#endif
