// SPDX-License-Identifier: Apache-2.0
// What the fuzzer checks, on its seeds and on parts of them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "expression/expression_properties.h"

namespace jprim::testing {
namespace {

TEST(ExpressionFuzz, SeedsAndTheirPartsKeepTheProperties) {
    int seeds = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(JPRIM_SOURCE_DIR "/tests/fuzz/corpus/expression")) {
        std::ostringstream seed;
        seed << std::ifstream(entry.path(), std::ios::binary).rdbuf();
        const std::string text = seed.str();
        const bool isGood = entry.path().filename() != "errors.txt";
        EXPECT_EQ(findError(text).empty(), isGood) << text << "\n" << findError(text);
        for (std::size_t size = 0; size <= text.size(); ++size) {
            EXPECT_EQ(findBrokenProperty(text.substr(0, size)), "") << text.substr(0, size);
            EXPECT_EQ(findBrokenProperty(text.substr(size)), "") << text.substr(size);
        }
        ++seeds;
    }
    EXPECT_GE(seeds, 5);
}

}  // namespace
}  // namespace jprim::testing
