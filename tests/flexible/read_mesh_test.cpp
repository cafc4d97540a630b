// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/read_mesh.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/format.h"
#include "jprim/flexible/reduce_to_modes.h"
#include "support/expect_error.h"
#include "support/mesh_folder.h"

namespace jprim {
namespace {

using Ids = std::vector<int>;
using SimTK::Mat33;
using SimTK::Vec3;

std::string getDataPath(const std::string& name) {
    return std::string(JPRIM_SOURCE_DIR) + "/tests/data/mesh/" + name;
}

void expectRigid(const FiniteElementModel& model, double mass, const Vec3& center, const Mat33& inertia) {
    const RigidBodyProperties rigid = calcRigidBodyProperties(model);
    EXPECT_NEAR(rigid.mass, mass, 1e-9 * mass);
    EXPECT_LT((rigid.center - center).norm(), 1e-9);
    EXPECT_LT((rigid.inertia - inertia).norm(), 1e-9 * mass);
}

//---------------------------------------------------------------------------------------------- CalculiX
// Trilinear shape functions hold all rigid motions: m (b^2 + c^2)/12 is exact.
TEST(ReadCalculixMesh, ABlockOfTwoElements) {
    const FiniteElementMesh mesh = readCalculixMesh(getDataPath("block.inp"));
    EXPECT_EQ(mesh.model.name, "block.inp");
    EXPECT_EQ(mesh.model.freedomsPerNode, 3);
    ASSERT_EQ(mesh.model.nodes.size(), 12u);  // without the reference node
    EXPECT_EQ(mesh.model.nodes[3].id, 41);
    EXPECT_EQ(mesh.model.nodes[3].position, Vec3(0, 1, 1));
    checkFiniteElementModel(mesh.model);
    const double mass = 7850 * 2;
    Mat33 inertia(mass / 6);
    inertia(1, 1) = inertia(2, 2) = mass * 5 / 12;
    expectRigid(mesh.model, mass, Vec3(1, 0.5, 0.5), inertia);
}

TEST(ReadCalculixMesh, SetsHoldNodesOfTheModelOnly) {
    const FiniteElementMesh mesh = readCalculixMesh(getDataPath("block.inp"));
    EXPECT_EQ(mesh.getNodeSet("left"), Ids({11, 21, 31, 41}));
    EXPECT_EQ(mesh.getNodeSet("RIGHT"), Ids({91, 101, 111, 121}));
    EXPECT_EQ(mesh.getNodeSet("Ends"), Ids({11, 21, 31, 41, 91, 101, 111, 121}));
    EXPECT_EQ(mesh.getNodeSet("Near"), Ids({11, 21, 31, 41, 51, 61, 71, 81}));
    EXPECT_EQ(mesh.getNodeSet("all").size(), 12u);
    EXPECT_EQ(testing::catchError([&] { mesh.getNodeSet("Reference"); }),
              "block.inp: the node set 'Reference' has no node of an element; it is empty, or its nodes are "
              "reference points or not defined");
    EXPECT_EQ(
        testing::catchError([&] { mesh.getNodeSet("Top"); }),
        "block.inp: there is no node set 'Top'; there are ALL, BODY, ENDS, FAR, LEFT, NEAR, REFERENCE, RIGHT");
    EXPECT_EQ(testing::catchError([] { FiniteElementMesh().getNodeSet("A"); }),
              ": there is no node set 'A'; the file has none");
}

// Integrals over the corner x + y + z < 1: of x^2 1/60, of x y 1/120.
TEST(ReadCalculixMesh, AQuadraticTetrahedron) {
    const FiniteElementMesh mesh = readCalculixMesh(getDataPath("tetrahedron.inp"));
    checkFiniteElementModel(mesh.model);
    Mat33 inertia(7850. / 80);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (i != j) inertia(i, j) = 7850. / 480;
    expectRigid(mesh.model, 7850. / 6, Vec3(0.25), inertia);
}

// Rows are taken as FILE.dof lists them: reversed here, in the list and in the matrices.
TEST(ReadCalculixMesh, RowsInAnyOrder) {
    const testing::MeshFolder folder;
    folder.write("lumps.inp", "*NODE\n1, 0, 0, 0\n2, 3, 0, 0\n");
    folder.write("lumps.dof", "2.3\n2.2\n2.1\n1.3\n1.2\n1.1\n");
    std::string diagonal;
    for (int i = 1; i <= 6; ++i) diagonal += fmt::format("{} {} {}\n", i, i, i <= 3 ? 2 : 1);
    folder.write("lumps.sti", diagonal + "3 6 -1.5D+00\n");
    folder.write("lumps.mas", diagonal);
    const FiniteElementModel model = readCalculixMesh(folder.getPath("lumps.inp")).model;
    EXPECT_EQ(model.nodes[0].id, 2);
    ASSERT_EQ(model.stiffness.size(), 8u);  // with the mirror image
    const MatrixTerm &term = model.stiffness[6], &mirror = model.stiffness[7];
    EXPECT_EQ(std::make_tuple(term.row, term.column, term.value), std::make_tuple(0, 3, -1.5));
    EXPECT_EQ(std::make_tuple(mirror.row, mirror.column, mirror.value), std::make_tuple(3, 0, -1.5));
    const RigidBodyProperties rigid = calcRigidBodyProperties(model);
    EXPECT_DOUBLE_EQ(rigid.mass, 3);
    EXPECT_LT((rigid.center - Vec3(2, 0, 0)).norm(), 1e-14);
}

//------------------------------------------------------------------------------------------------ Abaqus
// One bar along x; node 9 belongs to no element. The stiffness is full, the mass diagonal.
const char* const BarInp =
    "*NODE\n4, 2, 0, 0\n2, 1, 0, 0\n9, 0, 0, 0\n*ELEMENT, TYPE=T3D2, ELSET=BAR\n1, 4, 2\n";

std::string makeDiagonal(double value) {
    std::string text;
    for (int i = 1; i <= 6; ++i) text += fmt::format("{} {}  {:.6e}\n", i, i, value);
    return text;
}

FiniteElementModel readBar(const std::string& stiffness) {
    const testing::MeshFolder folder;
    const std::string inp = folder.write("bar.inp", BarInp);
    return readAbaqusMesh(inp, folder.write("K.mtx", stiffness), folder.write("M.mtx", makeDiagonal(2)))
        .model;
}

TEST(ReadAbaqusMesh, NodesOfElementsByRisingId) {
    const FiniteElementModel model = readBar(makeDiagonal(5));
    EXPECT_EQ(model.name, "bar.inp");
    ASSERT_EQ(model.nodes.size(), 2u);
    EXPECT_EQ(model.nodes[0].id, 2);
    EXPECT_EQ(model.nodes[1].id, 4);
    EXPECT_DOUBLE_EQ(calcRigidBodyProperties(model).center[0], 1.5);
}

TEST(ReadAbaqusMesh, FullMatrixOrEitherTriangle) {
    for (const char* terms : {"1 4 -5\n4 1 -5\n", "1 4 -5\r\n", "\n 4\t1 -5"}) {
        const FiniteElementModel model = readBar(makeDiagonal(5) + terms);
        ASSERT_EQ(model.stiffness.size(), 8u) << terms;
        double sum = 0;
        for (const MatrixTerm& t : model.stiffness) sum += t.row == t.column ? 0 : t.value * (t.row - 1.);
        EXPECT_DOUBLE_EQ(sum, -5 * (0 - 1.) - 5 * (3 - 1.)) << terms;
    }
}

//-------------------------------------------------------------------------------------------- refusals
struct Damage {
    const char* name;
    std::function<void(const testing::MeshFolder&)> damage;
    std::string message;
};

std::ostream& operator<<(std::ostream& out, const Damage& d) {
    return out << d.name;
}

class DamagedMesh : public ::testing::TestWithParam<Damage> {};

TEST_P(DamagedMesh, IsRefusedNamingTheItem) {
    const testing::MeshFolder folder;
    folder.copyMesh("block");
    readCalculixMesh(folder.getPath("block.inp"));  // sound before
    GetParam().damage(folder);
    EXPECT_EQ(folder.shorten(testing::catchError([&] { readCalculixMesh(folder.getPath("block.inp")); })),
              GetParam().message);
}

// Replaces the first occurrence.
auto replaceIn(const char* file, const char* old, const char* text) {
    return [=](const testing::MeshFolder& folder) {
        std::string content = folder.read(file);
        const std::size_t at = content.find(old);
        ASSERT_NE(at, std::string::npos);
        folder.write(file, content.replace(at, std::string(old).size(), text));
    };
}

auto append(const char* file, const char* text) {
    return [=](const testing::MeshFolder& folder) { folder.write(file, folder.read(file) + text); };
}

const std::string WrittenBy =
    "CalculiX writes it when it runs block.inp with a step *FREQUENCY, SOLVER=MATRIXSTORAGE";
const std::string NoSupports =
    "the file is cut short, or the mesh has supports or couplings, which it must not (*BOUNDARY, *EQUATION, *MPC, "
    "*TIE, *RIGID BODY)";

INSTANTIATE_TEST_SUITE_P(
    Each, DamagedMesh,
    ::testing::Values(
        Damage{"NoDof", [](const auto& folder) { std::filesystem::remove(folder.getPath("block.dof")); },
               "block.dof: cannot read the file; " + WrittenBy},
        Damage{"NoStiffness",
               [](const auto& folder) { std::filesystem::remove(folder.getPath("block.sti")); },
               "block.sti: cannot read the file; " + WrittenBy},
        Damage{"EmptyMass", [](const auto& folder) { folder.write("block.mas", ""); },
               "block.mas: the file is empty; " + WrittenBy},
        Damage{"DofText", replaceIn("block.dof", "21.1", "21,1"),
               "block.dof:4: '21,1' is not `node.direction` with a direction from 1 to 3"},
        Damage{"DofRotation", replaceIn("block.dof", "21.1", "21.4"),
               "block.dof:4: '21.4' is not `node.direction` with a direction from 1 to 3"},
        Damage{
            "OwnNodes", append("block.dof", "501.1\n"),
            "block.dof:37: node 501 is not in block.inp; CalculiX expands beams and shells and gives C3D8I "
            "elements nodes of their own, which is not supported; use other solids"},
        Damage{"Expanded", append("block.dof", "11.1\n"),
               "block.dof:37: node 11 appears a second time; CalculiX expands beams and shells, which is not "
               "supported; use solids"},
        Damage{"Held", replaceIn("block.dof", "21.1\n21.2\n21.3\n", "21.2\n"),
               "block.dof: node 21 is not free in x, z; " + NoSupports},
        Damage{"Clamped", replaceIn("block.dof", "11.1\n11.2\n11.3\n", ""),
               "block.dof: node 11 is not free in x, y, z; " + NoSupports},
        Damage{"HeldReference", append("block.dof", "500.1\n500.3\n"),
               "block.dof: node 500 is not free in y; " + NoSupports},
        Damage{"ValueText", replaceIn("block.sti", "4.9358974358974e+10", "4.93x"),
               "block.sti:1: '1 1  4.93x' is not `row column value`; " + WrittenBy},
        Damage{"ValueInfinite", replaceIn("block.sti", "4.9358974358974e+10", "inf"),
               "block.sti:1: '1 1  inf' is not `row column value`; " + WrittenBy},
        Damage{"LineCut", append("block.sti", "36 36"),
               "block.sti:523: '36 36' is not `row column value`; " + WrittenBy},
        Damage{"FourNumbers", append("block.sti", "36 36 1 2\n"),
               "block.sti:523: '36 36 1 2' is not `row column value`; " + WrittenBy},
        Damage{"TermTwice", append("block.sti", "2 2 5.\n"),
               "block.sti:523: row 2, column 2 stands here a second time, after line 3; take one out"},
        Damage{
            "TermOfTheOtherTriangle", append("block.sti", "2 1 1e9\n"),
            "block.sti:523: row 2, column 1 is below the diagonal, where only 1 of 482 terms are; the file must "
            "hold one triangle or both in full"},
        Damage{"Binary", [](const auto& folder) { folder.write("block.sti", std::string(8, '\0')); },
               "block.sti: the file is no plain text; " + WrittenBy},
        Damage{"RowWithFraction", append("block.sti", "36 1.5\n"),
               "block.sti:523: '36 1.5' is not `row column value`; " + WrittenBy},
        Damage{"RowOutside", append("block.mas", "37 1 5.\n"),
               "block.mas:523: row 37 is outside the matrix; the mesh has 12 nodes with rows 1 to 36"},
        Damage{"ColumnOutside", append("block.mas", "1 0 5.\n"),
               "block.mas:523: column 0 is outside the matrix; the mesh has 12 nodes with rows 1 to 36"},
        Damage{
            "FileCut",
            [](const auto& folder) { folder.write("block.mas", folder.read("block.mas").substr(0, 9000)); },
            "block.mas: there is no term in row 28, column 28; the file is cut short or belongs to another "
            "mesh"},
        Damage{
            "FileCutBetweenLines",
            [](const auto& folder) {
                const std::string text = folder.read("block.mas");
                folder.write("block.mas", text.substr(0, text.find("30 30")));
            },
            "block.mas: there is no term in row 30, column 30; the file is cut short or belongs to another "
            "mesh"}),
    [](const auto& info) { return std::string(info.param.name); });

// What the form allows and a free mesh does not have: the file, its own rows and lines.
TEST(ReduceMesh, NamesTheMatrixFileTheRowAndTheNode) {
    const auto expectError = [](const char* file, const char* old, const char* text,
                                const std::string& message) {
        const testing::MeshFolder folder;
        folder.copyMesh("block");
        replaceIn(file, old, text)(folder);
        const FiniteElementMesh mesh = readCalculixMesh(folder.getPath("block.inp"));
        EXPECT_EQ(folder.shorten(testing::catchError([&] { reduceToModes(mesh, {}, 3); })), message);
    };
    expectError(
        "block.sti", "2 2  ", "2 2  -",
        "block.sti:3: the stiffness matrix has -4.94e+10 on its diagonal in row 2 (node 11, y); a diagonal term is not negative");
    expectError(
        "block.sti", "1 2  ", "1 2  -",
        "block.sti: the stiffness matrix meets a translation along y of the whole mesh with a force in row 1 (node 11, x); the mesh is supported there (give it without supports), or a term of that row is wrong or missing");
    expectError(
        "block.sti", "1 2  ", "1 2  1",
        "block.sti:2: the stiffness matrix is not positive definite: row 1, column 2 (node 11, x and node 11, y) is 1.17e+11, more than the diagonal terms of the row and the column allow, 4.94e+10; one of the three is wrong");
    expectError(
        "block.mas", "2 2  ", "2 2  -",
        "block.mas:3: the mass matrix has -291 on its diagonal in row 2 (node 11, y); a diagonal term is not negative");
    expectError(
        "block.mas", "1 4  ", "1 4  -",
        "block.mas: the mass matrix has 690.509 along x as the sum of row 1 (node 11, x), not 981.25; a node has the same mass in x, y and z, and a term of the row is wrong or missing");
    expectError(
        "block.dof", "11.1\n11.2\n", "11.2\n11.1\n",
        "block.sti: the stiffness matrix meets a translation along x of the whole mesh with a force in row 2 (node 11, x); the mesh is supported there (give it without supports), or a term of that row is wrong or missing");
}

TEST(ReadAbaqusMesh, RefusesAnotherFormatOfMatrices) {
    EXPECT_EQ(
        testing::catchError([] { readBar("1,1, 1,1, 5.0\n"); }).substr(::testing::TempDir().size()),
        "jprim_ReadAbaqusMesh_RefusesAnotherFormatOfMatrices/K.mtx:1: '1,1, 1,1, 5.0' is not `row column "
        "value`; Abaqus writes it in a step with *MATRIX GENERATE, STIFFNESS, MASS and *MATRIX OUTPUT, "
        "STIFFNESS, MASS, FORMAT=COORDINATE");
}

}  // namespace
}  // namespace jprim
