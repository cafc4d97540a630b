// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_EXECUTE_H_
#define JPRIM_SRC_EXPRESSION_EXECUTE_H_

#include <vector>

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

/// The value of the spline as a function of x and z, and its derivatives.
inline SimTK::Real calcCurve(const CurveUse& use, SimTK::Real x, SimTK::Real z) {
    return use.spline.calcDerivative(use.method, x, z, use.order);
}
Partials calcCurvePartials(const CurveUse& use, SimTK::Real x, SimTK::Real z);

/// Does one instruction.
template <class Access>
void execute(const Instruction& instruction, const std::vector<CurveUse>& curves, Registers& registers);

extern template void execute<ValuesOnly>(const Instruction&, const std::vector<CurveUse>&, Registers&);
extern template void execute<WithDerivatives>(const Instruction&, const std::vector<CurveUse>&, Registers&);

}  // namespace jprim

#endif
