// SPDX-License-Identifier: Apache-2.0
// What is written reads as what it was.
#include <fstream>
#include <sstream>

#include "base/text.h"
#include "dataset/reading.h"

namespace jprim {
namespace {

// Every feature once; findBrokenProperty() makes the round trip with it.
Dataset makeFullDataset() {
    std::ifstream file(JPRIM_SOURCE_DIR "/tests/fuzz/corpus/read_dataset/every_statement.adm");
    std::ostringstream text;
    text << file.rdbuf();
    const Reading reading = read(text.str());
    EXPECT_EQ(reading.dataset.counts.errors, 0) << reading.findings;
    EXPECT_EQ(reading.dataset.counts.ignored, 12);
    return reading.dataset;
}

Dataset reread(const std::string& text) {
    Diagnostics diagnostics;
    return readDataset(text, diagnostics);
}

TEST(DatasetWriter, FullDatasetSurvives) {
    const Dataset dataset = makeFullDataset();
    EXPECT_EQ(dataset.parts.size(), 3u);
    EXPECT_EQ(dataset.flexBodies.size(), 3u);
    EXPECT_EQ(dataset.jprims.size(), 8u);
    EXPECT_EQ(dataset.joints.size(), 14u);
    EXPECT_EQ(countMembers(dataset), 97u);
    EXPECT_EQ(dataset.requests.size(), 6u);
    EXPECT_EQ(reread(writeDataset(dataset)), dataset);
}

// Shows that the comparison above can fail: whichever digit is changed, something else is read.
TEST(DatasetWriter, EveryDigitMatters) {
    const Dataset dataset = makeFullDataset();
    const std::string text = writeDataset(dataset);
    int changed = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!isDigit(text[i])) continue;
        std::string other = text;
        other[i] = text[i] == '7' ? '8' : '7';
        EXPECT_NE(reread(other), dataset) << "at " << i << " of\n" << text;
        ++changed;
    }
    EXPECT_GT(changed, 200);
}

// Likewise for whole lines: none is written in vain.
TEST(DatasetWriter, EveryLineMatters) {
    const Dataset dataset = makeFullDataset();
    const std::string text = writeDataset(dataset);
    std::size_t begin = 0;
    for (std::size_t end; (end = text.find('\n', begin)) != text.npos && text.substr(begin, 3) != "END";
         begin = end + 1)
        EXPECT_NE(reread(text.substr(0, begin) + text.substr(end + 1)), dataset)
            << text.substr(begin, end - begin);
}

TEST(DatasetWriter, NumbersAreExact) {
    Dataset dataset = readGood("");
    const double values[] = {
        0.1, 1.0 / 3, 1e300, -2.2250738585072014e-308, 123456789.123456789, 5e20, 3.14159265358979323846,
        -0.0};
    for (const double value : values) {
        dataset.markers[0].reuler = Triple{value, -value, 1 / (value + 1)};
        EXPECT_EQ(reread(writeDataset(dataset)), dataset) << value;
    }
    dataset.markers[0].reuler = Triple{0.1, 0, 0};
    Dataset other = dataset;
    (*other.markers[0].reuler)[0] = 0.10000000000000002;  // the next double
    EXPECT_NE(reread(writeDataset(dataset)), other);
}

TEST(DatasetWriter, EachProductOfInertiaIsWritten) {
    Dataset dataset = readGood("PART/3, IP=1,2,3");
    for (std::size_t i = 3; i < 6; ++i) {
        dataset.parts[2].ip = std::array<double, 6>{1, 2, 3, 0, 0, 0};
        (*dataset.parts[2].ip)[i] = -0.5;
        EXPECT_EQ(reread(writeDataset(dataset)), dataset) << i;
    }
}

TEST(DatasetWriter, FileNamesAreQuotedIfTheyMustBe) {
    Dataset dataset = readGood("FLEX_BODY/3, MODES_FILE=x");
    const std::pair<const char*, const char*> names[] = {{"a/b-c_D.modes", "a/b-c_D.modes"},
                                                         {"C:\\a.modes", "C:\\a.modes"},
                                                         {"=", "="},
                                                         {"my beam", "\"my beam\""},
                                                         {" ", "\" \""},
                                                         {"it's", "\"it's\""},
                                                         {"a,b;c&d!e", "\"a,b;c&d!e\""},
                                                         {"12\" rod", "'12\" rod'"},
                                                         {"\"", "'\"'"}};
    for (const auto& [name, written] : names) {
        dataset.flexBodies[0].modesFile = name;
        const std::string text = writeDataset(dataset);
        EXPECT_NE(text.find("FLEX_BODY/3, MODES_FILE=" + std::string(written) + "\n"), text.npos) << text;
        EXPECT_EQ(reread(text), dataset) << text;
    }
}

TEST(DatasetWriter, LinesAreShorterThan80Columns) {
    std::string expression = "1.25";
    for (int i = 0; i < 40; ++i) expression += " + JOINT(" + std::to_string(i) + ", 0, 2, 0)";
    std::string arguments = "CYLINDER";
    for (int i = 0; i < 40; ++i) arguments += ", ARGUMENT=" + std::to_string(i);
    const Dataset dataset =
        readInModel(
            "REQUEST/1, F2=" + expression + "\\F3=" + expression + ", T=title\nMATERIAL/1, " + arguments +
            "\nMARKER/3, QP=-1.2345678901234567E-100,-1.2345678901234567E-100,-1.2345678901234567E-100")
            .dataset;
    ASSERT_EQ(dataset.requests.size(), 1u);
    EXPECT_EQ(dataset.requests[0].expressions[1].second.text, expression);
    EXPECT_EQ(dataset.ignored[0].arguments, arguments);
    std::istringstream text(writeDataset(dataset));
    for (std::string line; std::getline(text, line);) EXPECT_LT(line.size(), 80u) << line;
}

TEST(DatasetWriter, WritesWhatAPersonWould) {
    const Dataset dataset =
        readInModel(
            "UNITS/SYSTEM=MKS\nJPRIM/7, INL, I=01, J=02\nREQUEST/1, F2=A\\F3=B, C=loads\nOUTPUT/REQSAVE")
            .dataset;
    EXPECT_EQ(writeDataset(dataset),
              "title\n"
              "UNITS/SYSTEM=MKS\n"
              "PART/1, GROUND\n"
              "PART/2\n"
              "MARKER/1, PART=1\n"
              "MARKER/2, PART=2\n"
              "JPRIM/7, INLINE, I=1, J=2\n"
              "REQUEST/1, COMMENT=loads, F2=A\\F3=B\n"
              "OUTPUT/REQSAVE\n"
              "END\n");
}

TEST(DatasetComparison, PositionsAreNotCompared) {
    EXPECT_EQ(readGood("MARKER/3, PART=1"), readGood("\n\nMARKER/3\n, PART=1"));
    EXPECT_NE(readGood("MARKER/3, PART=1"), readGood("MARKER/3, PART=2"));
    EXPECT_NE(readGood("MARKER/3"), readGood("MARKER/3\nMARKER/4"));
    EXPECT_NE(readGood("UNITS/SYSTEM=MKS"), readGood(""));
    EXPECT_NE(readGood("UNITS/SYSTEM=MKS"), readGood("UNITS/SYSTEM=NONE"));
}

}  // namespace
}  // namespace jprim
