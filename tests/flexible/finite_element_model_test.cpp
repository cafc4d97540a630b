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
               "beam: the stiffness matrix has a term that is not a number in row 0, column 0"},
        Damage{"Asymmetric",
               [](FiniteElementModel& m) {
                   m.stiffness.push_back({2, 8, 1e7});
               },
               "beam: the stiffness matrix is not symmetric: row 8, column 2 and its mirror image differ by "
               "-1e+07"},
        Damage{"NegativeDiagonal",
               [](FiniteElementModel& m) {
                   m.mass.push_back({4, 4, -1000});
               },
               "beam: the mass matrix has -1e+03 on its diagonal in row 4"},
        Damage{"IndefiniteStiffness",
               [](FiniteElementModel& m) {
                   m.stiffness.insert(m.stiffness.end(), {{0, 7, 1e9}, {7, 0, 1e9}});
               },
               "beam: the stiffness matrix is indefinite: 1e+09 in row 7, column 0 is more than its diagonal "
               "allows, 2.14e+07"},
        Damage{"IndefiniteMass",
               [](FiniteElementModel& m) {
                   m.mass.insert(m.mass.end(), {{1, 8, 50}, {8, 1, 50}});
               },
               "beam: the mass matrix is indefinite: 50 in row 8, column 1 is more than its diagonal "
               "allows, 1.24"},
        Damage{"Held",
               [](FiniteElementModel& m) {
                   m.stiffness.push_back({1, 1, 1e8});
               },
               "beam: the mesh is held: translation along y meets resistance; give it without supports"},
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
               "beam: no stiffness connects node 11 with node 1; the mesh is in pieces"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace jprim
