// SPDX-License-Identifier: Apache-2.0
// A block of bricks, one face tied to a point and clamped, under gravity switched on at rest: the Simbody
// system against modal superposition of the clamped mesh, with the same five modes and with all.
//
// The case is that of Exudyn's test abaqusImportTest.py (a block of 4 x 1 x 1 m, E = 2e11 Pa, nu = 0.3,
// 5 modes, the displacement of an edge after 5 ms), with bricks of our own.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "jprim/jprim.h"
#include "support/linearize.h"
#include "support/solid_block.h"

namespace jprim {
namespace {

using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

constexpr double Gravity = -9.81, Time = 5e-3;
constexpr int Modes = 5;

// u(t) = Sum phi (~phi M g)/w^2 (1 - cos w t) over the lowest modes of the mesh without its first face.
Vec3 superpose(const testing::SolidBlock& block, int node, int numModes) {
    const int n = block.model.getNumFreedoms(), held = 3 * int(block.findFace(0, 0).size());
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n), M = K;
    for (const MatrixTerm& t : block.model.stiffness) K(t.row, t.column) += t.value;
    for (const MatrixTerm& t : block.model.mass) M(t.row, t.column) += t.value;
    Eigen::VectorXd g = Eigen::VectorXd::Zero(n);
    for (int i = 1; i < n; i += 3) g[i] = Gravity;
    const Eigen::VectorXd load = (M * g).tail(n - held);  // nodes of the face come first
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        K.bottomRightCorner(n - held, n - held), M.bottomRightCorner(n - held, n - held));
    Vec3 u(0);
    for (int k = 0; k < numModes; ++k) {
        const Eigen::VectorXd phi = solver.eigenvectors().col(k);
        const double square = solver.eigenvalues()[k];
        const double q = phi.dot(load) / square * (1 - std::cos(std::sqrt(square) * Time));
        for (int axis = 0; axis < 3; ++axis) u[axis] += q * phi[3 * (node - 1) - held + axis];
    }
    return u;
}

TEST(FlexibleBlock, MovesAsModalSuperpositionSays) {
    constexpr double SameModes = 1e-4;  // rotations of 1e-5 rad are taken as finite ones
    constexpr double AllModes = 1e-2;   // what five modes leave out
    const testing::SolidBlock block = testing::makeSolidBlock({9, 3, 3}, Vec3(4, 1, 1));
    const int edge = block.findNode({9, 0, 0});
    const Transform face(Vec3(0, 0.5, 0.5));
    const ModalBasis basis = reduceToModes(block.model, {{block.findFace(0, 0), 0, face.p()}}, Modes);

    testing::FlexibleSystem s;
    SimTK::Force::Gravity(s.forces, s.matter, Vec3(0, Gravity, 0));
    const FlexibleBody body(s.matter, s.forces, basis,
                            {InertiaCoupling::Partial, std::vector<double>(Modes, 0.)});
    Joint::Fixed(Marker(body, basis.interfaces[0]), Marker(s.matter.Ground(), face));
    const State end = testing::integrate(s, s.system.realizeTopology(), Time, 1e-9, [](const State&) {});
    const Vec3 u = Marker(body, edge).findPoseInGround(end).p() - Vec3(4, 0, 0);

    const Vec3 same = superpose(block, edge, Modes), all = superpose(block, edge, 3 * 9 * 16);
    EXPECT_LT((u - same).norm(), SameModes * same.norm()) << u << same;
    EXPECT_LT((u - all).norm(), AllModes * all.norm()) << u << all;
}

}  // namespace
}  // namespace jprim
