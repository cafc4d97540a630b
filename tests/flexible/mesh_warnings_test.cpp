// SPDX-License-Identifier: Apache-2.0
// What an input file names but does not define, and what it leaves open.
#include <gtest/gtest.h>

#include "flexible/mesh_definition.h"
#include "support/expect_error.h"
#include "support/mesh_folder.h"

namespace jprim {
namespace {

using Ids = std::vector<int>;
using Warnings = std::vector<std::string>;

// Four nodes and two bars.
const std::string Square =
    "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n"
    "*ELEMENT, TYPE=T3D2, ELSET=BARS\n7, 1, 2\n8, 2, 3\n";  // lines 1 to 8

// The same in an instance: the assembly's lines begin at 13.
const std::string Assembly =
    "*ASSEMBLY\n*INSTANCE, NAME=Bar-1, PART=Bar\n" + Square + "*END INSTANCE\n*NODE\n";

struct Read {
    MeshDefinition mesh;
    Warnings warnings;  // without the folder
};

Read readText(const std::string& text) {
    const testing::MeshFolder folder;
    Read read{readMeshDefinition(folder.write("mesh.inp", text)), {}};
    for (const std::string& warning : read.mesh.warnings) read.warnings.push_back(folder.shorten(warning));
    return read;
}

//------------------------------------------------------------------------------------ undefined members
TEST(MeshWarnings, ASoundFileHasNone) {
    EXPECT_EQ(
        readText(Square + "*NSET, NSET=A\n1, 2\n*ELSET, ELSET=B\nBARS\n*NSET, NSET=C, ELSET=B\n").warnings,
        Warnings());
}

TEST(MeshWarnings, NameANodeOfASetThatIsNotDefined) {
    const Read read = readText(Square + "*NSET, NSET=Typo\n1, 2,\n3, 99999, 1\n*NSET, NSET=ALL\n4, Typo\n");
    EXPECT_EQ(read.warnings,
              Warnings({"mesh.inp:11: node 99999 of the node set 'Typo' is not defined and left out",
                        "mesh.inp:13: node 99999 of the node set 'ALL' is not defined and left out"}));
    EXPECT_EQ(read.mesh.nodeSets.at("TYPO"), Ids({1, 2, 3}));
    EXPECT_EQ(read.mesh.nodeSets.at("ALL"), Ids({1, 2, 3, 4}));
}

TEST(MeshWarnings, NameWhatARangeHasTooMuch) {
    EXPECT_EQ(readText(Square + "*NSET, NSET=R, GENERATE\n2, 12, 2\n").warnings,
              Warnings({"mesh.inp:10: nodes 6, 8, 10, 12 of the node set 'R' are not defined and left out"}));
    EXPECT_EQ(
        readText(Square + "*NSET, NSET=R, GENERATE\n1, 12\n").warnings,
        Warnings({"mesh.inp:10: nodes 5, 6, 7, 8, 9 and 3 more of the node set 'R' are not defined and left "
                  "out"}));
}

TEST(MeshWarnings, NameAnElementOfASetThatIsNotDefined) {
    EXPECT_EQ(readText(Square + "*ELSET, ELSET=E\n7, 9\n*NSET, NSET=N, ELSET=E\n").warnings,
              Warnings({"mesh.inp:10: element 9 of the element set 'E' is not defined and left out"}));
}

// Sets may stand above what they name, except where their elements' nodes are asked for.
TEST(MeshWarnings, OrderMattersOnlyForNodesOfElements) {
    EXPECT_EQ(readText("*NSET, NSET=N\n1, 3\n*ELSET, ELSET=E\n7\n" + Square).warnings, Warnings());
    const testing::MeshFolder folder;
    const std::string path =
        folder.write("mesh.inp", "*ELSET, ELSET=E\n7\n*NSET, NSET=N, ELSET=E\n" + Square);
    EXPECT_EQ(folder.shorten(testing::catchError([&] { readMeshDefinition(path); })),
              "mesh.inp:3: element 7 of this set is defined below; move the set there");
}

TEST(MeshWarnings, SayWhichPositionOfANodeIsTaken) {
    const Read read = readText(Square + "*NODE\n4, 0, 1, 0\n4, 5, 6, 7\n");
    EXPECT_EQ(read.warnings,
              Warnings({"mesh.inp:11: node 4 is defined a second time, at another place, which is "
                        "taken"}));
    EXPECT_EQ(read.mesh.nodes.at(4), SimTK::Vec3(5, 6, 7));
}

TEST(MeshWarnings, SayThatCoordinatesAreMissing) {
    EXPECT_EQ(readText(Square + "*NODE\n5, 1, 2\n6, 1\n").warnings,
              Warnings({"mesh.inp:10: node 5 has 2 coordinates; those not given are taken as 0"}));
}

//------------------------------------------------------------------------------------ sets of the assembly
const char* const Assumed =
    " stands outside the instance and has no instance=Bar-1; its numbers are read as that instance's";

TEST(MeshWarnings, SayHowASetAfterTheInstanceIsRead) {
    for (const char* end : {"", "*END ASSEMBLY\n", "*END ASSEMBLY\n*STEP\n*END STEP\n"}) {
        const Read read = readText(Assembly + "500\n" + end + "*NSET, NSET=LEFT\n1, 4\n3\n");
        ASSERT_EQ(read.warnings.size(), 1u) << end;
        EXPECT_EQ(read.warnings[0].substr(read.warnings[0].find(": ")),
                  std::string(": the set 'LEFT'") + Assumed);
        EXPECT_EQ(read.mesh.nodeSets.at("LEFT"), Ids({1, 3, 4})) << end;
    }
    const Read range = readText(Assembly + "*NSET, NSET=LEFT, GENERATE\n1, 4\n");
    EXPECT_EQ(range.warnings, Warnings({std::string("mesh.inp:13: the set 'LEFT'") + Assumed}));
    EXPECT_EQ(range.mesh.nodeSets.at("LEFT"), Ids({1, 2, 3, 4}));
    const Read elements = readText(Assembly + "*ELSET, ELSET=E\n8\n");
    EXPECT_EQ(elements.warnings, Warnings({std::string("mesh.inp:13: the set 'E'") + Assumed}));
    EXPECT_EQ(elements.mesh.nodeSets.at("E"), Ids({2, 3}));
}

// As Abaqus means it: the assembly's own nodes without an instance, the instance's with it.
TEST(MeshWarnings, ThereIsNoneWhereASetSaysWhatItMeans) {
    const Read read = readText(Assembly +
                               "1, 9, 9, 9\n*NSET, NSET=POINT\n1\n*NSET, NSET=A, INSTANCE=bar-1\n1, 2\n"
                               "*NSET, NSET=B\nBar-1.3, A\n");
    EXPECT_EQ(read.warnings, Warnings());
    EXPECT_EQ(read.mesh.nodeSets.at("POINT"), Ids());
    EXPECT_EQ(read.mesh.nodeSets.at("A"), Ids({1, 2}));
    EXPECT_EQ(read.mesh.nodeSets.at("B"), Ids({1, 2, 3}));
}

//----------------------------------------------------------------------------------------------- refusals
void expectRefusal(const std::string& text, const std::string& message) {
    const testing::MeshFolder folder;
    const std::string path = folder.write("mesh.inp", text);
    EXPECT_EQ(folder.shorten(testing::catchError([&] { readMeshDefinition(path); })), message);
}

TEST(MeshDefinition, RefusesWhatWouldBeReadWrongly) {
    expectRefusal(Assembly + "*NSET, NSET=A, INSTANCE=Rod-1\n1\n",
                  "mesh.inp:13: there is no instance 'Rod-1'; the mesh is 'Bar-1'");
    expectRefusal("*HEADING\n*END STEP*NSET, NSET=A\n1\n",
                  "mesh.inp:2: '*END STEP*NSET' has a star within; a keyword begins a line of its own");
    expectRefusal(Square + "7, 3, 4\n", "mesh.inp:9: element 7 is defined a second time");
    expectRefusal(std::string("*NODE\n1\0\n", 9),
                  "mesh.inp: the file is no plain text; check its name and "
                  "permissions");
}

TEST(MeshDefinition, AByteOrderMarkIsNoText) {
    EXPECT_EQ(readText("\xef\xbb\xbf*NODE\n1, 0, 0, 0\n").mesh.nodes.size(), 1u);
}

}  // namespace
}  // namespace jprim
