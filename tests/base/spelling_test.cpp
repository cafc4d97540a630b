// SPDX-License-Identifier: Apache-2.0
#include "base/spelling.h"

#include <gtest/gtest.h>

namespace jprim {
namespace {

TEST(Spelling, SlipsAreCounted) {
    EXPECT_EQ(countSlips("MARKER", "marker"), 0u);
    EXPECT_EQ(countSlips("STEP", "STEPP"), 1u);
    EXPECT_EQ(countSlips("STEP", "SEP"), 1u);
    EXPECT_EQ(countSlips("STEP", "STOP"), 1u);
    EXPECT_EQ(countSlips("kitten", "sitting"), 3u);
    EXPECT_EQ(countSlips("", "ABC"), 3u);
    EXPECT_EQ(countSlips("ABC", ""), 3u);
    EXPECT_EQ(countSlips(std::string(100000, 'A'), "A"), 24u);
}

TEST(Spelling, OnlyNearNamesAreSuggested) {
    const std::vector<std::string> names{"SIN", "SINH", "ATAN2", "BISTOP"};
    EXPECT_EQ(suggestNearest(names, "SINN"), "; did you mean SIN?");
    EXPECT_EQ(suggestNearest(names, "bitsop"), "; did you mean BISTOP?");
    EXPECT_EQ(suggestNearest(names, "ATN"), "");
    EXPECT_EQ(suggestNearest(names, "Q"), "");
    EXPECT_EQ(suggestNearest({}, "SIN"), "");
}

TEST(Spelling, NamesWithNumbersAreListed) {
    const std::vector<std::string> names{"F1", "FORCE", "F2", "F8", "B1"};
    EXPECT_EQ(suggestNearest(names, "f9"), "; there are F1 to F8");
    EXPECT_EQ(suggestNearest(names, "F123456789123"), "; there are F1 to F8");
    EXPECT_EQ(suggestNearest(names, "FORC"), "; did you mean FORCE?");
    EXPECT_EQ(suggestNearest(names, "B9"), "; did you mean B1?");
}

}  // namespace
}  // namespace jprim
