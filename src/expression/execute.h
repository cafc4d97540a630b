// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_EXECUTE_H_
#define JPRIM_SRC_EXPRESSION_EXECUTE_H_

#include "expression/instruction.h"

namespace jprim {

/// How execute() sees the registers: as values alone …
struct ValuesOnly {
    template <class T>
    static const T& get(const Taylor<T>& r) {
        return r.value;
    }
    template <class T>
    static void set(Taylor<T>& r, const T& value) {
        r.value = value;
    }
};

/// … or as values with two time derivatives.
struct WithDerivatives {
    template <class T>
    static const Taylor<T>& get(const Taylor<T>& r) {
        return r;
    }
    template <class T>
    static void set(Taylor<T>& r, const Taylor<T>& value) {
        r = value;
    }
};

/// Does one instruction.
template <class Access>
void execute(const Instruction& instruction, const Curves& curves, Registers& registers);

extern template void execute<ValuesOnly>(const Instruction&, const Curves&, Registers&);
extern template void execute<WithDerivatives>(const Instruction&, const Curves&, Registers&);

}  // namespace jprim

#endif
