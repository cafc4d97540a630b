// SPDX-License-Identifier: Apache-2.0
#include "simulation/constraint_jacobian.h"

#include <algorithm>

#include "analysis/rank.h"
#include "analysis/scaled_equations.h"

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

std::vector<ConstraintEquation> findSpeedEquations(const Mechanism& mechanism, const SimTK::State& state) {
    std::vector<ConstraintEquation> equations = mechanism.findEquations(state);
    const auto isOfAccelerations = [](const ConstraintEquation& e) {
        return e.level == EquationLevel::Acceleration;
    };
    equations.erase(std::find_if(equations.begin(), equations.end(), isOfAccelerations), equations.end());
    return equations;
}

}  // namespace

SpeedEquations::SpeedEquations(const Mechanism& mechanism, const SimTK::State& state) {
    const ScaledEquations scaled(mechanism.getMatter(), findSpeedEquations(mechanism, state), state);
    m_inverseScales.resize(Eigen::Index(scaled.getEquations().size()));
    for (Eigen::Index i = 0; i < m_inverseScales.size(); ++i) {
        const double scale = scaled.getEquations()[size_t(i)].scale;
        m_inverseScales[i] = scale > 0 ? 1 / scale : 0;
    }
    m_G = m_inverseScales.asDiagonal() * scaled.calcCleanJacobian(state);
}

RankedRows::RankedRows(const MatrixXd& A) : m_Q(MatrixXd::Identity(A.cols(), A.cols())), m_L(A.rows(), 0) {
    if (A.size() == 0) return;
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(A.transpose());  // ~A P = Q R
    const VectorXd pivots = qr.matrixR().diagonal().cwiseAbs();
    const int rank = decideRank({pivots.begin(), pivots.end()}).rank;
    const MatrixXd R = qr.matrixR().topRows(rank).triangularView<Eigen::Upper>();
    m_Q = qr.householderQ();
    m_L = qr.colsPermutation() * R.transpose();
}

MatrixXd RankedRows::calcNullSpace() const {
    return m_Q.rightCols(m_Q.cols() - m_L.cols());
}

VectorXd RankedRows::solve(const VectorXd& b) const {
    if (m_L.cols() == 0) return VectorXd::Zero(m_Q.rows());
    return m_Q.leftCols(m_L.cols()) * m_L.colPivHouseholderQr().solve(b);
}

VectorXd RankedRows::solveTransposed(const VectorXd& f) const {
    if (m_L.cols() == 0) return VectorXd::Zero(m_L.rows());
    return m_L.transpose().completeOrthogonalDecomposition().solve(m_Q.leftCols(m_L.cols()).transpose() * f);
}

}  // namespace jprim
