// SPDX-License-Identifier: Apache-2.0
// The trilinear brick with 2 x 2 x 2 Gauss points: K = Int(~B D B dV), M = Int(rho ~N N dV).
// Source: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 1, 2000, chapters 8 and 9.
#include "support/solid_block.h"

#include <Eigen/Dense>
#include <cmath>

namespace jprim::testing {

using SimTK::Vec3;

namespace {

struct BrickMatrices {
    Eigen::Matrix<double, 24, 24> stiffness = Eigen::Matrix<double, 24, 24>::Zero();
    Eigen::Matrix<double, 24, 24> mass = Eigen::Matrix<double, 24, 24>::Zero();
};

Eigen::Matrix<double, 6, 6> makeElasticity(double E, double nu) {
    Eigen::Matrix<double, 6, 6> D = Eigen::Matrix<double, 6, 6>::Zero();
    D.topLeftCorner<3, 3>().setConstant(nu);
    D.diagonal().head<3>().setConstant(1 - nu);
    D.diagonal().tail<3>().setConstant((1 - 2 * nu) / 2);
    return E / ((1 + nu) * (1 - 2 * nu)) * D;
}

// Corner c has its place along axis a at bit 2 - a of c.
int getSide(int corner, int axis) {
    return (corner >> (2 - axis)) & 1;
}

// Values and gradients of the eight shape functions at xi in [-1, 1]^3 of a brick with these edges.
void calcShapeFunctions(const Vec3& xi, const Vec3& edges, Eigen::Matrix<double, 8, 1>& N,
                        Eigen::Matrix<double, 8, 3>& gradient) {
    for (int c = 0; c < 8; ++c) {
        N[c] = 1;
        gradient.row(c).setOnes();
        for (int a = 0; a < 3; ++a) {
            const double sign = getSide(c, a) ? 1 : -1, factor = (1 + sign * xi[a]) / 2;
            N[c] *= factor;
            for (int b = 0; b < 3; ++b) gradient(c, b) *= a == b ? sign / edges[a] : factor;
        }
    }
}

BrickMatrices makeBrick(const Vec3& edges) {
    const Eigen::Matrix<double, 6, 6> D = makeElasticity(2e11, 0.3);
    const double weight = edges[0] * edges[1] * edges[2] / 8, density = 7800;
    BrickMatrices brick;
    for (int point = 0; point < 8; ++point) {
        Vec3 xi;
        for (int a = 0; a < 3; ++a) xi[a] = (getSide(point, a) ? 1 : -1) / std::sqrt(3.);
        Eigen::Matrix<double, 8, 1> N;
        Eigen::Matrix<double, 8, 3> g;
        calcShapeFunctions(xi, edges, N, g);
        Eigen::Matrix<double, 6, 24> B = Eigen::Matrix<double, 6, 24>::Zero();
        for (int c = 0; c < 8; ++c) {
            for (int a = 0; a < 3; ++a) B(a, 3 * c + a) = g(c, a);
            for (int a = 0; a < 3; ++a) {  // shear xy, yz, zx
                const int b = (a + 1) % 3;
                B(3 + a, 3 * c + a) = g(c, b);
                B(3 + a, 3 * c + b) = g(c, a);
            }
            for (int d = 0; d < 8; ++d)
                for (int a = 0; a < 3; ++a)
                    brick.mass(3 * c + a, 3 * d + a) += density * weight * N[c] * N[d];
        }
        brick.stiffness += weight * B.transpose() * D * B;
    }
    return brick;
}

}  // namespace

int SolidBlock::findNode(const std::array<int, 3>& at) const {
    return 1 + at[2] + (elements[2] + 1) * (at[1] + (elements[1] + 1) * at[0]);
}

std::vector<int> SolidBlock::findFace(int axis, int at) const {
    std::vector<int> nodes;
    for (int x = 0; x <= elements[0]; ++x)
        for (int y = 0; y <= elements[1]; ++y)
            for (int z = 0; z <= elements[2]; ++z)
                if (std::array{x, y, z}[axis] == at) nodes.push_back(findNode({x, y, z}));
    return nodes;
}

SolidBlock makeSolidBlock(const std::array<int, 3>& elements, const Vec3& size) {
    SolidBlock block;
    block.elements = elements;
    block.model.name = "block";
    block.model.freedomsPerNode = 3;
    const Vec3 edges(size[0] / elements[0], size[1] / elements[1], size[2] / elements[2]);
    for (int x = 0; x <= elements[0]; ++x)
        for (int y = 0; y <= elements[1]; ++y)
            for (int z = 0; z <= elements[2]; ++z)
                block.model.nodes.push_back(
                    {block.findNode({x, y, z}), Vec3(x * edges[0], y * edges[1], z * edges[2])});
    const BrickMatrices brick = makeBrick(edges);
    for (int x = 0; x < elements[0]; ++x)
        for (int y = 0; y < elements[1]; ++y)
            for (int z = 0; z < elements[2]; ++z) {
                int freedoms[24];
                for (int c = 0; c < 8; ++c)
                    for (int a = 0; a < 3; ++a)
                        freedoms[3 * c + a] =
                            3 * (block.findNode({x + getSide(c, 0), y + getSide(c, 1), z + getSide(c, 2)}) -
                                 1) +
                            a;
                for (int i = 0; i < 24; ++i)
                    for (int j = 0; j < 24; ++j) {
                        block.model.stiffness.push_back({freedoms[i], freedoms[j], brick.stiffness(i, j)});
                        if (brick.mass(i, j) != 0)
                            block.model.mass.push_back({freedoms[i], freedoms[j], brick.mass(i, j)});
                    }
            }
    return block;
}

}  // namespace jprim::testing
