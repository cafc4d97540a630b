// SPDX-License-Identifier: Apache-2.0
#include "expression/instruction.h"

namespace jprim {

Signature getSignature(Operation operation) {
    switch (operation) {
        case Operation::Add:
        case Operation::Subtract:
        case Operation::Multiply:
        case Operation::Divide:
        case Operation::Call:
        case Operation::Curve: return {"ss", false};
        case Operation::Negate: return {"s", false};
        case Operation::Select: return {"ssss", false};
        case Operation::Dot: return {"vv", false};
        case Operation::Component: return {"v", false};
        case Operation::Vector: return {"sss", true};
        case Operation::AddVectors:
        case Operation::SubtractVectors:
        case Operation::Cross: return {"vv", true};
        case Operation::Scale: return {"sv", true};
    }
    return {"", false};
}

}  // namespace jprim
