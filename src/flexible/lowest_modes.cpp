// SPDX-License-Identifier: Apache-2.0
// Solutions of K phi = lambda M phi by way of inv(K + s M) M phi = nu phi, nu = 1/(lambda + s): the lowest
// lambda have the largest nu, which Lanczos' iteration finds first, and freedoms without mass have nu = 0.
#include "flexible/lowest_modes.h"

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include <algorithm>

#include "base/format.h"
#include "jprim/base/error.h"
#include "linear_algebra/eigenvalues.h"
#include "linear_algebra/equations.h"

namespace jprim {

namespace {

// nu below this part of the largest belongs to no mass but to rounding.
constexpr double Massless = 1e-14;

constexpr int DenseIsFaster = 400, LargestDense = 6000;  // freedoms

/// What Spectra asks of inv(K - sigma M), on a factor that exists already.
class InverseOperator {
public:
    using Scalar = double;
    explicit InverseOperator(const ShiftedStiffness& K) : m_K(K) {}
    Eigen::Index rows() const { return m_K.getSize(); }
    Eigen::Index cols() const { return m_K.getSize(); }
    void set_shift(double) {}
    void perform_op(const double* in, double* out) const {
        Eigen::Map<Eigen::VectorXd>(out, m_K.getSize()) =
            m_K.solve(Eigen::Map<const Eigen::VectorXd>(in, m_K.getSize()));
    }

private:
    const ShiftedStiffness& m_K;
};

// With inv(K + s M) = F ~F the problem is the symmetric one ~F M F y = nu y, phi = F y / sqrt(nu). It needs no
// definite M.
Eigen::MatrixXd solveDensely(const ShiftedStiffness& K, const SparseMatrix& M, int count,
                             const std::string& element) {
    const Eigen::MatrixXd flexibility = K.solve(Eigen::MatrixXd::Identity(K.getSize(), K.getSize()));
    const Eigen::MatrixXd F = calcCholeskyFactor(flexibility);
    const Eigenvectors solution = calcEigenvectors(F.transpose() * (M * F));
    const Eigen::VectorXd nu = solution.values.reverse();
    const int available = int((nu.array() > Massless * nu[0]).count());
    if (count > available)
        throw Error(element, fmt::format("more modes are wanted than motions with mass; ask for {} fewer",
                                         count - available));
    return F * solution.vectors.rightCols(count).rowwise().reverse() *
           nu.head(count).cwiseSqrt().cwiseInverse().asDiagonal();
}

Eigen::MatrixXd solveByLanczos(const ShiftedStiffness& K, const SparseMatrix& M, int count,
                               const std::string& element) {
    constexpr double Tolerance = 1e-13;
    constexpr int MostRestarts = 1000;
    InverseOperator inverse(K);
    Spectra::SparseSymMatProd<double> mass(M);
    const int subspace = std::min(K.getSize(), std::max(2 * count + 1, 20));
    Spectra::SymGEigsShiftSolver<InverseOperator, Spectra::SparseSymMatProd<double>,
                                 Spectra::GEigsMode::ShiftInvert>
        solver(inverse, mass, count, subspace, -K.getShift());
    Eigen::Index found = 0;
    try {
        solver.init();
        found = solver.compute(Spectra::SortRule::LargestMagn, MostRestarts, Tolerance,
                               Spectra::SortRule::SmallestAlge);
    } catch (const std::exception& error) {  // Spectra's, about its own small matrices
        throw Error(element,
                    fmt::format("the search for modes broke down ({}); look for stiffnesses or masses "
                                "of very different sizes",
                                error.what()));
    }
    if (solver.info() != Spectra::CompInfo::Successful)
        throw Error(element, fmt::format("only {} of {} modes were found; ask for fewer", found, count));
    return solver.eigenvectors();
}

}  // namespace

ShiftedStiffness::ShiftedStiffness(const SparseMatrix& K, const SparseMatrix& M, double shift)
    : m_shift(shift), m_size(int(K.rows())), m_factor(shift == 0 ? K : SparseMatrix(K + shift * M)) {}

int calcMostModes(int freedoms) {
    return freedoms <= LargestDense ? freedoms : freedoms / 3;
}

Eigen::MatrixXd calcLowestModes(const ShiftedStiffness& K, const SparseMatrix& M, int count,
                                const std::string& element) {
    const int size = K.getSize();
    if (count == 0) return Eigen::MatrixXd(size, 0);
    const bool isDense = size <= DenseIsFaster || count > size / 3;
    return isDense ? solveDensely(K, M, count, element) : solveByLanczos(K, M, count, element);
}

}  // namespace jprim
