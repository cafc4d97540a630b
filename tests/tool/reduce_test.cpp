// SPDX-License-Identifier: Apache-2.0
// `jprim reduce`, run as a user runs it.
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
    EXPECT_NE(result.out.find("interface LEFT           node "), std::string::npos) << result.out;
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

}  // namespace
