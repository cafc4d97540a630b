// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_LINEAR_ALGEBRA_SINGULAR_VALUES_H_
#define JPRIM_SRC_LINEAR_ALGEBRA_SINGULAR_VALUES_H_

#include <Eigen/Core>

namespace jprim {

/// A = U S ~V, with orthogonal U and V.
struct SingularValues {
    Eigen::VectorXd values;  ///< descending
    Eigen::MatrixXd U, V;
};
SingularValues decompose(const Eigen::MatrixXd& A);

/// The values alone.
Eigen::VectorXd calcSingularValues(const Eigen::MatrixXd& A);

}  // namespace jprim

#endif
