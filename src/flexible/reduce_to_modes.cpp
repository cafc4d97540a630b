// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/reduce_to_modes.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "flexible/inertia_coupling.h"
#include "flexible/lowest_modes.h"
#include "flexible/node_rotations.h"
#include "flexible/tied_structure.h"
#include "jprim/base/error.h"

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using SimTK::Vec3;

namespace {

/// The tied structure's matrices and their parts between interfaces (b) and interior (i).
struct Partition {
    Partition(const TiedStructure& tied, const SparseMatrix& meshK, const SparseMatrix& meshM)
        : K(tied.meshFromTied.transpose() * meshK * tied.meshFromTied),
          M(tied.meshFromTied.transpose() * meshM * tied.meshFromTied) {
        const int b = tied.numInterfaceFreedoms, i = int(K.rows()) - b;
        K_ib = K.bottomLeftCorner(i, b);
        K_ii = K.bottomRightCorner(i, i);
        M_ii = M.bottomRightCorner(i, i);
    }
    SparseMatrix K, M, K_ib, K_ii, M_ii;
};

// T = [1 0; Psi phi]
MatrixXd makeCraigBamptonShapes(const Partition& p, int numFixedModes, const std::string& name) {
    const Eigen::Index b = p.K_ib.cols(), i = p.K_ib.rows();
    const ShiftedStiffness interior(p.K_ii, p.M_ii, 0, name);
    MatrixXd T = MatrixXd::Zero(b + i, b + numFixedModes);
    T.topLeftCorner(b, b).setIdentity();
    T.bottomRightCorner(i, numFixedModes) = calcLowestModes(interior, p.M_ii, numFixedModes, name);
    if (i > 0) T.bottomLeftCorner(i, b) = -interior.solve(MatrixXd(p.K_ib));
    return T;
}

// The lowest modes of the free structure, the six rigid ones among them. Its stiffness alone cannot be
// factored; adding M times a number well below any squared frequency but the rigid ones' makes it possible.
MatrixXd makeFreeShapes(const Partition& p, int numModes, const std::string& name) {
    constexpr double Small = 1e-6;
    const double highest = p.K.diagonal().sum() / p.M.diagonal().sum();
    const ShiftedStiffness shifted(p.K, p.M, Small * highest, name);
    return calcLowestModes(shifted, p.M, numModes + 6, name);
}

/// Free modes within the span of T.
struct FreeModes {
    VectorXd squaredFrequencies;
    MatrixXd shapes;
};

// Z spans what is M-orthogonal to the rigid motions: ~(T Z) M R = 0. The eigenproblem within Z then has no
// rigid solutions to be told from elastic ones.
FreeModes solveWithoutRigidMotions(const MatrixXd& T, const Partition& p, const RigidMotions& R,
                                   const std::string& name) {
    const MatrixXd momenta = T.transpose() * (p.M * R);
    const MatrixXd Q = Eigen::HouseholderQR<MatrixXd>(momenta).householderQ();
    const MatrixXd TZ = T * Q.rightCols(T.cols() - 6);
    const MatrixXd K = TZ.transpose() * (p.K * TZ), M = TZ.transpose() * (p.M * TZ);
    const Eigen::LLT<MatrixXd> massFactor(M);
    if (massFactor.info() != Eigen::Success)
        throw Error(name,
                    "the mass matrix is not positive definite; the interfaces may have no mass of "
                    "their own, or the matrix is indefinite");
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(K, M);
    return {solver.eigenvalues(), TZ * solver.eigenvectors()};
}

void checkFrequencies(const VectorXd& squares, const std::string& name) {
    constexpr double Zero = 1e-13;  // of the highest squared frequency: rounding
    if (squares.size() == 0 || squares[0] > Zero * squares[squares.size() - 1]) return;
    throw Error(name, squares[0] < -Zero * squares[squares.size() - 1]
                          ? fmt::format("the stiffness matrix is indefinite: a squared frequency is {:.3g}",
                                        squares[0])
                          : "a motion besides the six rigid ones meets no resistance; the mesh contains a "
                            "mechanism");
}

// Eigenvectors have no sign of their own: the largest term is made positive.
void fixSigns(MatrixXd& shapes) {
    for (auto shape : shapes.colwise()) {
        Eigen::Index at = 0;
        shape.cwiseAbs().maxCoeff(&at);
        if (shape[at] < 0) shape = -shape;
    }
}

Vec3 getVec3(const MatrixXd& shapes, Eigen::Index row, int mode) {
    return {shapes(row, mode), shapes(row + 1, mode), shapes(row + 2, mode)};
}

// Shapes of all freedoms of the mesh and of the interfaces as nodes of the basis.
void addNodes(const FiniteElementModel& model, const TiedStructure& tied, const SparseMatrix& K,
              const MatrixXd& meshShapes, const MatrixXd& tiedShapes, ModalBasis& basis) {
    const int numModes = int(meshShapes.cols()), f = model.freedomsPerNode;
    const auto add = [&](const FiniteElementNode& node, const MatrixXd& shapes, Eigen::Index row) {
        ModalNode result{node.id, node.position, {}, {}};
        for (int k = 0; k < numModes; ++k) {
            result.translation.push_back(getVec3(shapes, row, k));
            if (f == 6 || &shapes == &tiedShapes) result.rotation.push_back(getVec3(shapes, row + 3, k));
        }
        basis.nodes.push_back(result);
    };
    for (size_t i = 0; i < model.nodes.size(); ++i) add(model.nodes[i], meshShapes, Eigen::Index(i) * f);
    if (f == 3) fitNodeRotations(K, basis.nodes);
    for (size_t k = 0; k < tied.interfaces.size(); ++k) {
        basis.interfaces.push_back(tied.interfaces[k].id);
        if (!tied.isMeshNode[k]) add(tied.interfaces[k], tiedShapes, 6 * Eigen::Index(k));
    }
}

}  // namespace

ModalBasis reduceToModes(const FiniteElementModel& model, const std::vector<InterfacePoint>& interfaces,
                         int numFixedModes) {
    checkFiniteElementModel(model);
    if (numFixedModes < 0)
        throw Error(model.name, fmt::format("{} fixed-interface modes are wanted", numFixedModes));
    const TiedStructure tied = tieInterfaces(model, interfaces);
    const SparseMatrix K = makeMatrix(model, model.stiffness, "stiffness");
    const SparseMatrix M = makeMatrix(model, model.mass, "mass");
    const Partition partition(tied, K, M);

    const MatrixXd T = interfaces.empty() ? makeFreeShapes(partition, numFixedModes, model.name)
                                          : makeCraigBamptonShapes(partition, numFixedModes, model.name);
    if (T.cols() <= 6) throw Error(model.name, "no modes are left; ask for a fixed-interface mode");
    FreeModes modes = solveWithoutRigidMotions(T, partition, tied.rigidMotions, model.name);
    checkFrequencies(modes.squaredFrequencies, model.name);
    fixSigns(modes.shapes);

    ModalBasis basis;
    basis.name = model.name;
    basis.rigid = calcRigidBodyProperties(model);
    for (const double square : modes.squaredFrequencies) basis.frequencies.push_back(std::sqrt(square));
    const MatrixXd meshShapes = tied.meshFromTied * modes.shapes;
    addNodes(model, tied, K, meshShapes, modes.shapes, basis);
    addInertiaCoupling(model, M, meshShapes, basis);
    return basis;
}

}  // namespace jprim
