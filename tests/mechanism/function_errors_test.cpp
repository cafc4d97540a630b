// SPDX-License-Identifier: Apache-2.0
// Mistakes that only building finds: each is reported at its line and column, in expressions too.
#include <gtest/gtest.h>

#include "support/run_dataset.h"

namespace jprim {
namespace {

struct Case {
    const char* name;
    const char* statements;  ///< the first stands in line 11
    const char* findings;
};

std::string findMistakes(const std::string& statements) {
    Diagnostics diagnostics;
    testing::buildFromText(
        "t\nPART/1,GROUND\nMARKER/10\nMARKER/11,REULER=0,90D,0\nPART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20\n"
        "MARKER/21,QP=0.5,0,0\nPART/3,MASS=2,CM=30,IP=1,1,1,QG=1,0,0\nMARKER/30\nMARKER/31,FLOATING\n" +
            statements + "\nEND\n",
        diagnostics);
    return testing::formatAll(diagnostics);
}

class FunctionErrors : public ::testing::TestWithParam<Case> {};

TEST_P(FunctionErrors, AreReportedWhereTheyAre) {
    EXPECT_EQ(findMistakes(GetParam().statements), GetParam().findings);
}

std::string getName(const ::testing::TestParamInfo<Case>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Constraints, FunctionErrors,
    ::testing::Values(
        Case{"UnknownMarker", "GCON/1,FUNCTION=DX(20)-DX(99)",
             "11:27: error: GCON/1: MARKER/99 does not exist\n"},
        Case{"OnAContinuationLine", "GCON/1,FUNCTION=DX(20)-\n! a comment\n, 2*DX(20,99)",
             "13:11: error: GCON/1: MARKER/99 does not exist\n"},
        Case{"FloatingMarker", "GCON/1,FUNCTION=DX(31)",
             "11:20: error: GCON/1: MARKER/31 is FLOATING and cannot be measured; name a fixed marker\n"},
        Case{"Vector", "GCON/1,FUNCTION=UVX(20)",
             "11:17: error: GCON/1: the function is a vector; it must be a number\n"},
        Case{
            "NotLinear", "GCON/1,FUNCTION=VM(20)-1",
            "11:17: error: GCON/1: the expression is not linear in velocities; a constraint of velocities must be\n"},
        Case{
            "NotLinearBelow", "GCON/1,FUNCTION=VX(20)+2*VX(20)\n, -VX(20)*VY(20)",
            "12:10: error: GCON/1: the expression is not linear in velocities; a constraint of velocities must be\n"},
        Case{
            "Reaction", "JPRIM/1,ATPOINT,I=20,J=10\nGCON/1,FUNCTION=DX(30)+JPRIM(1,0,2)",
            "12:24: error: GCON/1: a constraint cannot depend on accelerations or reactions; only on positions, "
            "velocities and TIME\n"},
        Case{
            "Acceleration", "  GCON/1,FUNCTION=ACCX(20)-1",
            "11:19: error: GCON/1: a constraint cannot depend on accelerations or reactions; only on positions, "
            "velocities and TIME\n"},
        Case{"Nothing", "GCON/1,FUNCTION=TIME",
             "11:17: error: GCON/1: the expression depends on no marker, so it constrains nothing\n"},
        Case{"MotionOfMarkers", "MOTION/1,I=20,J=10,X,FUNCTION=DX(30)",
             "11:31: error: MOTION/1: the function must depend on nothing but TIME\n"},
        Case{"MotionOfAVector", "MOTION/1,I=20,J=10,X,FUNCTION=[1,2,3]",
             "11:31: error: MOTION/1: the function is a vector; it must be a number\n"},
        Case{"MotionOfAVariable",
             "VARIABLE/1,FUNCTION=TIME**2\nVARIABLE/2,FUNCTION=DX(20)\n"
             "MOTION/1,I=20,J=10,X,FUNCTION=VARVAL(1)-VARVAL(2)",
             "13:41: error: MOTION/1: in VARIABLE/2: the function must depend on nothing but TIME\n"},
        Case{
            "RackAlongThePinion", "JOINT/1,RACKPIN,PD=1,I=20,J=10",
            "11:1: error: JOINT/1 RACKPIN: the z axis of I=20 and the z axis of J=10 must be perpendicular but are "
            "parallel; turn one of the markers\n"}),
    getName);

INSTANTIATE_TEST_SUITE_P(
    Forces, FunctionErrors,
    ::testing::Values(
        Case{"Misspelt", "SFORCE/1,TRANSLATIONAL,I=20,J=10,FUNCTION=STPE(TIME,0,0,1,1)",
             "11:43: error: SFORCE/1: unknown function 'STPE'\n"},
        Case{
            "Acceleration", "SFORCE/1,ROTATIONAL,I=20,J=10,FUNCTION=WDTZ(20)",
            "11:40: error: SFORCE/1: a force cannot depend on accelerations or reactions, which are known only when "
            "all forces are\n"},
        Case{
            "OnOnePart", "\nVFORCE/1,I=30,JFLOAT=31,FX=1",
            "12:22: error: VFORCE/1 connects PART/3 with itself; I and JFLOAT must be markers of different parts\n"},
        Case{"ScalarForVector", "GFORCE/1,I=20,JFLOAT=31,FXYZ=3",
             "11:30: error: GFORCE/1: the function must be a vector, such as [1,0,0]\n"},
        Case{"VectorForScalar", "GFORCE/1,I=20,JFLOAT=31,FX=1\\FY=UVX(20)\\\n,TZ=1",
             "11:33: error: GFORCE/1: the function is a vector; it must be a number\n"},
        Case{"InAComponentBelow", "GFORCE/1,I=20,JFLOAT=31,FX=1\\\n,TZ=1+DX(20,\n,77)",
             "13:2: error: GFORCE/1: MARKER/77 does not exist\n"},
        Case{"NoSpline", "SFORCE/1,ROTATIONAL,I=20,J=10,FUNCTION=AKISPL(TIME,0,5)",
             "11:54: error: SFORCE/1: there is no SPLINE/5\n"}),
    getName);

INSTANTIATE_TEST_SUITE_P(
    Variables, FunctionErrors,
    ::testing::Values(
        Case{"Missing", "REQUEST/1,F2=VARVAL(4)", "11:21: error: REQUEST/1: VARIABLE/4 does not exist\n"},
        Case{
            "OfItself", "VARIABLE/1,FUNCTION=2+VARVAL(1)",
            "11:23: error: VARIABLE/1: in VARIABLE/1: VARIABLE/1 depends on itself; implicit variables are not "
            "supported\n"},
        Case{
            "Cycle", "VARIABLE/1,FUNCTION=2*VARVAL(2)\nVARIABLE/2,FUNCTION=1+\n,VARVAL(1)",
            "11:23: error: VARIABLE/1: in VARIABLE/2: in VARIABLE/1: VARIABLE/2 depends on itself; implicit variables "
            "are not supported\n"
            "13:2: error: VARIABLE/2: in VARIABLE/1: in VARIABLE/2: VARIABLE/1 depends on itself; implicit variables "
            "are not supported\n"},
        Case{"Vector", "VARIABLE/1,FUNCTION=UVX(20)",
             "11:21: error: VARIABLE/1: the function is a vector; it must be a number\n"},
        Case{"UserOfAMistake", "VARIABLE/1,FUNCTION=DX(99)\nGCON/1,FUNCTION=DX(20)+VARVAL(1)",
             "11:24: error: VARIABLE/1: MARKER/99 does not exist\n"
             "12:24: error: GCON/1: in VARIABLE/1: MARKER/99 does not exist\n"},
        Case{
            "Load",
            "JPRIM/1,ATPOINT,I=20,J=10\nVARIABLE/1,FUNCTION=JPRIM(1,0,2)\nSFORCE/1,ROTATIONAL,I=30,J=10\n"
            ",FUNCTION=VARVAL(1)",
            "14:11: error: SFORCE/1: in VARIABLE/1: a force cannot depend on accelerations or reactions, which are known only when "
            "all forces are\n"}),
    getName);

INSTANTIATE_TEST_SUITE_P(
    Requests, FunctionErrors,
    ::testing::Values(
        Case{
            "NoElement", "REQUEST/1,F2=SPDP(1,0,2)",
            "11:19: error: REQUEST/1: SPRINGDAMPER/1 does not exist, or its load is not known here: only REQUEST and "
            "SENSOR can depend on loads of elements\n"},
        Case{
            "Jflag", "JPRIM/1,ATPOINT,I=20,J=10\nREQUEST/1,F2=1\\F3=JPRIM(1,2,2)",
            "12:27: error: REQUEST/1: the second argument must be 0 for the load on I or 1 for the load on J\n"},
        Case{"Component", "JPRIM/1,ATPOINT,I=20,J=10\nREQUEST/1,F2=JPRIM(1,0,9)",
             "12:24: error: REQUEST/1: the third argument must be 1 to 8 for FM FX FY FZ TM TX TY TZ\n"},
        Case{"NoJ", "SFORCE/1,ROTATIONAL,ACTIONONLY,I=20,J=10,FUNCTION=1\nREQUEST/1,F2=SFORCE(1,1,8)",
             "12:23: error: REQUEST/1: SFORCE/1 has no reaction on a J marker\n"},
        Case{"Axes", "JPRIM/1,ATPOINT,I=20,J=10\nREQUEST/1,F2=JPRIM(1,0,3,98)",
             "12:26: error: REQUEST/1: MARKER/98 does not exist\n"},
        Case{"Orient", "REQUEST/1,F2=ORIENT(26,1,20)",
             "11:14: error: REQUEST/1: only ORIENT(27,k,i,j) is supported, the Euler parameters k = 1 … 4\n"},
        Case{"Parameter", "REQUEST/1,F2=ORIENT(27,5,20)",
             "11:14: error: REQUEST/1: only ORIENT(27,k,i,j) is supported, the Euler parameters k = 1 … 4\n"},
        Case{"Sensor", "SENSOR/1,VALUE=1,HALT,FUNCTION=DX(20)+QQQ(1)",
             "11:39: error: SENSOR/1: unknown function 'QQQ'\n"},
        Case{"SensorVector", "SENSOR/1,VALUE=1,HALT,FUNCTION=UVX(20)",
             "11:32: error: SENSOR/1: the function is a vector; it must be a number\n"},
        Case{"OnlyToAdams", "REQUEST/1,F2=SWEEP(1)", "11:14: error: REQUEST/1: SWEEP is not supported\n"}),
    getName);

// A floating marker lies where its force acts: it says nothing of the size of its part.
TEST(FunctionErrors, AFloatingMarkerHasNoPlaceOfItsOwn) {
    const auto build = [](const char* floating) {
        return testing::buildOrFail(
            std::string("t\nPART/1,GROUND\nPART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20,QP=500,0,0\n"
                        "MARKER/21,QP=500.2,0,0\nPART/3,MASS=1,CM=30,IP=1,1,1\nMARKER/30\n") +
            floating + "END\n");
    };
    const Mechanism with = build("MARKER/22,PART=2,FLOATING\nVFORCE/1,I=30,JFLOAT=22,FX=1\n"),
                    without = build("");
    EXPECT_EQ(with.getParts()[1].size, without.getParts()[1].size);
    EXPECT_EQ(with.getLengthUnit(), without.getLengthUnit());
}

}  // namespace
}  // namespace jprim
