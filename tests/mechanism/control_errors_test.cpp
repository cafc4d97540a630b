// SPDX-License-Identifier: Apache-2.0
// Mistakes in control systems: what does not fit together, and functions that read what is not there.
#include <gtest/gtest.h>

#include "base/format.h"
#include "jprim/mechanism/find_mistakes.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

// What stands before the statements, of which the first stands in line 16.
const char* const Model =
    "t\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20\nVARIABLE/1,FUNCTION=TIME\nARRAY/1,X\n"
    "ARRAY/2,U,VAR=1\nARRAY/3,Y\nARRAY/4,NUM=7,8\nMATRIX/1,M=1,N=1,VALUES=-2\nMATRIX/2,M=2,N=1,VALUES=1,2\n"
    "ARRAY/5,X,SIZE=2\nARRAY/6,Y\nDIFF/9,FUNCTION=-DIF(9)\n";

std::string findMistakes(const std::string& statements) {
    Diagnostics diagnostics;
    testing::buildFromText(Model + statements + "\nEND\n", diagnostics);
    return testing::formatAll(diagnostics);
}

struct Case {
    const char* name;
    const char* statements;
    const char* findings;
};

class ControlErrors : public ::testing::TestWithParam<Case> {};

TEST_P(ControlErrors, AreReportedWhereTheyAre) {
    EXPECT_EQ(findMistakes(GetParam().statements), GetParam().findings);
}

std::string getName(const ::testing::TestParamInfo<Case>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Systems, ControlErrors,
    ::testing::Values(
        Case{"WrongType", "LSE/1,X=2,A=1",
             "16:1: error: LSE/1: its X must be an ARRAY of that type, but ARRAY/2 is one of type U\n"},
        Case{"NotSquare", "LSE/1,X=1,A=2",
             "16:1: error: LSE/1: its A, MATRIX/2, has 2 rows and 1 columns; it must have 2 and 2\n"},
        Case{"WrongInput", "LSE/1,X=1,U=2,A=1,B=2",
             "16:1: error: LSE/1: its B, MATRIX/2, has 2 rows and 1 columns; it must have 1 and 1\n"},
        Case{"WrongFeedthrough", "LSE/1,X=1,U=2,Y=3,A=1,C=1,D=2",
             "16:1: error: LSE/1: its D, MATRIX/2, has 2 rows and 1 columns; it must have 1 and 1\n"},
        Case{"WrongSize", "LSE/1,X=5,A=1",
             "16:1: error: LSE/1: its X, ARRAY/5, has 2 elements where 1 are needed\n"},
        Case{"WrongInitial", "LSE/1,X=1,A=1,IC=4",
             "16:1: error: LSE/1: its IC, ARRAY/4, has 2 elements where 1 are needed\n"},
        Case{"SharedStates", "LSE/1,X=1,A=1\nLSE/2,X=1,A=1",
             "17:1: error: LSE/2: its X, ARRAY/1, is that of LSE/1 already; each system has its own\n"},
        Case{"TwoInputs", "ARRAY/7,U,VAR=1,1\nTFSISO/1,X=1,U=7,Y=3,NUM=1,DEN=1,2",
             "17:1: error: TFSISO/1: its U, ARRAY/7, has 2 elements where 1 are needed\n"},
        Case{
            "ImplicitWithoutDerivative", "DIFF/1,IMPLICIT,FUNCTION=DIF(1)-2",
            "16:1: error: DIFF/1: its FUNCTION does not depend on its derivative, DIF1; without IMPLICIT it is the "
            "derivative\n"},
        Case{
            "ImplicitTogether",
            "DIFF/1,IMPLICIT,FUNCTION=DIF1(1)+DIF1(2)\nDIFF/2,IMPLICIT,FUNCTION=DIF1(2)-DIF1(1)",
            "16:34: error: DIFF/1: in DIF1(2): in DIF1(1): DIF1(2) depends on itself; implicit variables are not "
            "supported\n17:34: error: DIFF/2: in DIF1(1): in DIF1(2): DIF1(1) depends on itself; implicit variables "
            "are not supported\n"},
        Case{
            "ExplicitOfItself", "DIFF/1,FUNCTION=DIF1(1)+DIF(1)",
            "16:17: error: DIFF/1: in DIF1(1): DIF1(1) depends on itself; implicit variables are not supported\n"}),
    getName);

INSTANTIATE_TEST_SUITE_P(
    Functions, ControlErrors,
    ::testing::Values(
        Case{"NoDiff", "REQUEST/1,F2=DIF(3)", "16:18: error: REQUEST/1: DIFF/3 does not exist\n"},
        Case{"NoArray", "REQUEST/1,F2=ARYVAL(77,1)", "16:21: error: REQUEST/1: ARRAY/77 does not exist\n"},
        Case{
            "NoPlant", "REQUEST/1,F2=PINVAL(1,1)\\F3=POUVAL(1,1)",
            "16:21: error: REQUEST/1: PINPUT/1 does not exist\n16:36: error: REQUEST/1: POUTPUT/1 does not exist\n"},
        Case{"NoSensor", "REQUEST/1,F2=SENVAL(1)", "16:21: error: REQUEST/1: SENSOR/1 does not exist\n"},
        Case{"NothingEvaluated", "SENSOR/1,VALUE=1,HALT,FUNCTION=TIME\nREQUEST/1,F2=SENVAL(1)",
             "17:21: error: REQUEST/1: SENSOR/1 has no EVALUATE, so it has no value\n"},
        Case{"Component", "REQUEST/1,F2=ARYVAL(4,3)\\F3=ARYVAL(2,0)",
             "16:23: error: REQUEST/1: ARRAY/4 has 2 elements, so the second argument must be 1 to 2\n"
             "16:38: error: REQUEST/1: ARRAY/2 has 1 elements, so the second argument must be 1 to 1\n"},
        Case{"OfNoSystem", "REQUEST/1,F2=ARYVAL(1,1)",
             "16:21: error: REQUEST/1: ARRAY/1 belongs to no LSE or TFSISO, so it has no values\n"},
        Case{"Arguments", "REQUEST/1,F2=ARYVAL(1)\\F3=DIF(1+1)",
             "16:14: error: REQUEST/1: ARYVAL takes 2 ids, not 1\n"
             "16:31: error: REQUEST/1: argument 1 of DIF must be an id\n"},
        Case{"Motion", "MOTION/1,I=20,J=10,X,FUNCTION=DIF(9)",
             "16:31: error: MOTION/1: the function must depend on nothing but TIME\n"},
        Case{"MotionByAVariable", "VARIABLE/2,FUNCTION=DIF(9)\nMOTION/1,I=20,J=10,X,FUNCTION=VARVAL(2)",
             "17:31: error: MOTION/1: in VARIABLE/2: the function must depend on nothing but TIME\n"},
        Case{
            "Constraint", "GCON/1,I=20,FUNCTION=DX(20,10)-DIF(9)",
            "16:32: error: GCON/1: a constraint cannot depend on states of DIFF, LSE and TFSISO or on SENVAL, whose "
            "accelerations nobody tells\n"},
        Case{
            "AccelerationInAForce",
            "DIFF/1,FUNCTION=ACCX(20)\nSFORCE/1,ROTATIONAL,I=20,J=10,FUNCTION=DIF(1)+DIF1(1)",
            "17:47: error: SFORCE/1: in DIF1(1): a force cannot depend on accelerations or reactions, which are known "
            "only when all forces are\n"},
        Case{
            "Loop",
            "VARIABLE/2,FUNCTION=ARYVAL(3,1)\nARRAY/7,U,VAR=2\nLSE/1,X=1,U=7,Y=3,A=1,D=1\n"
            "SFORCE/1,ROTATIONAL,I=20,J=10,FUNCTION=VARVAL(2)",
            "16:21: error: VARIABLE/2: in ARYVAL(3,1): in VARIABLE/2: ARYVAL(3,1) depends on itself; implicit "
            "variables are not supported\n"
            "19:40: error: SFORCE/1: in VARIABLE/2: in ARYVAL(3,1): VARIABLE/2 depends on itself; implicit variables "
            "are not supported\n"}),
    getName);

// A state is no loop: it is what it is, whatever its derivative depends on.
TEST(ControlLoops, AStateCutsThem) {
    EXPECT_EQ(findMistakes("VARIABLE/2,FUNCTION=DIF(1)\nDIFF/1,FUNCTION=-VARVAL(2)+DIF1(2)\n"
                           "DIFF/2,FUNCTION=VARVAL(2)\nSFORCE/1,ROTATIONAL,I=20,J=10,FUNCTION=DIF1(1)"),
              "");
}

// What names a statement with errors is not wrong on that account.
TEST(ControlMistakes, DoNotBringOthers) {
    Diagnostics diagnostics;
    const std::string text =
        Model + std::string(
                    "ARRAY/8,X,QQQ\nMATRIX/8,M=1,N=1,VALUES=1,2\nDIFF/8,QQQ\nSENSOR/8,QQQ\n"
                    "PINPUT/8,QQQ\nLSE/1,X=1,Y=3,A=8,C=1\nLSE/2,X=8,A=1\nREQUEST/1,F2=DIF(8)+"
                    "DIF1(8)+ARYVAL(8,1)+ARYVAL(1,1)+ARYVAL(3,1)+SENVAL(8)+PINVAL(8,3)\nEND\n");
    const Dataset dataset = readDataset(text, diagnostics);
    const size_t ofReading = diagnostics.size();
    jprim::findMistakes(dataset, diagnostics);
    EXPECT_EQ(ofReading, 5u) << testing::formatAll(diagnostics);
    EXPECT_EQ(diagnostics.size(), ofReading) << testing::formatAll(diagnostics);
}

}  // namespace
}  // namespace jprim
