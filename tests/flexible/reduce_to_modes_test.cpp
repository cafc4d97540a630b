// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/reduce_to_modes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/format.h"
#include "jprim/flexible/beam.h"
#include "support/expect_error.h"
#include "support/solid_block.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using SimTK::Vec3;
using testing::makeSteelBeam;

// Modal mass and orthogonality are met to rounding; the largest numbers on the way are stiffnesses.
constexpr double RoundingTolerance = 1e-8;
// Two ways to solve the same eigenproblem.
constexpr double EigenTolerance = 1e-7;

InterfacePoint makePoint(int node) {
    return {{node}, 0, std::nullopt};
}

FiniteElementModel makeBeamModel(int elements) {
    return makeFiniteElementModel(makeSteelBeam(elements));
}

double multiply(const FiniteElementModel& model, const ModalBasis& basis, int k, int l) {
    const auto get = [&](int mode, int freedom) {
        const ModalNode& node = basis.nodes[freedom / model.freedomsPerNode];
        const int axis = freedom % model.freedomsPerNode;
        return axis < 3 ? node.translation[mode][axis] : node.rotation[mode][axis - 3];
    };
    double sum = 0;
    for (const MatrixTerm& m : model.mass) sum += get(k, m.row) * m.value * get(l, m.column);
    return sum;
}

// ~phi_k M phi_l = 1 or 0, and ~R M phi_k = 0 for the rigid motions R about the mass centre.
void expectOrthonormal(const FiniteElementModel& model, const ModalBasis& basis) {
    ModalBasis withRigid = basis;
    for (ModalNode& node : withRigid.nodes)
        for (int axis = 0; axis < 6; ++axis) {
            Vec3 e(0);
            e[axis % 3] = 1;
            node.translation.push_back(axis < 3 ? e : e % (node.position - basis.rigid.center));
            node.rotation.push_back(axis < 3 ? Vec3(0) : e);
        }
    const int n = basis.getNumModes();
    for (int k = 0; k < n; ++k)
        for (int l = 0; l < n + 6; ++l)
            EXPECT_NEAR(multiply(model, withRigid, k, l), k == l ? 1 : 0, RoundingTolerance) << k << " " << l;
}

//--------------------------------------------------------------------------------------- properties
TEST(ReduceToModes, ModesAreOrthonormalAndFree) {
    const FiniteElementModel beam = makeBeamModel(6);
    expectOrthonormal(beam, reduceToModes(beam, {makePoint(1), makePoint(7)}, 5));
    expectOrthonormal(beam, reduceToModes(beam, {makePoint(4)}, 8));
    expectOrthonormal(beam, reduceToModes(beam, {}, 9));
    const testing::SolidBlock block = testing::makeSolidBlock({3, 2, 2}, Vec3(3, 1.5, 1));
    expectOrthonormal(block.model, reduceToModes(block.model, {{block.findFace(0, 0), 0, {}}}, 7));
}

// The suite must notice a basis that is not: a shape 1 % too large, a rigid motion added to one.
TEST(ReduceToModes, TheCheckRefusesMutants) {
    const FiniteElementModel beam = makeBeamModel(4);
    const ModalBasis good = reduceToModes(beam, {makePoint(1)}, 4);
    ModalBasis large = good, moved = good;
    for (ModalNode& node : large.nodes) {
        node.translation[2] *= 1.01;
        node.rotation[2] *= 1.01;
    }
    for (ModalNode& node : moved.nodes) node.translation[1] += Vec3(0, 0.01, 0);
    EXPECT_NEAR(multiply(beam, large, 2, 2), 1.0201, RoundingTolerance);
    EXPECT_GT(std::abs(multiply(beam, moved, 1, 1) - 1), 1e3 * RoundingTolerance);
}

TEST(ReduceToModes, CountsModes) {
    const FiniteElementModel beam = makeBeamModel(6);
    EXPECT_EQ(reduceToModes(beam, {makePoint(1), makePoint(7)}, 5).getNumModes(), 2 * 6 + 5 - 6);
    EXPECT_EQ(reduceToModes(beam, {makePoint(1)}, 1).getNumModes(), 1);
    EXPECT_EQ(reduceToModes(beam, {}, 3).getNumModes(), 3);
}

// With all fixed-interface modes nothing is lost, wherever the interfaces are.
TEST(ReduceToModes, AllModesGiveTheFrequenciesOfTheMesh) {
    const FiniteElementModel beam = makeBeamModel(5);
    const ModalBasis free = reduceToModes(beam, {}, 30);
    const ModalBasis ends = reduceToModes(beam, {makePoint(1), makePoint(6)}, 24);
    ASSERT_EQ(free.getNumModes(), 30);
    ASSERT_EQ(ends.getNumModes(), 30);
    for (int k = 0; k < 30; ++k)
        EXPECT_NEAR(ends.frequencies[k] / free.frequencies[k], 1, EigenTolerance) << k;
}

// cos(bL) cosh(bL) = 1, first root (Blevins, Formulas for Natural Frequency and Mode Shape, 1979, table 8-1).
// A few fixed-interface modes give it; Craig and Bampton's frequencies come from above.
TEST(ReduceToModes, FewModesComeNearFromAbove) {
    const UniformBeam beam = makeSteelBeam(20);
    const FiniteElementModel model = makeFiniteElementModel(beam);
    const double exact = std::pow(4.730040744862704 / beam.length, 2) *
                         std::sqrt(beam.youngsModulus * beam.secondMomentY / (beam.density * beam.area));
    const std::pair<int, double> cases[] = {{8, 1.0001}, {4, 1.01}, {0, 1.3}};  // modes, frequency at most
    double previous = 1;
    for (const auto& [modes, most] : cases) {
        const double ratio =
            reduceToModes(model, {makePoint(1), makePoint(21)}, modes).frequencies[0] / exact;
        EXPECT_GT(ratio, previous) << modes;
        EXPECT_LT(ratio, most) << modes;
        previous = ratio;
    }
}

// The lowest modes come from Lanczos' iteration above 400 freedoms and from a dense solver below.
TEST(ReduceToModes, SparseAndDenseSolversAgree) {
    const FiniteElementModel model = makeBeamModel(90);  // 546 freedoms
    const ModalBasis sparse = reduceToModes(model, {}, 12), dense = reduceToModes(model, {}, 200);
    for (int k = 0; k < 12; ++k)
        EXPECT_NEAR(sparse.frequencies[k] / dense.frequencies[k], 1, EigenTolerance) << k;
}

// A straight beam's shapes at its tips: a node of the mesh and the same point reached as an interface with an
// offset move together as one rigid piece.
TEST(ReduceToModes, AnInterfacePointMovesRigidlyWithItsNodes) {
    const FiniteElementModel beam = makeBeamModel(4);
    const Vec3 offset(0.1, 0.2, -0.3);
    const ModalBasis basis = reduceToModes(beam, {{{5}, 77, beam.nodes[4].position + offset}}, 6);
    ASSERT_EQ(basis.interfaces, std::vector<int>{77});
    const ModalNode &node = basis.getNode(5), &point = basis.getNode(77);
    for (int k = 0; k < basis.getNumModes(); ++k) {
        EXPECT_LT((point.rotation[k] - node.rotation[k]).norm(), RoundingTolerance);
        EXPECT_LT((point.translation[k] - node.translation[k] - node.rotation[k] % offset).norm(),
                  RoundingTolerance);
    }
}

TEST(ReduceToModes, ChoosesIds) {
    const testing::SolidBlock block = testing::makeSolidBlock({2, 1, 1}, Vec3(2, 1, 1));
    const int next = int(block.model.nodes.size()) + 1;
    const ModalBasis basis =
        reduceToModes(block.model, {{block.findFace(0, 0), 0, {}}, {block.findFace(0, 2), 500, {}}}, 1);
    EXPECT_EQ(basis.interfaces, (std::vector<int>{501, 500}));
    EXPECT_EQ(next, 13);
    EXPECT_LT((basis.getNode(501).position - Vec3(0, 0.5, 0.5)).norm(), 1e-15);
}

// Nodes of a solid have no rotations of their own; those fitted to the nodes around follow a rigid turn and
// the bending of a beam: at the tip of the first bending mode the slope over the deflection is 4.65/L from
// the beam's mode shape, here to 5 % because the block is stout.
TEST(ReduceToModes, NodesOfASolidTurnWithTheirSurroundings) {
    const testing::SolidBlock block = testing::makeSolidBlock({24, 2, 2}, Vec3(12, 1, 1));
    const ModalBasis basis = reduceToModes(block.model, {}, 4);
    const ModalNode& tip = basis.getNode(block.findNode({24, 1, 1}));
    const Vec3 u = tip.translation[0], w = tip.rotation[0];
    const Vec3 slope = SimTK::cross(Vec3(1, 0, 0), u) / u.norm();  // the turn that continues the deflection
    EXPECT_NEAR(SimTK::dot(w, slope) / u.norm() * 12, 4.65, 0.05 * 4.65);
}

//------------------------------------------------------------------------------------------- refusals
struct Refusal {
    const char* name;
    std::function<void()> reduce;
    const char* message;
};

std::ostream& operator<<(std::ostream& out, const Refusal& r) {
    return out << r.name;
}

class RefusedReduction : public ::testing::TestWithParam<Refusal> {};

TEST_P(RefusedReduction, NamesTheItem) {
    EXPECT_EQ(testing::catchError(GetParam().reduce), GetParam().message);
}

void reduceBeam(const std::vector<InterfacePoint>& interfaces, int modes) {
    reduceToModes(makeBeamModel(3), interfaces, modes);
}

void reduceBlock(const std::vector<InterfacePoint>& interfaces) {
    reduceToModes(testing::makeSolidBlock({2, 1, 1}, Vec3(2, 1, 1)).model, interfaces, 1);
}

INSTANTIATE_TEST_SUITE_P(
    Each, RefusedReduction,
    ::testing::Values(
        Refusal{"EmptySet",
                [] {
                    reduceBeam({{{}, 0, {}}}, 1);
                },
                "beam: interface 1: it has no nodes"},
        Refusal{"UnknownNode",
                [] {
                    reduceBeam({makePoint(1), makePoint(9)}, 1);
                },
                "beam: interface 2: the mesh has no node 9"},
        Refusal{"SharedNode",
                [] {
                    reduceBeam({makePoint(2), {{3, 2}, 0, {}}}, 1);
                },
                "beam: interface 2: node 2 belongs to interface 1 already"},
        Refusal{"IdOfANode",
                [] {
                    reduceBeam({{{1, 2}, 4, {}}}, 1);
                },
                "beam: interface 1: its id 4 is that of a node"},
        Refusal{"IdTwice",
                [] {
                    reduceBeam({{{1}, 10, {}}, {{2}, 10, {}}}, 1);
                },
                "beam: interface 2: its id 10 is that of another interface"},
        Refusal{"SingleNodeOfASolid", [] { reduceBlock({makePoint(1)}); },
                "block: interface 1: its nodes lie on one line, and nodes of a solid mesh have no rotations; "
                "name three or more that do not"},
        Refusal{"CollinearNodes",
                [] {
                    reduceBlock({{{1, 5, 9}, 0, {}}});
                },
                "block: interface 1: its nodes lie on one line, and nodes of a solid mesh have no rotations; "
                "name three or more that do not"},
        Refusal{
            "TooManyModes", [] { reduceBeam({makePoint(1)}, 19); },
            "beam: 19 fixed-interface modes are wanted, but with all interfaces held the mesh has 18 at most"},
        Refusal{"TooManyFreeModes", [] { reduceBeam({}, 19); },
                "beam: 19 modes are wanted, but the free mesh has 18 at most, besides the six rigid motions"},
        Refusal{"FarTooManyModes", [] { reduceBeam({}, 2147483647); },
                "beam: 2147483647 modes are wanted, but the free mesh has 18 at most, besides the six rigid "
                "motions"},
        Refusal{"NegativeModes", [] { reduceBeam({makePoint(1)}, -1); },
                "beam: -1 modes are wanted; give 0 or more"},
        Refusal{"NoModes", [] { reduceBeam({makePoint(1)}, 0); },
                "beam: no modes are left besides the six rigid motions; ask for one at least"},
        Refusal{
            "Mechanism",
            [] {
                // Two beams with a ball between the end of one and the start of the other.
                FiniteElementModel model = makeBeamModel(2);
                const FiniteElementModel other = model;
                for (const FiniteElementNode& node : other.nodes)
                    model.nodes.push_back({node.id + 3, node.position + Vec3(2, 0, 0)});
                for (const MatrixTerm& t : other.stiffness)
                    model.stiffness.push_back({t.row + 18, t.column + 18, t.value});
                for (const MatrixTerm& t : other.mass)
                    model.mass.push_back({t.row + 18, t.column + 18, t.value});
                for (int a = 12; a < 15; ++a)
                    for (const auto& [i, j] : {std::pair(a, a), {a, a + 6}, {a + 6, a}, {a + 6, a + 6}})
                        model.stiffness.push_back({i, j, i == j ? 1e8 : -1e8});
                reduceToModes(model, {makePoint(1)}, 2);
            },
            "beam: the stiffness matrix is not positive definite around row 27 (node 5, rotation about x) with all "
            "interfaces held; supports need not be given, but a piece of the mesh must not hang loose, no term may "
            "have the wrong sign, and both matrices must be of this mesh and its order of freedoms"}),
    [](const auto& info) { return std::string(info.param.name); });

// A spring of negative stiffness, or a mass that resists relative motion negatively, between two nodes: in balance
// in every row, so that only the whole tells.
void addNegativeLink(std::vector<MatrixTerm>& terms, int i, int j, const Vec3& direction, double size) {
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            for (const auto& [p, q] : {std::pair(i, i), {i, j}, {j, i}, {j, j}})
                terms.push_back(
                    {3 * p + a, 3 * q + b, (p == q ? -size : size) * direction[a] * direction[b]});
}

TEST(ReduceToModes, NamesANodeOfAnIndefiniteMatrix) {
    const testing::SolidBlock block = testing::makeSolidBlock({4, 2, 2}, Vec3(4, 2, 2));
    const int i = block.findNode({1, 1, 1}) - 1, j = block.findNode({3, 1, 1}) - 1;
    const std::string nearFirst = fmt::format("(node {}, ", i + 1),
                      nearSecond = fmt::format("(node {}, ", j + 1);
    const auto expectNamed = [&](const FiniteElementModel& model, bool isHeld, const std::string& begin) {
        std::vector<InterfacePoint> points;
        if (isHeld) points.push_back({block.findFace(0, 0), 0, std::nullopt});
        const std::string message = testing::catchError([&] { reduceToModes(model, points, 4); });
        EXPECT_EQ(message.rfind(begin, 0), 0u) << message;
        EXPECT_TRUE(message.find(nearFirst) != message.npos || message.find(nearSecond) != message.npos)
            << message;
    };
    FiniteElementModel soft = block.model, light = block.model;
    addNegativeLink(soft.stiffness, i, j, Vec3(1, 0, 0), 1.7e11);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 e(0);
        e[axis] = 1;
        addNegativeLink(light.mass, i, j, e, 1100);
    }
    for (const bool isHeld : {false, true}) {
        expectNamed(soft, isHeld, "block: the stiffness matrix is not positive definite around row ");
        expectNamed(light, isHeld, "block: the mass matrix is not positive definite around row ");
    }
}

}  // namespace
}  // namespace jprim
