// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_SHAPING_H_
#define JPRIM_SRC_EXPRESSION_SHAPING_H_

#include <vector>

#include "expression/program.h"

/// @file
/// Adams' shaping functions, composed of elementary operations. The arguments are in Adams' order.
namespace jprim {

/// The corners of a step: h0 up to x0, h1 from x1 on. If x0 > x1 it is run through the other way.
struct StepCorners {
    Operand x0, h0, x1, h1;
};

/// Between the corners, with s = (x - x0)/(x1 - x0): h0 + (h1 - h0) s^2 (3 - 2s). One continuous derivative.
Operand buildStep(ProgramBuilder& builder, Operand x, const StepCorners& corners);

/// The same with s^3 (10 - 15s + 6s^2). Two continuous derivatives.
Operand buildStep5(ProgramBuilder& builder, Operand x, const StepCorners& corners);

/// The same with (1 - cos(pi s))/2. One continuous derivative.
Operand buildHavsin(ProgramBuilder& builder, Operand x, const StepCorners& corners);

/// A stop at x1 that pushes towards larger x. Below x1, with v the rate of x:
///     max(0, k (x1 - x)^e - v STEP(x, x1 - d, c, x1, 0)), else 0.
struct Contact {
    Operand stiffness;  ///< k
    Operand exponent;   ///< e
    Operand damping;    ///< c, reached
    Operand depth;      ///< at this penetration d
};
Operand buildImpact(ProgramBuilder& builder, Operand x, Operand rate, Operand x1, const Contact& contact);

/// Stops at both ends of a gap: as buildImpact() below x1, above x2
///     min(0, -k (x - x2)^e - v STEP(x, x2, 0, x2 + d, c)).
Operand buildBistop(ProgramBuilder& builder, Operand x, Operand rate, Operand x1, Operand x2,
                    const Contact& contact);

/// The sum of a[k] u^k.
Operand buildPolynomial(ProgramBuilder& builder, Operand u, const std::vector<Operand>& a);

/// The sum of a[k] T_k(u), Chebyshev polynomials of the first kind.
Operand buildChebyshev(ProgramBuilder& builder, Operand u, const std::vector<Operand>& a);

/// a[0] plus the sum of a[k] f(k u) from k = 1, where f is the sine or cosine.
Operand buildFourier(ProgramBuilder& builder, Function f, Operand u, const std::vector<Operand>& a);

}  // namespace jprim

#endif
