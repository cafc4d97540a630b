// SPDX-License-Identifier: Apache-2.0
#include "jprim/base/units.h"

#include <gtest/gtest.h>

namespace jprim {
namespace {

TEST(Units, AbbreviationsResolveToTheFullUnit) {
    EXPECT_EQ(findUnit(Quantity::Length, "millim")->name, "MILLIMETER");
    EXPECT_EQ(findUnit(Quantity::Force, "NEW")->name, "NEWTON");
    EXPECT_EQ(findUnit(Quantity::Mass, "kil")->name, "KILOGRAM");
    EXPECT_EQ(findUnit(Quantity::Time, "MILLISECOND")->name, "MILLISECONDS");
}

TEST(Units, AmbiguousOrUnknownNamesAreNotGuessed) {
    EXPECT_FALSE(findUnit(Quantity::Length, "MIL"));  // MILE, MILLIMETER, MILS
    EXPECT_FALSE(findUnit(Quantity::Length, "PARSEC"));
    EXPECT_FALSE(findUnit(Quantity::Length, ""));
    EXPECT_FALSE(findUnitSystem("SI"));
}

TEST(Units, FullNameWinsOverLongerNames) {
    EXPECT_EQ(findUnit(Quantity::Mass, "SLUG")->name, "SLUG");
}

// One slug is accelerated by 1 ft/s^2 by one pound-force; one slinch by 1 in/s^2.
TEST(Units, BritishUnitsAreConsistent) {
    const double lbf = findUnit(Quantity::Force, "POUND_FORCE")->inSI;
    const double ft = findUnit(Quantity::Length, "FOOT")->inSI;
    const double in = findUnit(Quantity::Length, "INCH")->inSI;
    EXPECT_DOUBLE_EQ(findUnit(Quantity::Mass, "SLUG")->inSI * ft, lbf);
    EXPECT_DOUBLE_EQ(findUnit(Quantity::Mass, "SLINCH")->inSI * in, lbf);
    EXPECT_NEAR(lbf, 4.4482216152605, 1e-13);  // NIST SP 811, Appendix B.8: exact
}

TEST(Units, SystemsCombineTheirUnits) {
    const UnitSystem ips = *findUnitSystem("ips");
    EXPECT_DOUBLE_EQ(ips.length, 0.0254);
    EXPECT_DOUBLE_EQ(ips.mass, 0.45359237);
    const UnitSystem cgs = *findUnitSystem("CGS");
    EXPECT_DOUBLE_EQ(cgs.getMoment(), 1e-7);
    EXPECT_DOUBLE_EQ(cgs.getInertia(), 1e-7);
}

}  // namespace
}  // namespace jprim
