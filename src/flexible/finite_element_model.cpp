// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/finite_element_model.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <unordered_set>

#include "flexible/structure.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Mat33;
using SimTK::Vec3;

namespace {

// Matrices that other programs write carry about this many digits.
constexpr double DigitsOfMatrices = 1e-6;

void checkNodes(const FiniteElementModel& model) {
    if (model.freedomsPerNode != 3 && model.freedomsPerNode != 6)
        throw Error(model.name,
                    fmt::format("a node has {} freedoms; it must have 3 or 6", model.freedomsPerNode));
    if (model.nodes.empty()) throw Error(model.name, "there are no nodes");
    std::unordered_set<int> ids;
    for (const FiniteElementNode& node : model.nodes)
        if (!ids.insert(node.id).second)
            throw Error(model.name, fmt::format("node {} is given twice", node.id));
}

void checkSymmetry(const FiniteElementModel& model, const SparseMatrix& matrix, const char* what) {
    const SparseMatrix difference = matrix - SparseMatrix(matrix.transpose());
    const double largest = matrix.coeffs().size() > 0 ? matrix.coeffs().abs().maxCoeff() : 0;
    for (int column = 0; column < difference.outerSize(); ++column)
        for (SparseMatrix::InnerIterator term(difference, column); term; ++term)
            if (std::abs(term.value()) > DigitsOfMatrices * largest)
                throw Error(model.name,
                            fmt::format("the {} matrix is not symmetric: row {}, column {} and its mirror "
                                        "image differ by {:.3g}",
                                        what, term.row(), term.col(), term.value()));
    for (int i = 0; i < matrix.rows(); ++i)
        if (matrix.coeff(i, i) < 0)
            throw Error(model.name, fmt::format("the {} matrix has {:.3g} on its diagonal in row {}", what,
                                                matrix.coeff(i, i), i));
}

// No term of a matrix that is positive semidefinite exceeds the geometric mean of its diagonals.
void checkMinors(const FiniteElementModel& model, const SparseMatrix& matrix, const char* what) {
    const Eigen::VectorXd diagonal = matrix.diagonal();
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (SparseMatrix::InnerIterator term(matrix, column); term; ++term) {
            const double most = std::sqrt(diagonal[term.row()] * diagonal[column]);
            if (std::abs(term.value()) > most * (1 + DigitsOfMatrices))
                throw Error(model.name,
                            fmt::format("the {} matrix is indefinite: {:.3g} in row {}, column {} is more "
                                        "than its diagonal allows, {:.3g}",
                                        what, term.value(), term.row(), column, most));
        }
}

// Every node must be reached from the first through stiffness.
void checkConnected(const FiniteElementModel& model, const SparseMatrix& K) {
    std::vector<int> leader(model.nodes.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&leader](int i) {
        while (leader[i] != i) i = leader[i] = leader[leader[i]];
        return i;
    };
    for (int column = 0; column < K.outerSize(); ++column)
        for (SparseMatrix::InnerIterator term(K, column); term; ++term)
            if (term.value() != 0)
                leader[find(int(term.row()) / model.freedomsPerNode)] = find(column / model.freedomsPerNode);
    for (int i = 1; i < int(leader.size()); ++i)
        if (find(i) != find(0))
            throw Error(model.name,
                        fmt::format("no stiffness connects node {} with node {}; the mesh is in pieces",
                                    model.nodes[i].id, model.nodes[0].id));
}

// A rigid motion deforms nothing, unless something outside holds the structure.
void checkFree(const FiniteElementModel& model, const SparseMatrix& K, const RigidMotions& R) {
    static const char* const motions[] = {"translation along x", "translation along y", "translation along z",
                                          "rotation about x",    "rotation about y",    "rotation about z"};
    for (int k = 0; k < 6; ++k) {
        const double energy = R.col(k).dot(K * R.col(k));
        const double scale = R.col(k).cwiseAbs().dot(K.cwiseAbs() * R.col(k).cwiseAbs());
        if (std::abs(energy) > DigitsOfMatrices * scale)
            throw Error(
                model.name,
                fmt::format("the mesh is held: {} meets resistance; give it without supports", motions[k]));
    }
}

// In the rigid motion with velocity v and angular velocity w about the origin the momentum is m (v - c x w),
// and the angular momentum about the origin m c x v + I_o w.
RigidBodyProperties calcRigidBodyProperties(const FiniteElementModel& model, const SparseMatrix& M,
                                            const RigidMotions& R) {
    const Eigen::Matrix<double, 6, 6> rigid = R.transpose() * (M * R);

    RigidBodyProperties result;
    result.mass = rigid.topLeftCorner<3, 3>().trace() / 3;
    if (!(result.mass > 0)) throw Error(model.name, "the mesh has no mass; give a density");
    // The off-diagonal block is -m [c]: entry (0, 4) is m c_z, (0, 5) is -m c_y, (1, 5) is m c_x.
    result.center = Vec3(rigid(1, 5), -rigid(0, 5), rigid(0, 4)) / result.mass;
    const Vec3& c = result.center;
    const Mat33 shift = result.mass * (SimTK::dot(c, c) * Mat33(1) - SimTK::outer(c, c));
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result.inertia(i, j) = rigid(3 + i, 3 + j) - shift(i, j);
    return result;
}

}  // namespace

void checkFiniteElementModel(const FiniteElementModel& model) {
    checkNodes(model);
    const SparseMatrix K = makeMatrix(model, model.stiffness, "stiffness");
    const SparseMatrix M = makeMatrix(model, model.mass, "mass");
    const RigidMotions R = makeRigidMotions(model);
    checkSymmetry(model, K, "stiffness");
    checkSymmetry(model, M, "mass");
    checkMinors(model, K, "stiffness");
    checkMinors(model, M, "mass");
    checkConnected(model, K);
    checkFree(model, K, R);
    calcRigidBodyProperties(model, M, R);
}

RigidBodyProperties calcRigidBodyProperties(const FiniteElementModel& model) {
    checkNodes(model);
    return calcRigidBodyProperties(model, makeMatrix(model, model.mass, "mass"), makeRigidMotions(model));
}

}  // namespace jprim
