// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_ANALYSIS_ERROR_MINIMUM_H_
#define JPRIM_SRC_ANALYSIS_ERROR_MINIMUM_H_

#include <Eigen/Core>

#include "analysis/scaled_equations.h"

namespace jprim {

/// The size of the largest entry; 0 if there is none.
double calcLargest(const Eigen::VectorXd& v);

/// Where the scaled position errors are as small as they become.
struct ErrorMinimum {
    SimTK::State state;
    Eigen::VectorXd errors;        ///< scaled
    Eigen::VectorXd displacement;  ///< the way there, as the sum of all motions u

    /// True if the equations are met to rounding, or to within `uncertainty`.
    bool isMet(double uncertainty = 0) const;
};

/// Levenberg and Marquardt's way down from a State to the next local minimum of |R e|^2. The equations must be
/// holonomic. Back onto constraints from nearby takes a handful of steps, or some twenty if that is a singular
/// position; to a conflict, where convergence is linear, it can take hundreds.
ErrorMinimum minimizeErrors(const ScaledEquations& equations, const SimTK::State& start, int mostSteps);

/// The least mu of a step with scaled errors of the given size. Where equations contradict each other by what was
/// rounded, motions that hardly change them are no way to meet them: they would lead far away for nothing.
double calcLeastDamping(double size);

}  // namespace jprim

#endif
