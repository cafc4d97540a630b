// SPDX-License-Identifier: Apache-2.0
#include "simulation/constraint_jacobian.h"

#include <Eigen/QR>

namespace jprim {

Eigen::MatrixXd calcConstraintJacobian(const Mechanism& mechanism, const SimTK::State& state,
                                       Eigen::Index numEquations) {
    if (numEquations == 0) return Eigen::MatrixXd::Zero(0, state.getNU());
    SimTK::Matrix G;
    mechanism.getMatter().calcG(state, G);
    return Eigen::Map<const Eigen::MatrixXd>(&G(0, 0), G.nrow(), G.ncol()).topRows(numEquations);
}

Eigen::MatrixXd calcNullSpace(const Eigen::MatrixXd& A) {
    if (A.size() == 0) return Eigen::MatrixXd::Identity(A.cols(), A.cols());
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A.transpose());
    qr.setThreshold(JacobianRankTolerance);
    const Eigen::MatrixXd Q = qr.householderQ();
    return Q.rightCols(A.cols() - qr.rank());
}

}  // namespace jprim
