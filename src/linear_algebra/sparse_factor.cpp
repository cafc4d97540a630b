// SPDX-License-Identifier: Apache-2.0
#include "linear_algebra/sparse_factor.h"

#include <Eigen/MetisSupport>
#include <Eigen/SparseCholesky>
#include <iostream>  // MetisSupport uses std::cerr without including it

namespace jprim {

using Eigen::VectorXd;
using Simplicial = Eigen::SimplicialLDLT<SparseMatrix>;

struct SparseFactor::Implementation {
    Simplicial factor;
    bool isDiagonal = false;
    VectorXd inverse;  // of a diagonal matrix
};

SparseFactor::SparseFactor() : m_implementation(std::make_unique<Implementation>()) {}
SparseFactor::~SparseFactor() = default;

void SparseFactor::compute(const SparseMatrix& A) {
    const VectorXd diagonal = A.diagonal();
    m_implementation->isDiagonal = A.nonZeros() == A.cols() && (diagonal.array() != 0).all();
    if (m_implementation->isDiagonal)
        m_implementation->inverse = diagonal.cwiseInverse();
    else
        m_implementation->factor.compute(A);
}

VectorXd SparseFactor::solve(const VectorXd& b) const {
    if (m_implementation->isDiagonal) return m_implementation->inverse.cwiseProduct(b);
    return m_implementation->factor.solve(b);
}

SparseMatrix SparseFactor::solve(const SparseMatrix& B) const {
    if (m_implementation->isDiagonal) return m_implementation->inverse.asDiagonal() * B;
    return m_implementation->factor.solve(B);
}

struct LargeFactor::Implementation {
    Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::MetisOrdering<int>> factor;
};

LargeFactor::LargeFactor(const SparseMatrix& A) : m_implementation(std::make_unique<Implementation>()) {
    if (A.rows() > 0) m_implementation->factor.compute(A);
}

LargeFactor::~LargeFactor() = default;

bool LargeFactor::isDefinite() const {
    return m_implementation->factor.rows() == 0 || m_implementation->factor.info() == Eigen::Success;
}

Eigen::MatrixXd LargeFactor::solve(const Eigen::MatrixXd& B) const {
    return m_implementation->factor.solve(B);
}

bool isPositiveDefinite(const SparseMatrix& A) {
    return Eigen::SimplicialLLT<SparseMatrix>(A).info() == Eigen::Success;
}

// With A = ~P L D ~L P, the solution of ~L P u = e_k has ~u A u = D_k: freedom k moves by 1 and those eliminated
// before it follow as they like.
VectorXd findWeakestMotion(const SparseMatrix& A) {
    constexpr double Small = 1e-10;  // keeps exact zeros from stopping the factorization
    const VectorXd diagonal =
        A.diagonal().unaryExpr([](double value) { return value == 0 ? 1 : std::abs(value); });
    const SparseMatrix shift(VectorXd(Small * diagonal).asDiagonal());
    const Simplicial factor(A + shift);
    Eigen::Index weakest = 0;
    if (factor.info() != Eigen::Success) {
        A.diagonal().minCoeff(&weakest);
        return VectorXd::Unit(A.rows(), weakest);
    }
    const VectorXd eliminated = factor.permutationP() * diagonal;
    factor.vectorD().cwiseQuotient(eliminated).minCoeff(&weakest);
    const VectorXd unit = VectorXd::Unit(A.rows(), weakest);
    return factor.permutationPinv() * VectorXd(factor.matrixU().solve(unit));
}

}  // namespace jprim
