// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_INSTRUCTION_H_
#define JPRIM_SRC_EXPRESSION_INSTRUCTION_H_

#include <array>
#include <vector>

#include "expression/curve.h"
#include "expression/functions.h"
#include "expression/taylor.h"

/// @file
/// What a Program is made of; of interest to the builder and the evaluation only.
namespace jprim {

/// The elementary operations. s is a scalar and v a vector in the lists of arguments. From Vector on the result
/// is a vector.
enum class Operation {
    Add,              ///< s, s
    Subtract,         ///< s, s
    Negate,           ///< s
    Multiply,         ///< s, s
    Divide,           ///< s, s
    Call,             ///< x, y; detail: the Function. The argument of a function of x alone stands twice.
    Curve,            ///< x, z; detail: which of the program's curves
    Select,           ///< s, then the results if it is < 0, = 0, > 0
    Dot,              ///< v, v
    Norm,             ///< v
    Component,        ///< v; detail: the axis
    Vector,           ///< s, s, s
    AddVectors,       ///< v, v
    SubtractVectors,  ///< v, v
    Scale,            ///< s, v
    Cross             ///< v, v
};

/// The arguments of an operation, a letter each.
const char* getShapes(Operation operation);

inline bool hasVectorResult(Operation operation) {
    return operation >= Operation::Vector;
}

/// result = operation(arguments). Scalars and vectors have registers of their own.
struct Instruction {
    Operation operation;
    int detail = 0;
    std::array<int, 4> arguments{-1, -1, -1, -1};
    int result = -1;
};

/// Which argument is the result of Select. A condition that is no number is the result itself.
inline int findBranch(SimTK::Real condition) {
    if (condition < 0) return 1;
    if (condition == 0) return 2;
    return condition > 0 ? 3 : 0;
}

using Curves = std::vector<std::shared_ptr<const Curve>>;

/// The values that instructions read and write.
struct Registers {
    std::vector<Taylor<SimTK::Real>> scalars;
    std::vector<Taylor<SimTK::Vec3>> vectors;
};

}  // namespace jprim

#endif
