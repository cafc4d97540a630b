// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_CONSTRAINT_JACOBIAN_H_
#define JPRIM_SRC_SIMULATION_CONSTRAINT_JACOBIAN_H_

#include <Eigen/Dense>

#include "jprim/build/mechanism.h"

namespace jprim {

/// G of the equations that speeds must satisfy, of positions and of velocities: the first `numEquations` of
/// Simbody's. Requires Stage::Position.
Eigen::MatrixXd calcConstraintJacobian(const Mechanism& mechanism, const SimTK::State& state,
                                       Eigen::Index numEquations);

/// An orthonormal basis of the null space. Rows that depend on others cancel to about the assembly tolerance.
Eigen::MatrixXd calcNullSpace(const Eigen::MatrixXd& A);

/// See calcNullSpace().
constexpr double JacobianRankTolerance = 1e-8;

}  // namespace jprim

#endif
