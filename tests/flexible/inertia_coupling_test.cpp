// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "jprim/flexible/reduce_to_modes.h"
#include "support/solid_block.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using SimTK::Mat33;
using SimTK::Vec3;

// J_k is the derivative of the inertia of the deformed structure: masses of the block's nodes moved by the
// mode, lumped (row sums), which is exact for fields linear in space and converges for others.
TEST(InertiaCoupling, InertiaChangeIsTheDerivativeOfTheInertia) {
    const testing::SolidBlock block = testing::makeSolidBlock({3, 2, 2}, Vec3(3, 1.5, 1));
    const ModalBasis basis = reduceToModes(block.model, {{block.findFace(0, 0), 0, {}}}, 4);
    const int numNodes = int(block.model.nodes.size());
    for (int k = 0; k < basis.getNumModes(); ++k) {
        const auto calcInertia = [&](double q) {
            Mat33 inertia(0);
            const auto place = [&](int i) {
                return Vec3(basis.nodes[i].position - basis.rigid.center + q * basis.nodes[i].translation[k]);
            };
            for (const MatrixTerm& m : block.model.mass) {
                if (m.row % 3 != 0 || m.column % 3 != 0) continue;  // m_ij of node pairs, once
                const Vec3 a = place(m.row / 3), b = place(m.column / 3);
                inertia +=
                    m.value * (SimTK::dot(a, b) * Mat33(1) - (SimTK::outer(a, b) + SimTK::outer(b, a)) / 2);
            }
            return inertia;
        };
        const Mat33 derivative = (calcInertia(0.5) - calcInertia(-0.5)) / 1;
        EXPECT_LT((derivative - basis.inertiaChange[k]).norm(), 1e-9 * (1 + derivative.norm())) << k;
    }
    EXPECT_EQ(numNodes, 4 * 3 * 3);
}

// n_kl = Int(phi_k x phi_l dm) on node pairs; antisymmetric.
TEST(InertiaCoupling, GyroscopicTermsAreTheIntegrals) {
    const testing::SolidBlock block = testing::makeSolidBlock({3, 2, 2}, Vec3(3, 1.5, 1));
    const ModalBasis basis = reduceToModes(block.model, {{block.findFace(0, 0), 0, {}}}, 4);
    for (int k = 0; k < basis.getNumModes(); ++k)
        for (int l = 0; l < basis.getNumModes(); ++l) {
            Vec3 sum(0);
            for (const MatrixTerm& m : block.model.mass)
                if (m.row % 3 == 0 && m.column % 3 == 0)
                    sum += m.value * basis.nodes[m.row / 3].translation[k] %
                           basis.nodes[m.column / 3].translation[l];
            EXPECT_LT((sum - basis.getGyroscopic(k, l)).norm(), 1e-9) << k << " " << l;
            EXPECT_EQ(basis.getGyroscopic(k, l), -basis.getGyroscopic(l, k));
        }
}

// A beam's two lowest bending modes, in the planes of its weak and strong axis, have nearly the same shape:
// |n| = Int(phi_y phi_z dm) along x is near 1, and nothing else.
TEST(InertiaCoupling, BendingPairOfABeam) {
    const ModalBasis basis = reduceToModes(makeFiniteElementModel(testing::makeSteelBeam(20)), {}, 2);
    EXPECT_NEAR(std::abs(basis.gyroscopic[0][0]), 1, 1e-6);
    EXPECT_NEAR(basis.gyroscopic[0][1], 0, 1e-9);
    EXPECT_NEAR(basis.gyroscopic[0][2], 0, 1e-9);
}

}  // namespace
}  // namespace jprim
