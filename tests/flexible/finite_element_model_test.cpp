// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/finite_element_model.h"

#include <gtest/gtest.h>

#include <functional>

#include "support/expect_error.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using SimTK::Vec3;

//---------------------------------------------------------------------------- rigid-body properties
// rho A L; the middle; slender rod rho A L^3/12 about y and z (no rotary inertia), rho (I_y + I_z) L about x.
TEST(RigidBodyProperties, OfABeam) {
    const UniformBeam beam = testing::makeSteelBeam(4);
    const RigidBodyProperties rigid = calcRigidBodyProperties(makeFiniteElementModel(beam));
    const double mass = 7850 * 6e-4 * 2;
    EXPECT_NEAR(rigid.mass, mass, 1e-12);
    EXPECT_LT((rigid.center - Vec3(1, 0, 0)).norm(), 1e-12);
    EXPECT_NEAR(rigid.inertia(0, 0), 7850 * 6.5e-8 * 2, 1e-15);
    EXPECT_NEAR(rigid.inertia(1, 1), mass * 4 / 12, 1e-11);
    EXPECT_NEAR(rigid.inertia(2, 2), mass * 4 / 12, 1e-11);
    EXPECT_NEAR(rigid.inertia(0, 1), 0, 1e-11);
}

// Two lumps with three freedoms each: m1 m2/(m1 + m2) d^2 about axes across the line between them.
TEST(RigidBodyProperties, OfTwoLumps) {
    FiniteElementModel model;
    model.name = "dumb-bell";
    model.freedomsPerNode = 3;
    model.nodes = {{7, Vec3(1, 2, 3)}, {9, Vec3(1, 5, 7)}};
    for (int k = 0; k < 3; ++k) model.mass.insert(model.mass.end(), {{k, k, 2}, {3 + k, 3 + k, 3}});
    const RigidBodyProperties rigid = calcRigidBodyProperties(model);
    const Vec3 d(0, 3, 4);
    EXPECT_DOUBLE_EQ(rigid.mass, 5);
    EXPECT_LT((rigid.center - (Vec3(1, 2, 3) + 0.6 * d)).norm(), 1e-14);
    const SimTK::Mat33 expected = 1.2 * (SimTK::dot(d, d) * SimTK::Mat33(1) - SimTK::outer(d, d));
    EXPECT_LT((rigid.inertia - expected).norm(), 1e-13);
}

//-------------------------------------------------------------------------------------------- refusals
struct Damage {
    const char* name;
    std::function<void(FiniteElementModel&)> damage;
    const char* message;
};

std::ostream& operator<<(std::ostream& out, const Damage& d) {
    return out << d.name;
}

class DamagedModel : public ::testing::TestWithParam<Damage> {};

TEST_P(DamagedModel, IsRefusedNamingTheItem) {
    FiniteElementModel model = makeFiniteElementModel(testing::makeSteelBeam(4));
    checkFiniteElementModel(model);  // sound before
    GetParam().damage(model);
    EXPECT_EQ(testing::catchError([&] { checkFiniteElementModel(model); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Each, DamagedModel,
    ::testing::Values(
        Damage{"FourFreedoms", [](FiniteElementModel& m) { m.freedomsPerNode = 4; },
               "beam: a node has 4 freedoms; it must have 3 or 6"},
        Damage{"NoNodes", [](FiniteElementModel& m) { m.nodes.clear(); }, "beam: there are no nodes"},
        Damage{"NodeTwice", [](FiniteElementModel& m) { m.nodes[3].id = 2; }, "beam: node 2 is given twice"},
        Damage{"TermOutside",
               [](FiniteElementModel& m) {
                   m.mass.push_back({30, 0, 1});
               },
               "beam: the mass matrix has a term in row 30, column 0; 5 nodes with 6 freedoms have rows 0 to "
               "29"},
        Damage{"NotANumber", [](FiniteElementModel& m) { m.stiffness[0].value = SimTK::NaN; },
               "beam: the stiffness matrix has a term that is not a number in row 0, column 0 (node 1, x)"},
        Damage{"Asymmetric",
               [](FiniteElementModel& m) {
                   m.stiffness.push_back({2, 8, 1e7});
               },
               "beam: the stiffness matrix is not symmetric: row 2, column 8 (node 1, z and node 2, z) is "
               "9.5968e+06, its mirror image -403200; a file holds one triangle or both in full"},
        Damage{
            "NegativeDiagonal",
            [](FiniteElementModel& m) {
                m.mass.push_back({4, 4, -1000});
            },
            "beam: the mass matrix has -1e+03 on its diagonal in row 4 (node 1, rotation about y); a diagonal term is "
            "not negative"},
        Damage{
            "IndefiniteStiffness",
            [](FiniteElementModel& m) {
                m.stiffness.insert(m.stiffness.end(), {{0, 7, 1e9}, {7, 0, 1e9}});
            },
            "beam: the stiffness matrix is not positive definite: row 0, column 7 (node 1, x and node 2, y) is 1e+09, "
            "more than the diagonal terms of the row and the column allow, 2.14e+07; one of the three is wrong"},
        Damage{
            "IndefiniteMass",
            [](FiniteElementModel& m) {
                m.mass.insert(m.mass.end(), {{1, 8, 50}, {8, 1, 50}});
            },
            "beam: the mass matrix is not positive definite: row 1, column 8 (node 1, y and node 2, z) is 50, more "
            "than the diagonal terms of the row and the column allow, 1.24; one of the three is wrong"},
        Damage{
            "Held",
            [](FiniteElementModel& m) {
                m.stiffness.push_back({1, 1, 1e8});
            },
            "beam: the stiffness matrix meets a translation along y of the whole mesh with a force in row 1 (node 1, "
            "y); the mesh is supported there (give it without supports), or a term of that row is wrong or missing"},
        Damage{
            "HeldAgainstRotation",
            [](FiniteElementModel& m) {
                m.stiffness.push_back({27, 27, 10});
            },
            "beam: the stiffness matrix holds the mesh: rotation about x meets resistance; give it without supports"},
        Damage{
            "MovedNode", [](FiniteElementModel& m) { std::swap(m.nodes[1].position, m.nodes[2].position); },
            "beam: the stiffness matrix meets a rotation about z of the whole mesh with a force in row 1 (node 1, y); the mesh is supported there (give it without supports), or a term of that row is wrong or missing, or the nodes have other positions or another order"},
        Damage{
            "ZeroDiagonal",
            [](FiniteElementModel& m) {
                for (MatrixTerm& t : m.mass)
                    if (t.row == 7 && t.column == 7) t.value = 0;
            },
            "beam: the mass matrix is not positive definite: there is no mass on the diagonal in row 7 (node 2, y), but in other columns"},
        Damage{
            "MassOfOneDirection",
            [](FiniteElementModel& m) {
                m.mass.push_back({7, 7, 5});
            },
            "beam: the mass matrix has a total of 9.42 along x, 14.42 along y, 9.42 along z; they must be the same"},
        Damage{"NoMass", [](FiniteElementModel& m) { m.mass.clear(); },
               "beam: the mesh has no mass; give a density"},
        Damage{"InPieces",
               [](FiniteElementModel& m) {
                   const FiniteElementModel other = m;
                   for (const FiniteElementNode& node : other.nodes)
                       m.nodes.push_back({node.id + 10, node.position + Vec3(0, 1, 0)});
                   for (const MatrixTerm& t : other.stiffness)
                       m.stiffness.push_back({t.row + 30, t.column + 30, t.value});
                   for (const MatrixTerm& t : other.mass)
                       m.mass.push_back({t.row + 30, t.column + 30, t.value});
               },
               "beam: the stiffness matrix connects node 11 with node 1 by no term; the mesh is in pieces"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace jprim
