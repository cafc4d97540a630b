// SPDX-License-Identifier: Apache-2.0
// Results as files: each row is there when it has been added, and what cannot be written is said.
#include "jprim/results/csv_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "jprim/base/error.h"
#include "jprim/results/results.h"

namespace jprim {
namespace {

namespace fs = std::filesystem;

class ResultFiles : public ::testing::Test {
protected:
    ResultFiles() {
        const auto* const info = ::testing::UnitTest::GetInstance()->current_test_info();
        m_folder = fs::path(::testing::TempDir()) / (std::string("jprim_results_") + info->name());
        fs::remove_all(m_folder);
    }
    ~ResultFiles() override { fs::remove_all(m_folder); }

    std::string read(const char* name) const {
        std::ostringstream text;
        text << std::ifstream(m_folder / name).rdbuf();
        return text.str();
    }

    fs::path m_folder;
};

const ResultColumns Columns{{"time", "R1.a, b", "R1.\"c\""}, {"time"}, {"time", "energy.total"}};

TEST_F(ResultFiles, HaveEachRowWhenItIsAdded) {
    CsvFiles files((m_folder / "new").string());
    files.begin(Columns);
    files.add({{0, 0.1, -1e-300}, {0}, {0, 1. / 3}});
    EXPECT_EQ(read("new/requests.csv"), "time,\"R1.a, b\",\"R1.\"\"c\"\"\"\n0,0.1,-1e-300\n");
    EXPECT_EQ(read("new/reactions.csv"), "time\n0\n");
    files.add({{0.5, 2, 3}, {0.5}, {0.5, 4}});
    EXPECT_EQ(read("new/parts.csv"), "time,energy.total\n0,0.3333333333333333\n0.5,4\n");
}

TEST_F(ResultFiles, ThatCannotBeWrittenAreAnError) {
    fs::create_directories(m_folder / "reactions.csv");  // a folder in the place of a file
    try {
        CsvFiles files(m_folder.string());
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), (m_folder / "reactions.csv").string() + ": cannot be written");
    }
    std::ofstream(m_folder / "file");
    EXPECT_THROW(CsvFiles((m_folder / "file" / "folder").string()), Error);
}

TEST_F(ResultFiles, HaveWhatMemoryHas) {
    Results results;
    ResultMemory memory(results);
    CsvFiles files((m_folder / "direct").string());
    for (ResultSink* sink : {static_cast<ResultSink*>(&memory), static_cast<ResultSink*>(&files)}) {
        sink->begin(Columns);
        sink->add({{0, 1, 2}, {0}, {0, 3}});
        sink->add({{1, 5, 6}, {1}, {1, 7}});
    }
    EXPECT_EQ(results.requests.getNumRows(), 2u);
    EXPECT_EQ(results.parts.getColumn("energy.total"), (std::vector<double>{3, 7}));
    EXPECT_THROW(results.parts.getColumn("energy"), Error);
    writeResults(results, (m_folder / "from_memory").string());
    for (const std::string name : {"requests.csv", "reactions.csv", "parts.csv"})
        EXPECT_EQ(read(("direct/" + name).c_str()), read(("from_memory/" + name).c_str()));
}

}  // namespace
}  // namespace jprim
