// SPDX-License-Identifier: Apache-2.0
// Time is linear in the length of the text.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

#include "base/format.h"
#include "jprim/dataset/read_dataset.h"
#include "jprim/dataset/write_dataset.h"

namespace jprim {
namespace {

// Five statements for each body; every reference leads to a statement that comes later.
std::string makeChain(int bodies) {
    std::string text = "chain\nPART/1, GROUND\nMARKER/1, PART=1\n";
    for (int k = bodies; k > 1; --k) {
        text += fmt::format("MOTION/{0}, JOINT={0}, FUNCTION=2*SIN(3*TIME)\n, + {0}*TIME\n", k);
        text += fmt::format("JOINT/{0}, REVOLUTE, I={0}, J={1}\n", k, k - 1);
        text += fmt::format("SFORCE/{0}, TRANSLATIONAL, I={0}, J=1, FUNCTION=-5*(DM({0},1)-{0})\n", k);
        text += fmt::format("PART/{0}, MASS=1, CM={0}\nMARKER/{0}, QP={0},2,3, PART={0}\n", k);
    }
    return text + "END\n";
}

double measureReading(const std::string& text) {
    double best = 1e9;
    for (int trial = 0; trial < 3; ++trial) {
        Diagnostics diagnostics;
        const std::clock_t start = std::clock();
        const Dataset dataset = readDataset(text, diagnostics);
        EXPECT_TRUE(diagnostics.empty());
        EXPECT_EQ(writeDataset(dataset).empty(), false);
        best = std::min(best, double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

// Four times the text takes four times as long; it would be sixteen times if any step were quadratic. The
// bound between them leaves room for caches and for other work on the machine.
TEST(DatasetReader, TimeIsLinearFor100000Statements) {
    constexpr double Bound = 9;
    const double small = measureReading(makeChain(5001));
    const double large = measureReading(makeChain(20001));
    EXPECT_LT(large / small, Bound) << small << " s, " << large << " s";
    RecordProperty("seconds", fmt::format("{:.3f}", large));
}

}  // namespace
}  // namespace jprim
