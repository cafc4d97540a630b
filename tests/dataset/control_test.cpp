// SPDX-License-Identifier: Apache-2.0
// ARRAY, MATRIX, DIFF, LSE, TFSISO, PINPUT, POUTPUT, EVALUATE: what they say, and what they must not.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dataset/error_cases.h"
#include "dataset/reading.h"

namespace jprim {
namespace {

TEST(DatasetControl, Arrays) {
    const Dataset d = readGood(
        "VARIABLE/1, FUNCTION=1\nARRAY/1, IC, NUMBERS=1,-2, S=2\nARRAY/2, NUM=3\nARRAY/3, U, VARIABLES=1,\n1\n"
        "AR/4, X, SIZE=3\nARRAY/5, Y\nARRAY/6, SIZE=2");
    ASSERT_EQ(d.arrays.size(), 6u);
    EXPECT_EQ(d.arrays[0].numbers, (std::vector<double>{1, -2}));
    EXPECT_EQ(d.arrays[0].size, 2);
    EXPECT_EQ(d.arrays[1].type, ArrayType::Constants);
    EXPECT_EQ(d.arrays[2].type, ArrayType::Inputs);
    EXPECT_EQ(d.arrays[2].variables, (std::vector<int>{1, 1}));
    EXPECT_EQ(d.arrays[3].type, ArrayType::States);
    EXPECT_EQ(d.arrays[4].type, ArrayType::Outputs);
    EXPECT_EQ(d.arrays[5].size, 2);
}

// All are the matrix (1 2 3; 4 5 6), in whichever order it is written.
TEST(DatasetControl, MatricesAreTheSameByRowsAndColumns) {
    const Dataset d = readGood(
        "MATRIX/1, M=2, N=3, VALUES=1,2,3,4,5,6\nMATRIX/2, FULL=RORDER, VALUES=1,2,3,4,5,6, M=2, N=3\n"
        "MATRIX/3, FULL, CORDER, M=2, N=3, VALUES=1,4,2,5,3,6\nMAT/4, FULL=CORD, M=2, N=3, VALUES=1,4,2,5,3,6\n"
        "MATRIX/5, SPARSE, M=2, N=3, VALUES=1,1,1, 2,1,4, 2,2,5, 1,3,3, 1,2,2, 2,3,6");
    ASSERT_EQ(d.matrices.size(), 5u);
    for (const MatrixStatement& matrix : d.matrices) {
        EXPECT_EQ(matrix.rows, 2);
        EXPECT_EQ(matrix.columns, 3);
        EXPECT_EQ(matrix.values, (std::vector<double>{1, 2, 3, 4, 5, 6})) << matrix.id;
    }
    EXPECT_EQ(readGood("MATRIX/1, SPARSE, M=2, N=2, VALUES=2,1,7").matrices[0].values,
              (std::vector<double>{0, 0, 7, 0}));
}

TEST(DatasetControl, Equations) {
    const Dataset d = readGood(
        "VARIABLE/1, IC=2, FUNCTION=1\nARRAY/1, X\nARRAY/2, U, VAR=1\nARRAY/3, Y\nARRAY/4, NUM=1\nARRAY/5, X\n"
        "ARRAY/6, Y\nMATRIX/1, M=1, N=1, VALUES=-2\nDIFF/1, IC=1.5, STATIC_HOLD, FUNCTION=-DIF(1)\n"
        "DIFF/2, IMPLICIT, IC=1,2, FUNCTION=DIF1(2)+1\nLSE/1, X=1, U=2, Y=3, IC=4, A=1, B=1, C=1, D=1, STAT\n"
        "TFSISO/1, X=5, U=2, Y=6, NUM=1, DEN=1,0.5\nSENSOR/1, VALUE=1, EVALUATE=2*TIME\\FUNCTION=TIME");
    ASSERT_EQ(d.diffs.size(), 2u);
    EXPECT_EQ(d.diffs[0].ic, std::vector<double>{1.5});
    EXPECT_TRUE(d.diffs[0].staticHold);
    EXPECT_TRUE(d.diffs[1].implicit);
    EXPECT_EQ(d.diffs[1].ic, (std::vector<double>{1, 2}));
    ASSERT_EQ(d.lses.size(), 1u);
    EXPECT_EQ(d.lses[0].ic, 4);
    EXPECT_EQ(d.lses[0].d, 1);
    ASSERT_EQ(d.tfsisos.size(), 1u);
    EXPECT_EQ(d.tfsisos[0].denominator, (std::vector<double>{1, 0.5}));
    EXPECT_EQ(d.sensors[0].evaluate->text, "2*TIME");
    EXPECT_EQ(d.variables[0].ic, 2);
}

// Whatever numbers they have and however they are written; reading makes the round trip through the writer.
TEST(DatasetControl, RandomSystemsSurviveWriting) {
    std::mt19937 random(1);
    const auto choose = [&random](int count) {
        return std::uniform_int_distribution<int>(0, count - 1)(random);
    };
    const auto list = [&](int count) {
        std::string text;
        for (int k = 0; k < count; ++k) {
            const double number = std::normal_distribution<double>()(random) * std::pow(10., choose(40) - 20);
            text += (k == 0 ? "" : ",") + std::to_string(number) + (choose(3) == 0 ? "E-7" : "");
        }
        return text;
    };
    for (int trial = 0; trial < 100; ++trial) {
        const int n = choose(4) + 1, m = choose(3) + 1;
        const std::string rows = std::to_string(n), columns = std::to_string(m);
        std::string text =
            "VARIABLE/1, IC=" + list(1) + ", FUNCTION=1\nARRAY/1, X\nARRAY/2, U, VAR=1\nARRAY/3, Y\n";
        text += "ARRAY/4, IC, NUMBERS=" + list(n) + (choose(2) == 0 ? ", SIZE=" + rows : "") + "\nMATRIX/1";
        text += choose(2) == 0 ? ", FULL=CORDER" : ", RORDER";
        text += ", M=" + rows + ", N=" + columns + ", VALUES=" + list(n * m) +
                "\nMATRIX/2, SPARSE, M=" + rows + ", N=" + columns + ", VALUES=" + rows + ",1," + list(1) +
                "\nDIFF/1, IC=" + list(choose(2) + 1) + (choose(2) == 0 ? ", IMPLICIT" : "") +
                ", FUNCTION=" + list(1) + "\nLSE/1, X=1, A=1, IC=4" +
                (choose(2) == 0 ? ", U=2, B=2" : ", Y=3, C=2, STATIC_HOLD") +
                "\nARRAY/5, X\nARRAY/6, Y\nTFSISO/1, X=5, U=2"
                ", Y=6, NUM=" +
                list(choose(n + 1) + 1) + ", DEN=" + list(n) + ",1";
        EXPECT_EQ(readGood(text).counts.errors, 0);
    }
}

TEST(DatasetControl, PlantsAreConnectedToNothing) {
    const Reading reading = readInModel("VARIABLE/7, FUNCTION=1\nPINPUT/1, VARIABLES=7,\n7\nPOUT/2, VAR=7");
    EXPECT_EQ(
        reading.findings,
        "4:1: warning: PINPUT/1 is connected to nothing: the inputs that it lists for LINEAR and for control "
        "systems outside are read by functions alone, as PINVAL\n"
        "6:1: warning: POUTPUT/2 is connected to nothing: the outputs that it lists for LINEAR and for control "
        "systems outside are read by functions alone, as POUVAL");
    EXPECT_EQ(reading.dataset.plantInputs[0].variables, (std::vector<int>{7, 7}));
    EXPECT_EQ(reading.dataset.counts.built, 7);
}

TEST(DatasetControl, ArrayErrors) {
    check({
        {"no values", "ARRAY/1, IC", "3:1: error: ARRAY/1 needs NUMBERS or SIZE"},
        {"no inputs", "ARRAY/1, U, SIZE=1", "3:1: error: ARRAY/1 needs VARIABLES: VARIABLES="},
        {"wrong length", "ARRAY/1, NUM=1,2,3, SIZE=2",
         "3:21: error: SIZE of ARRAY/1 is 2, but 3 NUMBERS are given"},
        {"numbers of states", "ARRAY/1, X, NUM=1", "3:13: error: NUMBERS of ARRAY/1 is for an IC only"},
        {"two types", "ARRAY/1, X, Y", "3:13: error: ARRAY/1 cannot be both X and Y"},
        {"missing variable", "ARRAY/1, U, VAR=9",
         "3:17: error: VARIABLES of ARRAY/1: there is no VARIABLE/9"},
        {"no size", "ARRAY/1, X, SIZE=0", "3:18: error: SIZE of ARRAY/1: '0' is not a whole number from 1"},
        {"too large", "ARRAY/1, SIZE=2000000",
         "3:10: error: SIZE of ARRAY/1 is 2000000; the largest is 1000000"},
        {"two sizes", "ARRAY/1, X, SIZE=1,2", "3:13: error: SIZE of ARRAY/1 takes 1 number, not 2"},
        {"missing plant variable", "PINPUT/1, VAR=9",
         "3:1: warning: PINPUT/1 is connected to nothing: the inputs that it lists for LINEAR and for control systems "
         "outside are read by functions alone, as PINVAL\n"
         "3:15: error: VARIABLES of PINPUT/1: there is no VARIABLE/9"},
    });
}

TEST(DatasetControl, MatrixErrors) {
    check({
        {"no size", "MATRIX/1, VALUES=1",
         "3:1: error: MATRIX/1 needs M: M=\n3:1: error: MATRIX/1 needs N: N="},
        {"in a file", "MATRIX/1, FILE=a.txt, NAME=b",
         "3:11: error: FILE of MATRIX/1: matrices in files are not read; write M, N and VALUES"},
        {"too few values", "MATRIX/1, M=2, N=2, VALUES=1,2,3",
         "3:21: error: VALUES of MATRIX/1 takes 4 numbers, M times N, not 3"},
        {"no triples", "MATRIX/1, SPARSE, M=2, N=2, VALUES=1,2",
         "3:29: error: VALUES of MATRIX/1 takes row, column and value of each entry, so their number is a multiple of 3, "
         "not 2"},
        {"no such row", "MATRIX/1, SPARSE, M=2, N=2, VALUES=3,1,5",
         "3:36: error: VALUES of MATRIX/1: 3 is not a row; these are whole numbers from 1 to 2"},
        {"no whole column", "MATRIX/1, SPARSE, M=2, N=2, VALUES=1,1.5,5",
         "3:38: error: VALUES of MATRIX/1: 1.5 is not a column; these are whole numbers from 1 to 2"},
        {"both", "MATRIX/1, SPARSE, FULL, M=1, N=1, VALUES=1",
         "3:11: error: MATRIX/1 takes SPARSE or FULL, not both"},
        {"too large", "MATRIX/1, SPARSE, M=9999, N=9999, VALUES=1,1,1",
         "3:1: error: MATRIX/1 has 9999 times 9999 values; at most 1000000 are possible"},
    });
}

TEST(DatasetControl, EquationErrors) {
    const std::string arrays =
        "VARIABLE/1, FUNCTION=1\nARRAY/1, X\nARRAY/2, U, VAR=1\nARRAY/3, Y\nMATRIX/1, M=1, N=1, VALUES=-2\n";
    check({
        {"no function", "DIFF/1, IC=1", "3:1: error: DIFF/1 needs FUNCTION: FUNCTION="},
        {"held in dynamics", "DIFF/1, DYNAMIC_HOLD, FUNCTION=1",
         "3:9: error: DYNAMIC_HOLD of DIFF/1 is not supported yet"},
        {"user function", "DIFF/1, FUNCTION=USER(1)",
         "3:18: error: FUNCTION of DIFF/1 calls a user subroutine, and none can be run; write it as an expression"},
        {"missing array", "LSE/1, X=1, A=1",
         "3:10: error: X of LSE/1: there is no ARRAY/1\n3:15: error: A of LSE/1: there is no MATRIX/1"},
        {"input without array", arrays + "LSE/1, X=1, A=1, B=1", "8:1: error: LSE/1 needs U: U="},
        {"output without array", arrays + "LSE/1, X=1, A=1, C=1", "8:1: error: LSE/1 needs Y: Y="},
        {"array without output", arrays + "LSE/1, X=1, A=1, Y=3", "8:18: error: Y of LSE/1 needs C or D"},
        {"array without input", arrays + "LSE/1, X=1, A=1, U=2",
         "8:18: warning: U of LSE/1 has no effect without B or D"},
        {"improper", arrays + "TFSISO/1, X=1, U=2, Y=3, NUM=1,2,3, DEN=1,2",
         "8:26: error: NUMERATOR of TFSISO/1 has 3 coefficients; it takes no more than DENOMINATOR, 2"},
        {"no order", arrays + "TFSISO/1, X=1, U=2, Y=3, NUM=1, DEN=2",
         "8:33: error: DENOMINATOR of TFSISO/1 is a constant; a factor needs no transfer function"},
        {"highest is zero", arrays + "TFSISO/1, X=1, U=2, Y=3, NUM=1, DEN=2,0",
         "8:33: error: the last coefficient of DENOMINATOR of TFSISO/1, that of the highest power, is 0; leave it out"},
        {"compiled", "GSE/1, X=1, U=2, Y=3, NS=2, NO=1, FUNCTION=USER(1)",
         "3:1: error: GSE/1 cannot be run: its equations are compiled code; write it as LSE or TFSISO"},
    });
}

}  // namespace
}  // namespace jprim
