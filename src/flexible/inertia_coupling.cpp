// SPDX-License-Identifier: Apache-2.0
// Integrals over the structure as products with its mass matrix. With H = M Phi, row by row the force with
// which the mass at a freedom answers to a mode,
//
//     Int(p_a phi_b dm) = Sum over nodes of p_a H_b                     (a, b: axes)
//     Int(phi_k x phi_l dm)_c = ~(e_c x Phi_k) H_l, made antisymmetric in k and l
//
// The first takes the mass between two nodes to be at them, which errs as the square of an element's length.
// Nodes' rotations enter the second like displacements: exact for the slopes of a beam's deflection, but
// a node's own rotary inertia is not told from them.
#include "flexible/inertia_coupling.h"

namespace jprim {

using Eigen::MatrixXd;
using SimTK::Mat33;
using SimTK::Vec3;

namespace {

Mat33 calcInertiaChange(const FiniteElementModel& model, const Vec3& center, const Eigen::VectorXd& H) {
    Mat33 B(0);
    for (size_t i = 0; i < model.nodes.size(); ++i) {
        const Eigen::Index row = Eigen::Index(i) * model.freedomsPerNode;
        B += SimTK::outer(model.nodes[i].position - center, Vec3(H[row], H[row + 1], H[row + 2]));
    }
    return 2 * B.trace() * Mat33(1) - B - ~B;
}

// e_c x each displacement and rotation of the shapes.
MatrixXd turn(int c, const MatrixXd& shapes) {
    const int next = (c + 1) % 3, last = (c + 2) % 3;
    MatrixXd turned = MatrixXd::Zero(shapes.rows(), shapes.cols());
    for (Eigen::Index row = 0; row < shapes.rows(); row += 3) {
        turned.row(row + next) = -shapes.row(row + last);
        turned.row(row + last) = shapes.row(row + next);
    }
    return turned;
}

}  // namespace

void addInertiaCoupling(const FiniteElementModel& model, const SparseMatrix& M, const MatrixXd& shapes,
                        ModalBasis& basis) {
    const int n = int(shapes.cols());
    const MatrixXd H = M * shapes;
    for (int k = 0; k < n; ++k)
        basis.inertiaChange.push_back(calcInertiaChange(model, basis.rigid.center, H.col(k)));

    basis.gyroscopic.assign(size_t(n * (n - 1) / 2), Vec3(0));
    for (int c = 0; c < 3; ++c) {
        const MatrixXd N = turn(c, shapes).transpose() * H;
        size_t at = 0;
        for (int k = 0; k < n; ++k)
            for (int l = k + 1; l < n; ++l) basis.gyroscopic[at++][c] = (N(k, l) - N(l, k)) / 2;
    }
}

}  // namespace jprim
