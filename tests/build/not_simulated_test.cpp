// SPDX-License-Identifier: Apache-2.0
// A statement that is read but has no mechanics yet is refused by name, never left out.
#include <gtest/gtest.h>

#include "support/run_dataset.h"

namespace jprim {
namespace {

TEST(BuildMechanism, NamesWhatIsReadButCannotBeSimulated) {
    Diagnostics diagnostics;
    const auto mechanism = testing::buildFromText(
        "title\nPART/1, GROUND\nMARKER/1\nMARKER/3, FLOATING\nPART/2, MASS=1, CM=2, IP=1,1,1\nMARKER/2\n"
        "POINT_MASS/1\nJOINT/1, SCREW, PITCH=1, I=1, J=2\nJOINT/2, REV, I=1, J=2\nJOINT/3, REV, IC=1, I=1, J=2\n"
        "GCON/1, FUNCTION=DX(2)\nMOTION/1, JOINT=2, FUNCTION=TIME\nCOUPLER/1, JOINTS=2,3, SCALES=1\n"
        "SFORCE/1, ROT, I=2, J=1, FUNCTION=1\nGFORCE/1, I=2, JFLOAT=3, FX=1\nSPRINGDAMPER/1, ROT, I=2, J=1\n"
        "BUSHING/1, I=2, J=1\nVARIABLE/1, FUNCTION=1\nSPLINE/1, X=1,2,3,4, Y=1,2,3,4\n"
        "SENSOR/1, HALT, VALUE=1, FUNCTION=TIME\nEND\n",
        diagnostics);
    EXPECT_FALSE(mechanism);
    const char* const names[] = {"POINT_MASS/1", "JOINT/1",  "JOINT/3",  "GCON/1",         "MOTION/1",
                                 "COUPLER/1",    "SFORCE/1", "GFORCE/1", "SPRINGDAMPER/1", "BUSHING/1",
                                 "VARIABLE/1",   "SPLINE/1", "SENSOR/1"};
    std::string expected;
    for (const std::string name : names) expected += name + " is read, but cannot be simulated yet\n";
    std::string messages;
    for (const Diagnostic& d : diagnostics) messages += d.message + "\n";
    EXPECT_EQ(messages, expected);
    EXPECT_EQ(diagnostics[0].where.line, 7);
}

TEST(BuildMechanism, WarnsAboutRequestsOfExpressions) {
    Diagnostics diagnostics;
    EXPECT_TRUE(testing::buildFromText(
        "title\nPART/1, GROUND\nPART/2, MASS=1, CM=2, IP=1,1,1\nMARKER/2\nREQUEST/1, F2=DX(2)\nEND\n",
        diagnostics));
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(
        formatDiagnostic("", diagnostics[0]),
        ":5:1: warning: REQUEST/1: function expressions are not evaluated yet; this request writes nothing");
}

}  // namespace
}  // namespace jprim
