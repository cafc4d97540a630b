// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/ranked_rows.h"

#include <Eigen/QR>
#include <limits>

#include "linear_algebra/orthogonal.h"
#include "linear_algebra/rank.h"

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;

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
    const VectorXd alongRows = Eigen::ColPivHouseholderQR<MatrixXd>(m_L).solve(b);
    return m_Q.leftCols(m_L.cols()) * alongRows;
}

MatrixXd RankedRows::calcPseudoInverse() const {
    if (m_L.cols() == 0) return MatrixXd::Zero(m_Q.rows(), m_L.rows());
    const MatrixXd alongRows =
        Eigen::ColPivHouseholderQR<MatrixXd>(m_L).solve(MatrixXd::Identity(m_L.rows(), m_L.rows()));
    return m_Q.leftCols(m_L.cols()) * alongRows;
}

VectorXd RankedRows::solveTransposed(const VectorXd& f) const {
    if (m_L.cols() == 0) return VectorXd::Zero(m_L.rows());
    const double threshold = std::numeric_limits<double>::epsilon() * double(m_L.cols());
    return solveLeastNorm(m_L.transpose(), m_Q.leftCols(m_L.cols()).transpose() * f, threshold);
}

}  // namespace jprim
