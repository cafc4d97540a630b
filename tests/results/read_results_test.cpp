// SPDX-License-Identifier: Apache-2.0
// What CsvFiles wrote is read again to the last digit, and what is damaged is refused.
#include "jprim/results/read_results.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "support/expect_error.h"

namespace jprim {
namespace {

namespace fs = std::filesystem;

class ReadResults : public ::testing::Test {
protected:
    ReadResults() : m_folder(fs::temp_directory_path() / ("jprim_read_results_" + std::to_string(getpid()))) {
        m_results.requests = {{"time", "a \"b\", c", "line\nbreak"}, {0, 1.0 / 3, -1e-300, 0.1, 1e300, 5}};
        m_results.reactions = {{"time"}, {0, 0.1}};
        m_results.parts = {{"time", "PART/2.X"}, {0, 7, 0.1, -0.0}};
        writeResults(m_results, m_folder.string());
    }
    ~ReadResults() override { fs::remove_all(m_folder); }

    void append(const char* name, const std::string& text) const {
        std::ofstream(m_folder / name, std::ios::app) << text;
    }

    fs::path m_folder;
    Results m_results;
};

TEST_F(ReadResults, AreWhatWasWritten) {
    const Results read = readResults(m_folder.string());
    EXPECT_EQ(read.requests.columns, m_results.requests.columns);
    EXPECT_EQ(read.requests.values, m_results.requests.values);
    EXPECT_EQ(read.reactions.values, m_results.reactions.values);
    EXPECT_EQ(read.parts.values, m_results.parts.values);
}

TEST_F(ReadResults, ARowThatWasCutOffIsLeftOut) {
    append("requests.csv", "0.2,1,2\n");
    append("parts.csv", "0.2,3.1");
    const Results read = readResults(m_folder.string());
    EXPECT_EQ(read.requests.getNumRows(), 2u);
    EXPECT_EQ(read.parts.getNumRows(), 2u);
}

TEST_F(ReadResults, WhatIsDamagedIsRefused) {
    const auto catchReading = [&] { return testing::catchError([&] { readResults(m_folder.string()); }); };
    append("parts.csv", "0.2,QQQ\n");
    EXPECT_EQ(catchReading(), (m_folder / "parts.csv").string() +
                                  ": row 3 of numbers cannot be understood at column PART/2.X");
    fs::resize_file(m_folder / "parts.csv", 0);
    EXPECT_EQ(catchReading(), (m_folder / "parts.csv").string() + ": has no header");
    fs::remove(m_folder / "parts.csv");
    EXPECT_EQ(catchReading(),
              (m_folder / "parts.csv").string() + ": cannot read the file; check its name and permissions");
}

}  // namespace
}  // namespace jprim
