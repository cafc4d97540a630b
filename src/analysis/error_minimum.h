// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_ANALYSIS_ERROR_MINIMUM_H_
#define JPRIM_SRC_ANALYSIS_ERROR_MINIMUM_H_

#include <Eigen/Core>

#include "analysis/scaled_equations.h"

namespace jprim {

/// Where the scaled position errors are as small as they become.
struct ErrorMinimum {
    SimTK::State state;
    Eigen::VectorXd errors;        ///< scaled
    Eigen::VectorXd displacement;  ///< the way there, as the sum of all motions u

    /// True if the equations are met to rounding.
    bool isMet() const;
};

/// Levenberg and Marquardt's way down from a State to the next local minimum of |R e|^2. The equations must be
/// holonomic. Back onto constraints from nearby takes a handful of steps, or some twenty if that is a singular
/// position; to a conflict, where convergence is linear, it can take hundreds.
ErrorMinimum minimizeErrors(const ScaledEquations& equations, const SimTK::State& start, int mostSteps);

}  // namespace jprim

#endif
