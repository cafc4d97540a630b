// SPDX-License-Identifier: Apache-2.0
// The gradient G that minimizes Sum |u_j - u_i - G s_j|^2, s_j = p_j - p_i, is
// G = Sum (u_j - u_i) ~s_j inv(Sum s_j ~s_j); the rotation is the axis of its antisymmetric part. Where the
// neighbours span only a plane or a line the pseudo-inverse leaves the rest of G at zero.
#include "flexible/node_rotations.h"

#include "linear_algebra/conversion.h"
#include "linear_algebra/orthogonal.h"

namespace jprim {

using SimTK::Vec3;

namespace {

std::vector<int> findNeighbours(const SparseMatrix& K, int node) {
    std::vector<int> neighbours;
    for (SparseMatrix::InnerIterator term(K, 3 * node); term; ++term) {
        const int other = int(term.row()) / 3;
        if (other != node && (neighbours.empty() || neighbours.back() != other)) neighbours.push_back(other);
    }
    return neighbours;
}

}  // namespace

void fitNodeRotations(const SparseMatrix& K, std::vector<ModalNode>& nodes) {
    for (int i = 0; i < int(nodes.size()); ++i) {
        ModalNode& node = nodes[i];
        const std::vector<int> neighbours = findNeighbours(K, i);
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        for (const int j : neighbours) {
            const Eigen::Vector3d s = toEigen(nodes[j].position - node.position);
            spread += s * s.transpose();
        }
        const Eigen::Matrix3d inverse = calcPseudoInverse(spread);
        for (size_t k = 0; k < node.translation.size(); ++k) {
            Eigen::Matrix3d G = Eigen::Matrix3d::Zero();
            for (const int j : neighbours)
                G += toEigen(nodes[j].translation[k] - node.translation[k]) *
                     toEigen(nodes[j].position - node.position).transpose();
            G *= inverse;
            node.rotation.push_back(Vec3(G(2, 1) - G(1, 2), G(0, 2) - G(2, 0), G(1, 0) - G(0, 1)) / 2);
        }
    }
}

}  // namespace jprim
