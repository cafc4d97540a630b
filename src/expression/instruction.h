// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_INSTRUCTION_H_
#define JPRIM_SRC_EXPRESSION_INSTRUCTION_H_

#include <array>
#include <vector>

#include "SimTKcommon.h"
#include "expression/taylor.h"

/// @file
/// What a Program is made of; of interest to the builder and the evaluation only.
namespace jprim {

/// Real functions of one real argument, radians where an angle is meant. Aint cuts off the fraction, Anint
/// rounds halves away from zero.
enum class Function {
    Abs,
    Acos,
    Aint,
    Anint,
    Asin,
    Atan,
    Cos,
    Cosh,
    Exp,
    Log,
    Log10,
    Sin,
    Sinh,
    Sqrt,
    Tan,
    Tanh
};

/// The elementary operations. s is a scalar and v a vector in the lists of arguments.
enum class Operation {
    Add,              ///< s, s
    Subtract,         ///< s, s
    Negate,           ///< s
    Multiply,         ///< s, s
    Divide,           ///< s, s
    Call,             ///< s; detail: the Function
    Power,            ///< s, s
    Mod,              ///< s, s
    Atan2,            ///< y, x
    Angle,            ///< y, x; detail: which of the remembered angles
    Curve,            ///< x, z; detail: which of the program's curves
    Select,           ///< s, then the results if it is < 0, = 0, > 0
    Dot,              ///< v, v
    Component,        ///< v; detail: the axis
    Vector,           ///< s, s, s
    AddVectors,       ///< v, v
    SubtractVectors,  ///< v, v
    NegateVector,     ///< v
    Scale,            ///< s, v
    Cross             ///< v, v
};

/// The arguments of an operation, a letter each, and whether its result is a vector.
struct Signature {
    const char* arguments;
    bool isVector;
};
Signature getSignature(Operation operation);

/// result = operation(arguments). Scalars and vectors have registers of their own.
struct Instruction {
    Operation operation;
    int detail = 0;
    std::array<int, 4> arguments{-1, -1, -1, -1};
    int result = -1;
};

/// The values that instructions read and write.
struct Registers {
    std::vector<Taylor<SimTK::Real>> scalars;
    std::vector<Taylor<SimTK::Vec3>> vectors;
};

}  // namespace jprim

#endif
