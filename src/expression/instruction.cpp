// SPDX-License-Identifier: Apache-2.0
#include "expression/instruction.h"

namespace jprim {

const char* getShapes(Operation operation) {
    switch (operation) {
        case Operation::Add:
        case Operation::Subtract:
        case Operation::Multiply:
        case Operation::Divide:
        case Operation::Call:
        case Operation::Curve: return "ss";
        case Operation::Negate: return "s";
        case Operation::Select: return "ssss";
        case Operation::Dot: return "vv";
        case Operation::Norm:
        case Operation::Component: return "v";
        case Operation::Vector: return "sss";
        case Operation::AddVectors:
        case Operation::SubtractVectors:
        case Operation::Cross: return "vv";
        case Operation::Scale: return "sv";
    }
    return "";
}

}  // namespace jprim
