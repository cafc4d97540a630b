// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_DATASET_CONTROL_STATEMENTS_H_
#define JPRIM_DATASET_CONTROL_STATEMENTS_H_

#include <vector>

#include "jprim/base/diagnostic.h"
#include "jprim/dataset/source_text.h"

/// @file
/// The statements of a dataset that describe control systems: ARRAY, MATRIX, DIFF, LSE, TFSISO, PINPUT, POUTPUT. What
/// holds for all statements is said in dataset.h.
namespace jprim {

/// IC: constants, U: inputs, X: states, Y: outputs.
enum class ArrayType { Constants, Inputs, States, Outputs };

/// ARRAY: what ARYVAL(id, k) reads, and what ties LSE and TFSISO to the rest.
struct ArrayStatement {
    SourcePosition where;
    int id = 0;
    ArrayType type = ArrayType::Constants;
    int size = 0;                 ///< 0 if not given
    std::vector<double> numbers;  ///< of Constants; zeros if none are given
    std::vector<int> variables;   ///< of Inputs: ids of VARIABLEs
};

/// MATRIX: constant coefficients of an LSE. Whichever way they are written, they stand here row by row.
struct MatrixStatement {
    SourcePosition where;
    int id = 0;
    int rows = 0;
    int columns = 0;
    std::vector<double> values;
};

/// DIFF: a state z with dz/dt = f, or if it is implicit f = 0, where f depends on DIF1(id).
struct DiffStatement {
    SourcePosition where;
    int id = 0;
    bool implicit = false;
    bool staticHold =
        false;  ///< in statics the state stays what it is, instead of its derivative becoming zero
    std::vector<double> ic;  ///< the state at the start, and of an implicit one a guess of its derivative
    ExpressionText function;
};

/// LSE: dx/dt = A x + B u, y = C x + D u. Ids of ARRAYs and MATRIXes; 0 if there is none.
struct LseStatement {
    SourcePosition where;
    int id = 0;
    int x = 0;
    int u = 0;
    int y = 0;
    int ic = 0;
    int a = 0;
    int b = 0;
    int c = 0;
    int d = 0;
    bool staticHold = false;
};

/// TFSISO: y(s) = numerator(s) / denominator(s) u(s), by coefficients of s^0, s^1, …; at rest at the start.
struct TfsisoStatement {
    SourcePosition where;
    int id = 0;
    int x = 0;
    int u = 0;
    int y = 0;
    std::vector<double> numerator;
    std::vector<double> denominator;
    bool staticHold = false;
};

/// PINPUT or POUTPUT: VARIABLEs that go in and out of the mechanism where it is part of a larger system.
struct PlantStatement {
    SourcePosition where;
    int id = 0;
    std::vector<int> variables;
};

}  // namespace jprim

#endif
