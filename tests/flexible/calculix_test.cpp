// SPDX-License-Identifier: Apache-2.0
// A free block given to CalculiX itself: its matrices are read and reduced here, and the frequencies compared
// with those it finds.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "jprim/flexible/read_mesh.h"
#include "jprim/flexible/reduce_to_modes.h"
#include "support/solid_block.h"

namespace jprim {
namespace {

namespace fs = std::filesystem;

constexpr int NumModes = 10;
// CalculiX prints seven digits.
constexpr double Tolerance = 1e-6;

// Bricks in CalculiX's order: around the lower face, then around the upper one.
std::string makeInput(const testing::SolidBlock& block, const std::string& step) {
    std::ostringstream text;
    text << "*NODE, NSET=ALL\n";
    for (const FiniteElementNode& node : block.model.nodes)
        text << node.id << "," << node.position[0] << "," << node.position[1] << "," << node.position[2]
             << "\n";
    text << "*ELEMENT, TYPE=C3D8, ELSET=BRICKS\n";
    int id = 0;
    for (int x = 0; x < block.elements[0]; ++x)
        for (int y = 0; y < block.elements[1]; ++y)
            for (int z = 0; z < block.elements[2]; ++z) {
                text << ++id;
                for (const int k : {0, 1})
                    for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
                        text << "," << block.findNode({x + i, y + j, z + k});
                text << "\n";
            }
    text << "*MATERIAL, NAME=STEEL\n*ELASTIC\n2e11, 0.3\n*DENSITY\n7800.\n"
         << "*SOLID SECTION, ELSET=BRICKS, MATERIAL=STEEL\n*STEP\n"
         << step << "*END STEP\n";
    return text.str();
}

// Circular frequencies from a .dat file: lines of mode number, eigenvalue, rad/time, cycles/time, …
std::vector<double> readFrequencies(const fs::path& file) {
    std::vector<double> frequencies;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line) && line.find("PARTICIPATION") == line.npos;) {
        std::istringstream words(line);
        double mode = 0, eigenvalue = 0, frequency = 0;
        if (words >> mode >> eigenvalue >> frequency) frequencies.push_back(frequency);
        if (frequencies.size() == NumModes + 6) break;
    }
    return frequencies;
}

TEST(CalculiX, FindsTheSameFrequenciesOfAFreeBlock) {
    if (std::system("command -v ccx > /dev/null") != 0) GTEST_SKIP() << "CalculiX (ccx) is not installed";
    const testing::SolidBlock block = testing::makeSolidBlock({6, 3, 2}, SimTK::Vec3(3, 1.2, 0.6));
    const fs::path folder = fs::temp_directory_path() / ("jprim_calculix_" + std::to_string(getpid()));
    fs::create_directories(folder);
    std::ofstream(folder / "matrices.inp") << makeInput(block, "*FREQUENCY, SOLVER=MATRIXSTORAGE\n1\n");
    std::ofstream(folder / "modes.inp") << makeInput(block, "*FREQUENCY\n16\n");
    const std::string command = "cd " + folder.string() + " && ccx matrices > log && ccx modes > log";
    ASSERT_EQ(std::system(command.c_str()), 0);

    const FiniteElementMesh mesh = readCalculixMesh((folder / "matrices.inp").string());
    const ModalBasis basis = reduceToModes(mesh.model, {}, NumModes);
    const std::vector<double> theirs = readFrequencies(folder / "modes.dat");
    ASSERT_EQ(theirs.size(), size_t(NumModes + 6));
    for (int k = 0; k < NumModes; ++k) EXPECT_NEAR(basis.frequencies[k] / theirs[6 + k], 1, Tolerance) << k;
    fs::remove_all(folder);
}

}  // namespace
}  // namespace jprim
