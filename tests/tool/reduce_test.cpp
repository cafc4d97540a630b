// SPDX-License-Identifier: Apache-2.0
// `jprim reduce`, run as a user runs it.
#include "base/format.h"
#include "tool/tool_fixture.h"

namespace {

namespace fs = std::filesystem;
using jprim::testing::Outcome;
using jprim::testing::readFile;
using jprim::testing::Tool;

const std::string Block = std::string(JPRIM_SOURCE_DIR) + "/tests/data/mesh/block.inp";

TEST_F(Tool, ReduceWritesModesAndSaysWhatTheyAre) {
    const fs::path file = m_folder / "block.modes";
    const Outcome result = run("reduce " + Block + " --interface LEFT --modes 4 -o " + file.string());
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.out.find("mass                     15700 kg\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("interface LEFT           node 122, which moves 4 nodes\n"), std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("mode 4 "), std::string::npos) << result.out;
    EXPECT_EQ(readFile(file).rfind("jprim-modes 1\n", 0), 0u);
}

// The same numbers read as millimetres and tonnes: lengths 1e-3, masses 1e3 as large, frequencies the same.
TEST_F(Tool, ReduceTakesTheUnitsOfTheMesh) {
    const std::string end = " --modes 4 -o " + (m_folder / "x").string();
    const Outcome si = run("reduce " + Block + end);
    const Outcome mm = run("reduce " + Block + " --length MILLIMETER --mass TONNE" + end);
    EXPECT_NE(mm.out.find("mass                     15700000 kg\n"), std::string::npos) << mm.out;
    EXPECT_NE(mm.out.find("mass centre              0.001 0.0005 0.0005 m\n"), std::string::npos) << mm.out;
    EXPECT_EQ(si.out.substr(si.out.find("mode 1")), mm.out.substr(mm.out.find("mode 1")));
    EXPECT_EQ(run("reduce " + Block + " --length QQQ" + end).exitCode, 2);
}

TEST_F(Tool, ReduceNamesASetThatDoesNotExist) {
    const Outcome result =
        run("reduce " + Block + " --interface QQQ --modes 4 -o " + (m_folder / "x").string());
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_EQ(result.err.rfind("error: block.inp: there is no node set 'QQQ'; there are ", 0), 0u)
        << result.err;
}

//-------------------------------------------------------------------------------------------- arguments
TEST_F(Tool, ReduceSaysHowManyModesThereCanBe) {
    const std::string end = " -o " + (m_folder / "x").string() + " --modes ";
    for (const char* modes : {"-1", "1.5", "some", "99999999999"}) {
        const Outcome result = run("reduce " + Block + end + modes);
        EXPECT_EQ(result.exitCode, 2);
        EXPECT_EQ(result.err, std::string("--modes: ") + modes +
                                  " is not a whole number from 0 to 2147483647\nRun with --help for more "
                                  "information.\n");
    }
    const std::string left = " --interface LEFT", right = " --interface RIGHT";
    EXPECT_EQ(run("reduce " + Block + end + "30").exitCode, 0);
    EXPECT_EQ(
        run("reduce " + Block + end + "31").err,
        "error: block.inp: 31 modes are wanted, but the free mesh has 30 at most, besides the six rigid "
        "motions\n");
    EXPECT_EQ(run("reduce " + Block + end + "2147483647").exitCode, 3);
    EXPECT_EQ(run("reduce " + Block + left + end + "24").exitCode, 0);
    EXPECT_EQ(
        run("reduce " + Block + left + end + "25").err,
        "error: block.inp: 25 fixed-interface modes are wanted, but with all interfaces held the mesh has 24 "
        "at most\n");
    for (const std::string& none : {std::string(), left})
        EXPECT_EQ(
            run("reduce " + Block + none + end + "0").err,
            "error: block.inp: no modes are left besides the six rigid motions; ask for one at least\n");
    EXPECT_EQ(run("reduce " + Block + left + right + end + "0").exitCode, 0);
}

TEST_F(Tool, ReduceListsTheUnitsItKnows) {
    const std::string end = " --modes 4 -o " + (m_folder / "x").string();
    const Outcome length = run("reduce " + Block + " --length mm" + end);
    EXPECT_EQ(length.exitCode, 2);
    EXPECT_NE(
        length.err.find("--length: mm is none of the names that UNITS knows, or the beginning of more than "
                        "one: ANGSTROM, CENTIMETER, FOOT, "),
        std::string::npos)
        << length.err;
    EXPECT_NE(run("reduce " + Block + " --mass k" + end).err.find("TONNE"), std::string::npos);
}

TEST_F(Tool, ReduceFailsWhereItCannotWrite) {
    for (const std::string& out :
         {m_folder.string(), (m_folder / "no" / "x.modes").string(), std::string("/dev/full")}) {
        const Outcome result = run("reduce " + Block + " --modes 4 -o " + out);
        EXPECT_EQ(result.exitCode, 1) << out;
        EXPECT_EQ(result.err, "error: " + out + ": cannot be written\n");
        EXPECT_EQ(result.out, "");
    }
}

//-------------------------------------------------------------------------------------------- meshes
TEST_F(Tool, ReduceNamesTheMatrixFileAndItsLine) {
    for (const char* ending : {".inp", ".dof", ".sti", ".mas"})
        fs::copy_file(fs::path(Block).replace_extension(ending), m_folder / (std::string("block") + ending));
    const std::string file = (m_folder / "block.sti").string();
    std::ofstream(file, std::ios::app) << "2 1 1e9\n";
    const Outcome result =
        run("reduce " + (m_folder / "block.inp").string() + " --modes 4 -o " + (m_folder / "x").string());
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_EQ(result.err.rfind(
                  "error: " + file + ":523: row 2, column 1 is below the diagonal, where only 1 of ", 0),
              0u)
        << result.err;
}

TEST_F(Tool, ReduceWarnsOfWhatSetsNameInVain) {
    for (const char* ending : {".dof", ".sti", ".mas"})
        fs::copy_file(fs::path(Block).replace_extension(ending), m_folder / (std::string("block") + ending));
    const std::string inp = write("block.inp", readFile(Block) + "*NSET, NSET=TYPO\n11, 21, 31, 99999\n");
    const Outcome result =
        run("reduce " + inp + " --interface TYPO --modes 4 -o " + (m_folder / "x").string());
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err,
              "warning: " + inp + ":44: node 99999 of the node set 'TYPO' is not defined and left out\n");
    EXPECT_NE(result.out.find("which moves 3 nodes\n"), std::string::npos) << result.out;
}

// A mesh in mm, N and tonne has stiffnesses E L: 1e-3 of those in SI; masses in tonnes 1e-3 of those in kg.
std::string scaleMatrix(const std::string& text, double factor) {
    std::istringstream lines(text);
    std::string scaled;
    int row = 0, column = 0;
    for (double value = 0; lines >> row >> column >> value;)
        scaled += fmt::format("{} {} {:.13e}\n", row, column, factor * value);
    return scaled;
}

TEST_F(Tool, ReduceWarnsOfAMeshInMillimetres) {
    fs::copy_file(fs::path(Block).replace_extension(".dof"), m_folder / "mm.dof");
    for (const char* ending : {".sti", ".mas"})
        write(std::string("mm") + ending,
              scaleMatrix(readFile(fs::path(Block).replace_extension(ending)), 1e-3));
    std::string inp = readFile(Block);
    for (const auto& [metres, millimetres] : {std::pair(", 1., ", ", 1000., "),
                                              {", 1., ", ", 1000., "},
                                              {", 2., ", ", 2000., "},
                                              {", 1.\n", ", 1000.\n"},
                                              {"0, .5, .5", "0, 500., 500."}})
        for (std::size_t at = 0; (at = inp.find(metres, at)) != std::string::npos; ++at)
            inp.replace(at, std::string(metres).size(), millimetres);
    const std::string mesh = write("mm.inp", inp), end = " --modes 4 -o " + (m_folder / "x").string();
    const Outcome wrong = run("reduce " + mesh + end);
    EXPECT_EQ(wrong.exitCode, 0);
    EXPECT_EQ(wrong.err.rfind("warning: mm.inp: read in metres, sound would travel through this mesh at ", 0),
              0u)
        << wrong.err;
    const Outcome right = run("reduce " + mesh + " --length MILLIMETER --mass TONNE" + end);
    EXPECT_EQ(right.err, "");
    const Outcome metres = run("reduce " + Block + end);
    EXPECT_EQ(metres.err, "");  // as large, but in metres
    EXPECT_EQ(right.out.substr(right.out.find("mode 1")), metres.out.substr(metres.out.find("mode 1")));
    EXPECT_EQ(run("reduce " + mesh + " --length METER" + end).err, "");  // as the user says
}

}  // namespace
