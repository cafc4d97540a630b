// SPDX-License-Identifier: Apache-2.0
// Building does not stop at the first kind of mistake: all are listed, in the order of the file, and none follows from
// another.
#include <gtest/gtest.h>

#include "jprim/mechanism/find_mistakes.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

/// "line:column element" of each error.
std::vector<std::string> findPlaces(const std::string& text) {
    Diagnostics diagnostics;
    const std::optional<Mechanism> mechanism = testing::buildFromText(text, diagnostics);
    EXPECT_FALSE(mechanism) << testing::formatAll(diagnostics);
    std::vector<std::string> places;
    for (const Diagnostic& d : diagnostics)
        if (d.severity == Severity::Error)
            places.push_back(std::to_string(d.where.line) + ":" + std::to_string(d.where.column) + " " +
                             d.message.substr(0, d.message.find_first_of(" :")));
    return places;
}

TEST(AllMistakes, AreListedInTheOrderOfTheFile) {
    EXPECT_EQ(findPlaces("t\n"
                         "REQUEST/1,F2=DX(20)\\F3=QQQ(1)\n"
                         "SENSOR/1,GE,VALUE=1,HALT,FUNCTION=QQQ\n"
                         "JOINT/1,REVOLUTE,I=21,J=10\n"
                         "PART/1,GROUND\n"
                         "MARKER/10\n"
                         "PART/2,MASS=1E-250,CM=20,IP=1,1,1\n"
                         "MARKER/20\n"
                         "MARKER/21,REULER=0D,180D,0D\n"
                         "  MARKER/22,ZP=0,0,0\n"
                         "PART/3,MASS=1,CM=30,IP=1,1,1,ZG=0,0,0\n"
                         "MARKER/30\n"
                         "POINT_MASS/1,MASS=1,CM=40,ZG=0,0,0\n"
                         "MARKER/40\n"
                         "GCON/1,FUNCTION=DX(20,99)\n"
                         "VARIABLE/1,FUNCTION=VARVAL(1)\n"
                         "SPRINGDAMPER/1,TRANSLATIONAL,I=20,J=10,K=1\n"
                         "SFORCE/1,TRANSLATIONAL,I=20,J=10,FUNCTION=1+[1,2,3]\n"
                         "END\n"),
              (std::vector<std::string>{"2:24 REQUEST/1", "3:35 SENSOR/1", "4:1 JOINT/1", "7:1 PART/2",
                                        "10:3 MARKER/22", "11:1 PART/3", "13:1 POINT_MASS/1", "15:23 GCON/1",
                                        "16:21 VARIABLE/1", "18:44 SFORCE/1"}));
}

// Axes that are not defined are not misaligned as well.
TEST(AllMistakes, DoNotBringOthers) {
    EXPECT_EQ(findPlaces("t\n"
                         "PART/1,GROUND\n"
                         "MARKER/10,REULER=0D,180D,0D\n"
                         "PART/2,MASS=1,CM=20,IP=1,1,1\n"
                         "MARKER/20\n"
                         "MARKER/21,ZP=0,0,0\n"
                         "PART/3,MASS=1,CM=30,IP=1,1,1,XG=0,0,0\n"
                         "MARKER/30\n"
                         "JOINT/1,REVOLUTE,I=21,J=10\n"
                         "JPRIM/1,PARALLEL_AXES,I=30,J=10\n"
                         "END\n"),
              (std::vector<std::string>{"6:1 MARKER/21", "7:1 PART/3"}));
}

// Nothing can be said of what stands on a body without modes; but the bodies themselves are all looked at.
TEST(AllMistakes, OfBodiesAreListedWithModesThatCannotBeRead) {
    EXPECT_EQ(findPlaces("t\n"
                         "PART/1,GROUND\n"
                         "FLEX_BODY/3,MODES_FILE=QQQ.modes\n"
                         "MARKER/31,NODE_ID=7\n"
                         "PART/2,MASS=1E-250,CM=20,IP=1,1,1\n"
                         "MARKER/20\n"
                         "MARKER/21,ZP=0,0,0\n"
                         "JPRIM/1,ATPOINT,I=31,J=20\n"
                         "END\n"),
              (std::vector<std::string>{"3:1 FLEX_BODY/3", "5:1 PART/2", "7:1 MARKER/21"}));
}

//--------------------------------------------------------------------------- with mistakes of statements
std::string findAll(const std::string& text) {
    Diagnostics diagnostics;
    const Dataset dataset = readDataset(text, diagnostics);
    EXPECT_TRUE(hasErrors(diagnostics));
    findMistakes(dataset, diagnostics);
    return testing::formatAll(diagnostics);
}

TEST(FindMistakes, ListsThoseInFunctionsTogetherWithThoseOfStatements) {
    EXPECT_EQ(
        findAll("t\n"
                "PART/1,GROUND\n"
                "MARKER/10\n"
                "REQUEST/1,F2=DX(99)\\F3=SFORCE(1,0,2,0)+SFORCE(2,0,2,0)\n"
                "MARKER/11,ZP=0,0,0\n"
                "PART/2,MASS=QQQ\n"
                "MARKER/20,NODE_ID=QQQ\n"
                "SFORCE/1,TRANSLATIONAL,I=10,J=77,FUNCTION=1+SINN(2)\n"
                "GFORCE/1,I=10,JFLOAT=20,RM=10,FX=QQQ\\TX=ACCX(10)\n"
                "MOTION/1,JOINT=5,FUNCTION=DX(10)\n"
                "GCON/1,FUNCTION=VX(10)**2\n"
                "END\n"),
        "4:17: error: REQUEST/1: MARKER/99 does not exist\n"
        "4:47: error: REQUEST/1: SFORCE/2 does not exist, or its load is not known here: only REQUEST and SENSOR "
        "can depend on loads of elements\n"
        "5:1: error: MARKER/11: the point for the z axis lies at the origin of the frame; give another point\n"
        "6:13: error: MASS of PART/2: 'QQQ' is not a number; write it like 1.5 or 1.5E3\n"
        "7:19: error: NODE_ID of MARKER/20: 'QQQ' is not an id; ids are whole numbers from 1\n"
        "8:31: error: J of SFORCE/1: there is no MARKER/77\n"
        "8:45: error: SFORCE/1: unknown function 'SINN'; did you mean SIN?\n"
        "9:22: error: JFLOAT of GFORCE/1: MARKER/20 is not FLOATING, as a marker that moves along with I must be\n"
        "9:34: error: GFORCE/1: unknown name 'QQQ'\n"
        "9:41: error: GFORCE/1: a force cannot depend on accelerations or reactions, which are known only when all "
        "forces are\n"
        "10:16: error: JOINT of MOTION/1: there is no JOINT/5\n"
        "10:27: error: MOTION/1: the function must depend on nothing but TIME\n"
        "11:23: error: GCON/1: the expression is not linear in velocities; a constraint of velocities must be\n");
}

// What names a statement with errors is not wrong on that account.
TEST(FindMistakes, DoNotFollowFromOthers) {
    EXPECT_EQ(findAll("t\n"
                      "PART/1,GROUND\n"
                      "MARKER/10,QQQ=1\n"
                      "VARIABLE/1,QQQ=1,FUNCTION=1\n"
                      "SPLINE/1,X=1,2,3,4,Y=QQQ\n"
                      "JOINT/1,QQQ\n"
                      "REQUEST/1,F2=DX(10)+VARVAL(1)\\F3=CUBSPL(TIME,0,1)\\F4=JOINT(1,1,2,10)\n"
                      "END\n"),
              "3:11: error: unknown argument 'QQQ' of MARKER/10\n"
              "4:12: error: unknown argument 'QQQ' of VARIABLE/1\n"
              "5:22: error: Y of SPLINE/1: 'QQQ' is not a number; write it like 1.5 or 1.5E3\n"
              "6:9: error: unknown argument 'QQQ' of JOINT/1\n");
}

TEST(FindMistakes, ReadsFilesOfModes) {
    EXPECT_EQ(findAll("t\n"
                      "PART/1,GROUND,QQQ\n"
                      "FLEX_BODY/3,MODES_FILE=QQQ.modes\n"
                      "MARKER/31,NODE_ID=7\n"
                      "END\n"),
              "2:15: error: unknown argument 'QQQ' of PART/1\n"
              "3:1: error: FLEX_BODY/3: QQQ.modes: cannot be opened\n");
}

}  // namespace
}  // namespace jprim
