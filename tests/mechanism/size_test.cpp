// SPDX-License-Identifier: Apache-2.0
// Large mechanisms are built in little memory; how long it takes is written down, not judged.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <ctime>

#include "base/format.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

std::string makeChain(int parts) {
    std::string text = "chain\nPART/1,GROUND\nMARKER/1\n";
    for (int k = 1; k <= parts; ++k)
        text += fmt::format(
            "PART/{0},MASS=1,CM={0}0,IP=0.1,0.1,0.1,QG={1},0,0\nMARKER/{0}0,QP=0.5,0,0\nMARKER/{0}1\n"
            "MARKER/{0}2,QP=1,0,0\nJOINT/{0},REVOLUTE,I={0}1,J={2}\n",
            k + 1, k - 1, k == 1 ? 1 : 10 * k + 2);
    return text + "END\n";
}

long getPeakMegabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

TEST(BuildMechanism, TenThousandPartsInAChain) {
    constexpr long Megabytes = 1000;  // more than before
    const std::string text = makeChain(10000);
    const long before = getPeakMegabytes();
    const std::clock_t start = std::clock();
    const Mechanism mechanism = testing::buildOrFail(text, {Formulation::Tree});
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_LT(getPeakMegabytes() - before, Megabytes);
    EXPECT_EQ(mechanism.makeGivenState().getNU(), 10000);
    RecordProperty("seconds", fmt::format("{:.2f}", seconds));
}

}  // namespace
}  // namespace jprim
