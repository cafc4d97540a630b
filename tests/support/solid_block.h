// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_SOLID_BLOCK_H_
#define JPRIM_TESTS_SUPPORT_SOLID_BLOCK_H_

#include <array>
#include <vector>

#include "jprim/flexible/finite_element_model.h"

namespace jprim::testing {

/// A steel block of eight-node bricks, three freedoms a node, with a corner at the origin: E = 2e11 Pa,
/// nu = 0.3, rho = 7800 kg/m^3, in SI. Node ids count from 1, z fastest.
struct SolidBlock {
    std::array<int, 3> elements{};
    FiniteElementModel model;

    int findNode(const std::array<int, 3>& at) const;
    /// All nodes whose place along an axis is `at`, counted from 0.
    std::vector<int> findFace(int axis, int at) const;
};

SolidBlock makeSolidBlock(const std::array<int, 3>& elements, const SimTK::Vec3& size);

}  // namespace jprim::testing

#endif
