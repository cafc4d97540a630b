// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/reduce_to_modes.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "flexible/inertia_coupling.h"
#include "flexible/lowest_modes.h"
#include "flexible/node_rotations.h"
#include "flexible/tied_structure.h"
#include "jprim/base/error.h"
#include "linear_algebra/eigenvalues.h"
#include "linear_algebra/equations.h"
#include "linear_algebra/orthogonal.h"

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using SimTK::Vec3;

namespace {

/// The tied structure's matrices and their parts between interfaces (b) and interior (i).
struct Partition {
    Partition(const Structure& mesh, const TiedStructure& tied)
        : structure(mesh),
          meshFromTied(tied.meshFromTied),
          K(meshFromTied.transpose() * mesh.K.get() * meshFromTied),
          M(meshFromTied.transpose() * mesh.M.get() * meshFromTied) {
        const int b = tied.numInterfaceFreedoms, i = int(K.rows()) - b;
        K_ib = K.bottomLeftCorner(i, b);
        K_ii = K.bottomRightCorner(i, i);
        M_ii = M.bottomRightCorner(i, i);
    }

    // Of a motion of the interior, with all interfaces held, the motion of the mesh.
    VectorXd moveMesh(const VectorXd& interior) const {
        return meshFromTied.rightCols(interior.size()) * interior;
    }

    const Structure& structure;
    const SparseMatrix& meshFromTied;
    SparseMatrix K, M, K_ib, K_ii, M_ii;
};

const char* const WhatToLookFor =
    "supports need not be given, but a piece of the mesh must not hang loose, no term may have the wrong sign, and "
    "both matrices must be of this mesh and its order of freedoms";

// The request is compared with what there is before anything is made of it.
void checkNumModes(const Partition& p, int count, bool isFree) {
    const std::string& name = p.structure.model.name;
    if (count < 0) throw Error(name, fmt::format("{} modes are wanted; give 0 or more", count));
    const int freedoms = int(p.M_ii.rows()), rigid = isFree ? 6 : 0;
    const int withMass = int((p.M_ii.diagonal().array() > 0).count());
    const int most = std::max(0, std::min(withMass, calcMostModes(freedoms)) - rigid);
    if (count > most)
        throw Error(
            name,
            isFree
                ? fmt::format("{} modes are wanted, but the free mesh has {} at most, besides the six rigid "
                              "motions",
                              count, most)
                : fmt::format("{} fixed-interface modes are wanted, but with all interfaces held the mesh "
                              "has {} at most",
                              count, most));
    if (count + int(p.K_ib.cols()) <= 6 - rigid)
        throw Error(name, "no modes are left besides the six rigid motions; ask for one at least");
}

// T = [1 0; Psi phi]
MatrixXd makeCraigBamptonShapes(const Partition& p, int numFixedModes) {
    const Eigen::Index b = p.K_ib.cols(), i = p.K_ib.rows();
    const ShiftedStiffness interior(p.K_ii, p.M_ii, 0);
    if (!interior.isDefinite())
        p.structure.K.failIndefinite(p.moveMesh(findWeakestMotion(p.K_ii)),
                                     fmt::format(" with all interfaces held; {}", WhatToLookFor));
    MatrixXd T = MatrixXd::Zero(b + i, b + numFixedModes);
    T.topLeftCorner(b, b).setIdentity();
    T.bottomRightCorner(i, numFixedModes) =
        calcLowestModes(interior, p.M_ii, numFixedModes, p.structure.model.name);
    if (i > 0) T.bottomLeftCorner(i, b) = -interior.solve(MatrixXd(p.K_ib));
    return T;
}

// The lowest modes of the free structure, the six rigid ones among them. Its stiffness alone cannot be
// factored; adding M times a number well below any squared frequency but the rigid ones' makes it possible.
MatrixXd makeFreeShapes(const Partition& p, int numModes) {
    constexpr double Small = 1e-6;
    const double highest = p.K.diagonal().sum() / p.M.diagonal().sum();
    const ShiftedStiffness shifted(p.K, p.M, Small * highest);
    if (!shifted.isDefinite())
        p.structure.K.failIndefinite(p.moveMesh(findWeakestMotion(p.K)), fmt::format("; {}", WhatToLookFor));
    return calcLowestModes(shifted, p.M, numModes + 6, p.structure.model.name);
}

/// Free modes within the span of T.
struct FreeModes {
    VectorXd squaredFrequencies;
    MatrixXd shapes;
};

// Z spans what is M-orthogonal to the rigid motions: ~(T Z) M R = 0. The eigenproblem within Z then has no
// rigid solutions to be told from elastic ones.
FreeModes solveWithoutRigidMotions(const MatrixXd& T, const Partition& p, const RigidMotions& R) {
    const MatrixXd momenta = T.transpose() * (p.M * R);
    const MatrixXd Q = completeBasis(momenta);
    const MatrixXd TZ = T * Q.rightCols(T.cols() - 6);
    const MatrixXd K = TZ.transpose() * (p.K * TZ), M = TZ.transpose() * (p.M * TZ);
    if (!isPositiveDefinite(M))
        p.structure.M.fail(
            "is not positive definite; the interfaces may have no mass of their own, or a term is negative");
    const std::optional<Eigenvectors> solution = calcEigenvectors(K, M);
    if (!solution)
        p.structure.K.fail(
            "and the mass matrix have no modes that can be found; look for terms of very different "
            "sizes");
    return {solution->values, TZ * solution->vectors};
}

void checkFrequencies(const FreeModes& modes, const Partition& p) {
    constexpr double Zero = 1e-13;  // of the highest squared frequency: rounding
    const VectorXd& squares = modes.squaredFrequencies;
    const double highest = squares[squares.size() - 1];
    if (squares[0] > Zero * highest) return;
    const char* const what = squares[0] < -Zero * highest
                                 ? ": some motion has a negative stiffness"
                                 : ": a motion besides the six rigid ones meets no resistance";
    p.structure.K.failIndefinite(p.meshFromTied * modes.shapes.col(0),
                                 fmt::format("{}; {}", what, WhatToLookFor));
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

ModalBasis reduceStructure(const Structure& structure, const std::vector<InterfacePoint>& interfaces,
                           int numFixedModes) {
    const FiniteElementModel& model = structure.model;
    checkStructure(structure);
    const TiedStructure tied = tieInterfaces(model, interfaces);
    const Partition partition(structure, tied);
    checkNumModes(partition, numFixedModes, interfaces.empty());

    const MatrixXd T = interfaces.empty() ? makeFreeShapes(partition, numFixedModes)
                                          : makeCraigBamptonShapes(partition, numFixedModes);
    FreeModes modes = solveWithoutRigidMotions(T, partition, tied.rigidMotions);
    checkFrequencies(modes, partition);
    fixSigns(modes.shapes);

    ModalBasis basis;
    basis.name = model.name;
    basis.rigid = calcRigidBodyProperties(structure);
    for (const double square : modes.squaredFrequencies) basis.frequencies.push_back(std::sqrt(square));
    const MatrixXd meshShapes = tied.meshFromTied * modes.shapes;
    addNodes(model, tied, structure.K.get(), meshShapes, modes.shapes, basis);
    addInertiaCoupling(model, structure.M.get(), meshShapes, basis);
    return basis;
}

}  // namespace

ModalBasis reduceToModes(const FiniteElementModel& model, const std::vector<InterfacePoint>& interfaces,
                         int numFixedModes) {
    checkNodes(model);
    return reduceStructure(Structure(model), interfaces, numFixedModes);
}

ModalBasis reduceToModes(const FiniteElementMesh& mesh, const std::vector<InterfacePoint>& interfaces,
                         int numFixedModes) {
    checkNodes(mesh.model);
    return reduceStructure(Structure(mesh.model, mesh.files), interfaces, numFixedModes);
}

}  // namespace jprim
