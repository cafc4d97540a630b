// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_FUNCTIONS_H_
#define JPRIM_SRC_EXPRESSION_FUNCTIONS_H_

#include "expression/taylor.h"

namespace jprim {

/// Real functions of x, or of x and y; angles are in radians.
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
    Tanh,
    Power,  ///< x to the power y
    Mod,    ///< x - y trunc(x/y)
    Atan2,  ///< the angle of the point (y, x): the first argument is the sine's
    Unwind  ///< x and whole turns, so many that it is nearest to y, of which it is no further function
};

/// The value; functions of x alone ignore y. Aint cuts off the fraction, Anint rounds halves away from zero.
SimTK::Real calcFunction(Function function, SimTK::Real x, SimTK::Real y);

/// The derivatives of f(x, y) with respect to its arguments.
struct Partials {
    SimTK::Real x = 0, y = 0;
    SimTK::Real xx = 0, xy = 0, yy = 0;
};

/// The derivatives, given the value f as well. Those that are not finite, because they do not exist, are
/// replaced by zero: at the ends of ASIN, at SQRT(0), at the origin of ATAN2, at 0**1.5. At a jump or a bend
/// (AINT, ABS at 0) they are zero too.
Partials calcPartials(Function function, SimTK::Real x, SimTK::Real y, SimTK::Real f);

/// The chain rule: f(x(t), y(t)) and its two time derivatives.
inline Taylor<SimTK::Real> chain(SimTK::Real f, const Partials& d, const Taylor<SimTK::Real>& x,
                                 const Taylor<SimTK::Real>& y) {
    return {f, d.x * x.first + d.y * y.first,
            d.x * x.second + d.y * y.second + d.xx * x.first * x.first + 2 * d.xy * x.first * y.first +
                d.yy * y.first * y.first};
}

}  // namespace jprim

#endif
