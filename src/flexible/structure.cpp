// SPDX-License-Identifier: Apache-2.0
#include "flexible/structure.h"

#include <fmt/format.h>

#include <cmath>

#include "jprim/base/error.h"

namespace jprim {

using SimTK::Vec3;

SparseMatrix makeMatrix(const FiniteElementModel& model, const std::vector<MatrixTerm>& terms,
                        const char* what) {
    const int n = model.getNumFreedoms();
    std::vector<Eigen::Triplet<double>> triplets;
    triplets.reserve(terms.size());
    for (const MatrixTerm& term : terms) {
        if (term.row < 0 || term.row >= n || term.column < 0 || term.column >= n)
            throw Error(
                model.name,
                fmt::format("the {} matrix has a term in row {}, column {}; {} nodes with {} "
                            "freedoms have rows 0 to {}",
                            what, term.row, term.column, model.nodes.size(), model.freedomsPerNode, n - 1));
        if (!std::isfinite(term.value))
            throw Error(model.name,
                        fmt::format("the {} matrix has a term that is not a number in row {}, column {}",
                                    what, term.row, term.column));
        triplets.emplace_back(term.row, term.column, term.value);
    }
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

RigidMotions makeRigidMotionsOfNode(int freedoms, const Vec3& offset) {
    RigidMotions R = RigidMotions::Zero(freedoms, 6);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 w(0);
        w[axis] = 1;
        const Vec3 turned = w % offset;
        R(axis, axis) = 1;
        for (int k = 0; k < 3; ++k) R(k, 3 + axis) = turned[k];
        if (freedoms == 6) R(3 + axis, 3 + axis) = 1;
    }
    return R;
}

RigidMotions makeRigidMotions(const FiniteElementModel& model) {
    RigidMotions R(model.getNumFreedoms(), 6);
    for (int i = 0; i < int(model.nodes.size()); ++i)
        R.middleRows(i * model.freedomsPerNode, model.freedomsPerNode) =
            makeRigidMotionsOfNode(model.freedomsPerNode, model.nodes[i].position);
    return R;
}

}  // namespace jprim
