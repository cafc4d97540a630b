// SPDX-License-Identifier: Apache-2.0
// The rules of docs/architecture.md that a test can hold: which room may use which, what public headers may
// include, and one licence line per file.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Rooms = std::set<std::string>;

// A room and those it may use, besides itself.
const std::map<std::string, Rooms> AllowedUses = {
    {"base", {}},
    {"expression", {"base"}},
    {"linear_algebra", {}},
    {"flexible", {"base", "linear_algebra"}},
    {"marker", {"base", "expression", "flexible"}},
    {"primitive", {"base", "marker"}},
    {"general", {"base", "expression", "marker"}},
    {"force", {"base", "expression", "marker"}},
    {"joint", {"base", "marker", "primitive", "general"}},
    {"analysis", {"base", "linear_algebra", "marker", "primitive", "general", "joint"}},
    {"dataset", {"base"}},
    {"mechanism",
     {"base", "expression", "linear_algebra", "flexible", "marker", "primitive", "general", "force", "joint",
      "analysis", "dataset"}},
    {"results", {"base"}},
    {"simulation",
     {"base", "expression", "linear_algebra", "marker", "general", "force", "joint", "analysis", "dataset",
      "mechanism", "results"}},
    {"report", {"base", "flexible", "marker", "dataset", "mechanism", "results", "simulation"}},
    {"tool",
     {"base", "expression", "flexible", "marker", "primitive", "general", "force", "joint", "analysis",
      "dataset", "mechanism", "results", "simulation", "report"}}};

std::vector<fs::path> findFiles(const fs::path& folder, const std::set<std::string>& endings) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && endings.count(entry.path().extension().string()))
            files.push_back(entry);
    return files;
}

std::string readFile(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

// What the text includes: "jprim/base/error.h", "Eigen/QR".
std::vector<std::string> findIncludes(const std::string& text) {
    static const std::regex include(R"re(#include\s*["<]([^">]+)[">])re");
    std::vector<std::string> names;
    for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it)
        names.push_back((*it)[1]);
    return names;
}

// The room an include leads to, or empty if it leaves the project.
std::string findRoom(std::string name) {
    if (name.rfind("jprim/", 0) == 0) name = name.substr(6);
    const std::string folder = name.substr(0, name.find('/'));
    return AllowedUses.count(folder) ? folder : "";
}

std::vector<std::string> findForbiddenUses(const std::string& room, const std::string& text) {
    std::vector<std::string> forbidden;
    for (const std::string& name : findIncludes(text)) {
        const std::string used = findRoom(name);
        if (!used.empty() && used != room && !AllowedUses.at(room).count(used)) forbidden.push_back(name);
    }
    return forbidden;
}

const fs::path Source = JPRIM_SOURCE_DIR;

TEST(Architecture, RoomsUseOnlyWhatTheyMay) {
    int files = 0;
    for (const auto& [room, uses] : AllowedUses)
        for (const fs::path& base : {Source / "src", Source / "include/jprim"}) {
            if (!fs::exists(base / room)) continue;
            for (const fs::path& file : findFiles(base / room, {".h", ".cpp"})) {
                ++files;
                for (const std::string& name : findForbiddenUses(room, readFile(file)))
                    ADD_FAILURE() << file << " may not include " << name;
            }
        }
    EXPECT_GT(files, 50);
}

TEST(Architecture, EveryFolderIsARoom) {
    for (const fs::path& base : {Source / "src", Source / "include/jprim"})
        for (const auto& entry : fs::directory_iterator(base))
            EXPECT_TRUE(!entry.is_directory() || AllowedUses.count(entry.path().filename().string()))
                << entry.path();
}

// The check can fail.
TEST(Architecture, AnArrowBackIsNoticed) {
    EXPECT_EQ(findForbiddenUses("marker", "#include \"jprim/primitive/primitives.h\"\n").size(), 1u);
    EXPECT_EQ(findForbiddenUses("dataset", "#include <jprim/marker/marker.h>\n").size(), 1u);
    EXPECT_EQ(findForbiddenUses("joint", "#include \"jprim/marker/marker.h\"\n#include <vector>\n").size(),
              0u);
}

// Eigen does not compile beside `using namespace SimTK;`, which users write; fmt and json are our business.
TEST(Architecture, PublicHeadersSpeakStdAndSimTKOnly) {
    for (const fs::path& file : findFiles(Source / "include", {".h"}))
        for (const std::string& name : findIncludes(readFile(file))) {
            const bool simTK = name == "SimTKsimbody.h" || name == "SimTKcommon.h";
            const bool standard = name.find('/') == std::string::npos && name.find('.') == std::string::npos;
            EXPECT_TRUE(simTK || standard || name.rfind("jprim/", 0) == 0) << file << " includes " << name;
        }
}

// fmt's own code and Eigen's decompositions cost seconds in every file that has them.
TEST(Architecture, WhatCompilesSlowlyIsCompiledOnce) {
    const std::set<std::string> decompositions = {
        "Eigen/Cholesky", "Eigen/Dense",        "Eigen/Eigen",    "Eigen/Eigenvalues",
        "Eigen/LU",       "Eigen/QR",           "Eigen/SVD",      "Eigen/SparseCholesky",
        "Eigen/SparseLU", "Eigen/MetisSupport", "Eigen/SparseQR", "Eigen/Sparse"};
    for (const char* folder : {"src", "tests", "benchmarks"})
        for (const fs::path& file : findFiles(Source / folder, {".h", ".cpp"}))
            for (const std::string& name : findIncludes(readFile(file))) {
                const bool isFmt = name.rfind("fmt/", 0) == 0 && file.stem() != "format";
                const bool isEigen = decompositions.count(name) > 0 && folder == std::string("src") &&
                                     file.parent_path().filename() != "linear_algebra";
                EXPECT_FALSE(isFmt || isEigen) << file << " includes " << name;
            }
}

TEST(Architecture, TheUmbrellaHeaderIsComplete) {
    const std::string umbrella = readFile(Source / "include/jprim/jprim.h");
    for (const fs::path& file : findFiles(Source / "include/jprim", {".h"})) {
        const std::string name = fs::relative(file, Source / "include").generic_string();
        const bool isIncluded = umbrella.find('"' + name + '"') != std::string::npos;
        EXPECT_TRUE(isIncluded || name == "jprim/jprim.h") << name;
    }
}

TEST(Architecture, FilesHaveOneLicenceLineAndAreShort) {
    constexpr int LongestFile = 300;
    for (const char* folder : {"src", "include", "tests", "examples", "benchmarks"})
        for (const fs::path& file : findFiles(Source / folder, {".h", ".cpp", ".in"})) {
            const std::string text = readFile(file);
            EXPECT_EQ(text.find("// SPDX-License-Identifier: Apache-2.0\n"), 0u) << file;
            EXPECT_LE(std::count(text.begin(), text.end(), '\n'), LongestFile) << file;
        }
}

}  // namespace
