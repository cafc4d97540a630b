// SPDX-License-Identifier: Apache-2.0
// What a matrix of a free structure must satisfy, term by term and row by row as far as possible: a message can
// then name the place.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/format.h"
#include "flexible/structure.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Mat33;
using SimTK::Vec3;

namespace {

// Matrices that other programs write carry about this many digits.
constexpr double DigitsOfMatrices = 1e-6;

const char* const Motions[] = {"translation along x", "translation along y", "translation along z",
                               "rotation about x",    "rotation about y",    "rotation about z"};

// Of a symmetric matrix, row by row; a file of one triangle mostly holds the upper one.
template <class Action>
void forEachTerm(const SparseMatrix& matrix, Action action) {
    for (int row = 0; row < matrix.outerSize(); ++row)
        for (SparseMatrix::InnerIterator term(matrix, row); term; ++term)
            action(row, int(term.row()), term.value());
}

void checkDiagonal(const NamedMatrix& named) {
    const Eigen::VectorXd diagonal = named.get().diagonal();
    for (int i = 0; i < int(diagonal.size()); ++i)
        if (diagonal[i] < 0)
            named.failAt(i, i,
                         fmt::format("has {:.3g} on its diagonal in {}; a diagonal term is not negative",
                                     diagonal[i], named.nameRow(i)));
}

// No term of a matrix that is positive semidefinite exceeds the geometric mean of its diagonals, and in
// comparison with that mean it equals its mirror image.
void checkTerms(const NamedMatrix& named) {
    const SparseMatrix& matrix = named.get();
    const Eigen::VectorXd root = matrix.diagonal().cwiseSqrt();
    forEachTerm(matrix - SparseMatrix(matrix.transpose()), [&](int row, int column, double difference) {
        if (std::abs(difference) > DigitsOfMatrices * root[row] * root[column])
            named.failAt(
                row, column,
                fmt::format("is not symmetric: {} is {:.6g}, its mirror image {:.6g}; a file holds one "
                            "triangle or both in full",
                            named.nameTerm(row, column), matrix.coeff(row, column),
                            matrix.coeff(column, row)));
    });
    forEachTerm(matrix, [&](int row, int column, double value) {
        const double most = root[row] * root[column];
        if (std::abs(value) <= most * (1 + DigitsOfMatrices)) return;
        const int zero = root[row] == 0 ? row : column;
        if (most == 0)
            named.failAt(
                zero, zero,
                fmt::format("is not positive definite: there is no {} on the diagonal in {}, but in other "
                            "columns",
                            named.getKind(), named.nameRow(zero)));
        named.failAt(
            row, column,
            fmt::format("is not positive definite: {} is {:.3g}, more than the diagonal terms of the row "
                        "and the column allow, {:.3g}; one of the three is wrong",
                        named.nameTerm(row, column), value, most));
    });
}

Vec3 calcMeanPosition(const FiniteElementModel& model) {
    Vec3 mean(0);
    for (const FiniteElementNode& node : model.nodes) mean += node.position / double(model.nodes.size());
    return mean;
}

// Every node must be reached from the first through stiffness.
void checkConnected(const Structure& structure) {
    const FiniteElementModel& model = structure.model;
    std::vector<int> leader(model.nodes.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&leader](int i) {
        while (leader[std::size_t(i)] != i)
            i = leader[std::size_t(i)] = leader[std::size_t(leader[std::size_t(i)])];
        return i;
    };
    forEachTerm(structure.K.get(), [&](int row, int column, double value) {
        if (value != 0)
            leader[std::size_t(find(row / model.freedomsPerNode))] = find(column / model.freedomsPerNode);
    });
    for (int i = 1; i < int(leader.size()); ++i)
        if (find(i) != find(0))
            structure.K.fail(fmt::format("connects node {} with node {} by no term; the mesh is in pieces",
                                         model.nodes[std::size_t(i)].id, model.nodes[0].id));
}

// The forces of row i cancel when all nodes move along an axis, whatever else acts in the mesh, and when they turn
// about the row's own node, unless the mesh is under stress: its stress over its modulus is what is left.
void checkRowsOfStiffness(const Structure& structure) {
    constexpr double Stressed = 1e-2;
    const FiniteElementModel& model = structure.model;
    const SparseMatrix& K = structure.K.get();
    const int f = model.freedomsPerNode;
    const Eigen::VectorXd root = K.diagonal().cwiseSqrt();
    for (int i = 0; i < K.outerSize(); ++i) {
        Eigen::Matrix<double, 1, 6> force = Eigen::Matrix<double, 1, 6>::Zero(), scale = force;
        const Vec3& center = model.nodes[std::size_t(i / f)].position;
        for (SparseMatrix::InnerIterator term(K, i); term; ++term) {
            const int j = int(term.row());
            const auto R = calcRigidMotion(j % f, model.nodes[std::size_t(j / f)].position - center);
            force += term.value() * R;
            scale += root[i] * root[j] * R.cwiseAbs();
        }
        for (int k = 0; k < 6; ++k)
            if (!(std::abs(force[k]) <= (k < 3 ? DigitsOfMatrices : Stressed) * scale[k]))
                structure.K.fail(fmt::format(
                    "meets a {} of the whole mesh with a force in {}; the mesh is supported there (give it without "
                    "supports), or a term of that row is wrong or missing{}",
                    Motions[k], structure.K.nameRow(i),
                    k < 3 ? "" : ", or the nodes have other positions or another order"));
    }
}

// Turning the mesh deforms nothing, unless something outside holds it.
void checkRotations(const Structure& structure) {
    const SparseMatrix& K = structure.K.get();
    const RigidMotions R = makeRigidMotions(structure.model, calcMeanPosition(structure.model));
    for (int k = 3; k < 6; ++k) {
        const double energy = R.col(k).dot(K * R.col(k));
        const double scale = R.col(k).cwiseAbs().dot(K.cwiseAbs() * R.col(k).cwiseAbs());
        if (std::abs(energy) > DigitsOfMatrices * scale)
            structure.K.fail(
                fmt::format("holds the mesh: {} meets resistance; give it without supports", Motions[k]));
    }
}

// What the rows of a node add up to along each axis, and the sum of sizes.
struct MassOfNode {
    Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
    double scale = 0;
};

MassOfNode addUpMass(const SparseMatrix& M, int node) {
    MassOfNode mass;
    for (int axis = 0; axis < 3; ++axis)
        for (SparseMatrix::InnerIterator term(M, 3 * node + axis); term; ++term) {
            mass.sums(axis, term.row() % 3) += term.value();
            mass.scale += std::abs(term.value());
        }
    return mass;
}

// A solid's shape functions are the same in all directions, and so is the mass of a node; of three that differ the
// one in the middle is taken for right.
void checkRowsOfMass(const Structure& structure) {
    const SparseMatrix& M = structure.M.get();
    for (int node = 0; node < int(structure.model.nodes.size()); ++node) {
        const MassOfNode mass = addUpMass(M, node);
        Eigen::Vector3d sorted = mass.sums.diagonal();
        std::sort(sorted.begin(), sorted.end());
        for (int row = 0; row < 3; ++row)
            for (int axis = 0; axis < 3; ++axis) {
                const double expected = axis == row ? sorted[1] : 0;
                if (!(std::abs(mass.sums(row, axis) - expected) <= DigitsOfMatrices * mass.scale))
                    structure.M.fail(fmt::format(
                        "has {:.6g} along {} as the sum of {}, not {:.6g}; a node has the same mass in x, y and z, "
                        "and a term of the row is wrong or missing",
                        mass.sums(row, axis), "xyz"[axis], structure.M.nameRow(3 * node + row), expected));
            }
    }
}

// Freedoms may have no mass, and reduced integration may leave a motion without.
void checkMassDefinite(const NamedMatrix& M) {
    constexpr double Lift = 10 * DigitsOfMatrices;
    const Eigen::VectorXd lift = M.get().diagonal().unaryExpr([](double m) { return m == 0 ? 1 : Lift * m; });
    const SparseMatrix lifted = M.get() + SparseMatrix(lift.asDiagonal());
    if (!isPositiveDefinite(lifted))
        M.failIndefinite(
            findWeakestMotion(lifted),
            ": some motion has a negative mass; look for a negative or a zero term, and for a file of "
            "another mesh or order of freedoms");
}

}  // namespace

// In the rigid motion with velocity v and angular velocity w about o the momentum is m (v - c x w), and the
// angular momentum about o m c x v + I_o w, c from o. A point in the mesh keeps the difference of I_o and m c^2
// exact.
RigidBodyProperties calcRigidBodyProperties(const Structure& structure) {
    const Vec3 origin = calcMeanPosition(structure.model);
    const RigidMotions R = makeRigidMotions(structure.model, origin);
    const Eigen::Matrix<double, 6, 6> rigid = R.transpose() * (structure.M.get() * R);

    RigidBodyProperties result;
    result.mass = rigid.topLeftCorner<3, 3>().trace() / 3;
    if (!(result.mass > 0)) throw Error(structure.model.name, "the mesh has no mass; give a density");
    for (int k = 0; k < 3; ++k)
        if (!(std::abs(rigid(k, k) - result.mass) <= 10 * DigitsOfMatrices * result.mass))
            structure.M.fail(
                fmt::format("has a total of {:.6g} along x, {:.6g} along y, {:.6g} along z; they must "
                            "be the same",
                            rigid(0, 0), rigid(1, 1), rigid(2, 2)));
    // The off-diagonal block is -m [c]: entry (0, 4) is m c_z, (0, 5) is -m c_y, (1, 5) is m c_x.
    const Vec3 c = Vec3(rigid(1, 5), -rigid(0, 5), rigid(0, 4)) / result.mass;
    result.center = origin + c;
    const Mat33 shift = result.mass * (SimTK::dot(c, c) * Mat33(1) - SimTK::outer(c, c));
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result.inertia(i, j) = rigid(3 + i, 3 + j) - shift(i, j);
    return result;
}

void checkStructure(const Structure& structure) {
    for (const NamedMatrix* matrix : {&structure.K, &structure.M}) {
        checkDiagonal(*matrix);
        checkTerms(*matrix);
    }
    checkConnected(structure);
    checkRowsOfStiffness(structure);
    checkRotations(structure);
    if (structure.model.freedomsPerNode == 3) checkRowsOfMass(structure);
    checkMassDefinite(structure.M);
    calcRigidBodyProperties(structure);
}

}  // namespace jprim
