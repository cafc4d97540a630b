// SPDX-License-Identifier: Apache-2.0
// Input files of Abaqus and CalculiX, without the matrices.
#include "flexible/mesh_definition.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/mesh_folder.h"

namespace jprim {
namespace {

using Ids = std::vector<int>;
using SimTK::Vec3;

MeshDefinition readText(const std::string& text) {
    const testing::MeshFolder folder;
    return readMeshDefinition(folder.write("mesh.inp", text));
}

// Four nodes and two bars.
const char* const Square =
    "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n"
    "*ELEMENT, TYPE=T3D2, ELSET=BARS\n7, 1, 2\n8, 2, 3\n";

//------------------------------------------------------------------------------------ nodes and elements
TEST(MeshDefinition, KeywordsInAnyCaseWithBlanksAndComments) {
    const MeshDefinition mesh = readText(
        "** by hand\r\n*Heading\r\nany, text = here\r\n\r\n  *node , nSet = \"all nodes\"\r\n"
        "** first\r\n 1 , +1.5,-2e-1 , .5D+01\r\n2,,3d0\r\n*Node Print, NSET=ALL\r\nU\r\n");
    ASSERT_EQ(mesh.nodes.size(), 2u);
    EXPECT_EQ(mesh.nodes.at(1), Vec3(1.5, -0.2, 5));
    EXPECT_EQ(mesh.nodes.at(2), Vec3(0, 3, 0));
    EXPECT_EQ(mesh.nodeSets.at("ALL NODES"), Ids({1, 2}));
}

TEST(MeshDefinition, AKeywordLineMayGoOnAfterAComma) {
    const MeshDefinition mesh = readText("*NODE,\n NSET=ALL\n1, 0, 0, 0\n*NSET, NSET=ONE,\n1\n");
    EXPECT_EQ(mesh.nodeSets.at("ALL"), Ids({1}));
    EXPECT_EQ(mesh.nodeSets.at("ONE"), Ids({1}));
}

// A solid's lines end when it has its nodes, with or without commas; another element's without a comma.
TEST(MeshDefinition, ElementsGoOnOverSeveralLines) {
    std::string text = "*NODE\n";
    for (int i = 1; i <= 20; ++i) text += std::to_string(i) + ", 0, 0, 0\n";
    const MeshDefinition mesh = readText(
        text +
        "*ELEMENT, TYPE=C3D20R\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15\n"
        "16, 17, 18, 19, 20\n2, 20, 19, 18, 17, 16, 15, 14, 13, 12, 11,\n10, 9, 8, 7, 6,\n5, 4, 3, 2, 1,\n"
        "*ELEMENT, TYPE=C3D4\n3, 1, 2, 3, 4,\n4, 2, 3, 4, 5\n*ELEMENT, TYPE=S6\n5, 1, 2, 3,\n4, 5, 6\n");
    ASSERT_EQ(mesh.elements.size(), 5u);
    EXPECT_EQ(mesh.elements.at(1).size(), 20u);
    EXPECT_EQ(mesh.elements.at(1)[15], 16);
    EXPECT_EQ(mesh.elements.at(2).size(), 20u);
    EXPECT_EQ(mesh.elements.at(2).back(), 1);
    EXPECT_EQ(mesh.elements.at(4), Ids({2, 3, 4, 5}));
    EXPECT_EQ(mesh.elements.at(5), Ids({1, 2, 3, 4, 5, 6}));
}

// A file may include another within a block, and a path counts from the file it stands in.
TEST(MeshDefinition, IncludesOtherFiles) {
    const testing::MeshFolder folder;
    folder.write("parts/nodes.txt", "1, 1, 2, 3\n*INCLUDE, INPUT=more/nodes.txt\n");
    folder.write("parts/more/nodes.txt", "2, 4, 5, 6\n");
    const MeshDefinition mesh = readMeshDefinition(
        folder.write("mesh.inp", "*NODE, NSET=ALL\n*Include, input=parts/nodes.txt\n3, 7, 8, 9\n"));
    EXPECT_EQ(mesh.nodes.at(2), Vec3(4, 5, 6));
    EXPECT_EQ(mesh.nodeSets.at("ALL"), Ids({1, 2, 3}));
}

//-------------------------------------------------------------------------------------------------- sets
TEST(MeshDefinition, SetsListNumbersRangesAndOtherSets) {
    const MeshDefinition mesh = readText(std::string(Square) +
                                         "*NSET, NSET=a\n4, 1,\n1\n*NSET, NSET=ODD, GENERATE\n1, 3, 2\n"
                                         "*NSET, NSET=Both\nA, odd, 2\n*NSET, NSET=A\n2\n"
                                         "*NSET, NSET=RANGES, GENERATE\n1, 2\n4, 4, 1\n");
    EXPECT_EQ(mesh.nodeSets.at("A"), Ids({1, 2, 4}));
    EXPECT_EQ(mesh.nodeSets.at("ODD"), Ids({1, 3}));
    EXPECT_EQ(mesh.nodeSets.at("BOTH"), Ids({1, 2, 3, 4}));
    EXPECT_EQ(mesh.nodeSets.at("RANGES"), Ids({1, 2, 4}));
}

TEST(MeshDefinition, AnElementSetIsASetOfNodesUnlessItsNameIsTaken) {
    const MeshDefinition mesh = readText(std::string(Square) +
                                         "*ELSET, ELSET=LAST, GENERATE\n8, 9\n*ELSET, ELSET=AGAIN\nlast\n"
                                         "*ELSET, ELSET=TAKEN\n7\n*NSET, NSET=TAKEN\n4\n"
                                         "*NSET, NSET=DERIVED, ELSET=LAST\n");
    EXPECT_EQ(mesh.nodeSets.at("BARS"), Ids({1, 2, 3}));
    EXPECT_EQ(mesh.nodeSets.at("LAST"), Ids({2, 3}));
    EXPECT_EQ(mesh.nodeSets.at("AGAIN"), Ids({2, 3}));
    EXPECT_EQ(mesh.nodeSets.at("TAKEN"), Ids({4}));
    EXPECT_EQ(mesh.nodeSets.at("DERIVED"), Ids({2, 3}));
}

//---------------------------------------------------------------------------------------------- assembly
// The assembly's own node 1 is a reference point; its set SAME hides the part's.
TEST(MeshDefinition, OneInstanceOfAPart) {
    const MeshDefinition mesh =
        readText("*Part, name=Bar\n" + std::string(Square) +
                 "*Nset, nset=Same\n1\n*Nset, nset=Tip\n3\n*End Part\n*Assembly, name=Assembly\n"
                 "*Instance, name=Bar-1, part=Bar\n10., 20., 30.\n*End Instance\n*Node\n1, 9, 9, 9\n"
                 "*Nset, nset=Point\n1\n*Nset, nset=Same, instance=Bar-1\n2\n"
                 "*Nset, nset=Mixed\n1, Bar-1.4, Bar-1.Tip, Same\n*Nset, nset=Bars, instance=BAR-1\n4\n"
                 "*End Assembly\n");
    ASSERT_EQ(mesh.nodes.size(), 4u);
    EXPECT_EQ(mesh.nodes.at(1), Vec3(10, 20, 30));
    EXPECT_EQ(mesh.nodeSets.at("POINT"), Ids());
    EXPECT_EQ(mesh.nodeSets.at("SAME"), Ids({2}));
    EXPECT_EQ(mesh.nodeSets.at("BAR-1.SAME"), Ids({1}));
    EXPECT_EQ(mesh.nodeSets.at("TIP"), Ids({3}));
    EXPECT_EQ(mesh.nodeSets.at("MIXED"), Ids({2, 3, 4}));
    EXPECT_EQ(mesh.nodeSets.at("BARS"), Ids({4}));
    EXPECT_EQ(mesh.nodeSets.at("BAR-1.BARS"), Ids({1, 2, 3}));
}

TEST(MeshDefinition, AnInstanceMayHoldTheMeshItself) {
    const MeshDefinition mesh =
        readText("*Part, name=Bar\n*End Part\n*Assembly\n*Instance, name=I, part=Bar\n" +
                 std::string(Square) + "*End Instance\n*End Assembly\n");
    EXPECT_EQ(mesh.nodes.size(), 4u);
    EXPECT_EQ(mesh.nodeSets.at("BARS"), Ids({1, 2, 3}));
}

//-------------------------------------------------------------------------------------------- refusals
struct BadFile {
    const char* name;
    const char* text;
    const char* message;
};

std::ostream& operator<<(std::ostream& out, const BadFile& file) {
    return out << file.name;
}

class BadInputFile : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadInputFile, IsRefusedNamingTheLine) {
    const testing::MeshFolder folder;
    const std::string path = folder.write("mesh.inp", GetParam().text);
    EXPECT_EQ(folder.shorten(testing::catchError([&] { readMeshDefinition(path); })), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadInputFile,
    ::testing::Values(
        BadFile{"Empty", "", "mesh.inp: the file is empty; check its name and permissions"},
        BadFile{"NoNodes", "*HEADING\n1, 2\n", "mesh.inp: there are no nodes; *NODE defines them"},
        BadFile{"NodeId", "*NODE\n1.5, 0, 0, 0\n", "mesh.inp:2: '1.5' is not a node's id"},
        BadFile{"NegativeId", "*NODE\n-1, 0, 0, 0\n", "mesh.inp:2: '-1' is not a node's id"},
        BadFile{"LargeId", "*NODE\n3000000000, 0\n", "mesh.inp:2: '3000000000' is not a node's id"},
        BadFile{"Coordinate", "*NODE\n1, 0, x, 0\n", "mesh.inp:2: 'x' is not a number"},
        BadFile{"TwoExponents", "*NODE\n1, 1D5E2\n", "mesh.inp:2: '1D5E2' is not a number"},
        BadFile{"NotFinite", "*NODE\n1, nan\n", "mesh.inp:2: 'nan' is not a number"},
        BadFile{"ElementId", "*NODE\n1\n*ELEMENT, TYPE=T3D2\nA, 1, 1\n",
                "mesh.inp:4: 'A' is not an element's id"},
        BadFile{"ElementWithoutType", "*NODE\n1\n*ELEMENT\n1, 1\n", "mesh.inp:3: *ELEMENT needs TYPE=type"},
        BadFile{"TooFewNodes", "*NODE\n1\n*ELEMENT, TYPE=C3D4\n1, 1, 1, 1\n*NSET, NSET=A\n",
                "mesh.inp:5: element 1 of type C3D4 has 3 nodes; it must have 4"},
        BadFile{"TooManyNodes", "*NODE\n1\n*ELEMENT, TYPE=C3D4\n1, 1, 1, 1, 1, 1\n",
                "mesh.inp:4: element 1 of type C3D4 has 5 nodes; it must have 4"},
        BadFile{"UndefinedNode", "*NODE\n1\n*ELEMENT, TYPE=T3D2\n5, 1, 2\n",
                "mesh.inp: element 5 has node 2, which *NODE does not define"},
        BadFile{"SetWithoutName", "*NSET, GENERATE\n1, 2\n", "mesh.inp:1: *NSET needs NSET=name"},
        BadFile{"UnknownNodeSet", "*NSET, NSET=A\n1, B\n",
                "mesh.inp:2: there is no node set 'B' above this line"},
        BadFile{"UnknownElementSet", "*ELSET, ELSET=A\nB\n",
                "mesh.inp:2: there is no element set 'B' above this line"},
        BadFile{"Member", "*NSET, NSET=A\n1x\n", "mesh.inp:2: '1x' is not the number of a node"},
        BadFile{"NegativeMember", "*NSET, NSET=A\n-1\n", "mesh.inp:2: '-1' is not the number of a node"},
        BadFile{"NegativeElement", "*ELSET, ELSET=A\n-1\n",
                "mesh.inp:2: '-1' is not the number of an element"},
        BadFile{"RangeBackwards", "*NSET, NSET=A, GENERATE\n5, 1, 1\n",
                "mesh.inp:2: cannot go from 5 to 1 in steps of 1"},
        BadFile{"RangeStandsStill", "*NSET, NSET=A, GENERATE\n1, 5, 0\n",
                "mesh.inp:2: cannot go from 1 to 5 in steps of 0"},
        BadFile{"RangeTooLong", "*NSET, NSET=A, GENERATE\n0, 2147483647, 1\n",
                "mesh.inp:2: goes from 0 to 2147483647, over 2147483648 numbers; at most 10000000 can be"},
        BadFile{"TwoParts", "*PART, NAME=A\n*END PART\n*PART, NAME=B\n",
                "mesh.inp:3: this is a second *PART; a mesh is one instance of one part"},
        BadFile{"TwoInstances", "*ASSEMBLY\n*INSTANCE, NAME=A\n*END INSTANCE\n*INSTANCE, NAME=B\n",
                "mesh.inp:4: this is a second *INSTANCE; a mesh is one instance of one part"},
        BadFile{"Rotation", "*INSTANCE, NAME=A\n0, 0, 0\n0, 0, 0, 0, 0, 1, 90\n",
                "mesh.inp:3: the instance is rotated, which is not supported; rotate the part"},
        BadFile{"Generation", "*NODE\n1\n*NGEN\n1, 5, 1\n",
                "mesh.inp:3: *NGEN is not supported; write nodes and elements out, in global coordinates"},
        BadFile{"Cylindrical", "*NODE, SYSTEM=C\n",
                "mesh.inp:1: *NODE, SYSTEM=C is not supported; give x, y, z"},
        BadFile{"NodeInput", "*NODE, INPUT=a.txt\n",
                "mesh.inp:1: *NODE, INPUT is not supported; use *INCLUDE"},
        BadFile{"ElementInput", "*ELEMENT, INPUT=a.txt\n",
                "mesh.inp:1: *ELEMENT, INPUT is not supported; use *INCLUDE"},
        BadFile{"IncludeWithoutName", "*INCLUDE\n", "mesh.inp:1: *INCLUDE needs INPUT=file"},
        BadFile{"IncludeMissing", "*NODE\n*INCLUDE, INPUT=no.inp\n",
                "mesh.inp:2: *INCLUDE: no.inp: cannot read the file; check its name and permissions"},
        BadFile{"IncludesItself", "\n*INCLUDE, INPUT=mesh.inp\n",
                "mesh.inp:2: *INCLUDE goes too deep; a file must not include itself"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(MeshDefinition, NamesAFileThatCannotBeRead) {
    const testing::MeshFolder folder;
    for (const char* name : {"no.inp", ""})
        EXPECT_EQ(testing::catchError([&] { readMeshDefinition(folder.getPath(name)); }),
                  folder.getPath(name) + ": cannot read the file; check its name and permissions");
}

}  // namespace
}  // namespace jprim
