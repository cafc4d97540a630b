// SPDX-License-Identifier: Apache-2.0
#include "expression/shaping.h"

namespace jprim {
namespace {

// (x - x0)/(x1 - x0), held within 0 and 1.
Operand buildPart(ProgramBuilder& b, Operand x, const StepCorners& corners) {
    const Operand part = b.divide(b.subtract(x, corners.x0), b.subtract(corners.x1, corners.x0));
    return b.max(b.number(0), b.min(b.number(1), part));
}

// (1 - w) h0 + w h1: exactly h0 and h1 at the ends.
Operand buildBlend(ProgramBuilder& b, Operand w, const StepCorners& corners) {
    return b.add(b.multiply(b.subtract(b.number(1), w), corners.h0), b.multiply(w, corners.h1));
}

// k p^e - v STEP(p, 0, 0, d, c): the load of a penetration p that grows at the rate v, if it pushes.
Operand buildPush(ProgramBuilder& b, Operand p, Operand growth, const Contact& contact) {
    const Operand zero = b.number(0);
    const Operand spring = b.multiply(contact.stiffness, b.power(p, contact.exponent));
    const Operand damping = buildStep(b, p, {zero, zero, contact.depth, contact.damping});
    return b.max(zero, b.add(spring, b.multiply(growth, damping)));
}

}  // namespace

Operand buildStep(ProgramBuilder& b, Operand x, const StepCorners& corners) {
    const Operand s = buildPart(b, x, corners);
    const Operand w = b.multiply(b.multiply(s, s), b.subtract(b.number(3), b.multiply(b.number(2), s)));
    return buildBlend(b, w, corners);
}

Operand buildStep5(ProgramBuilder& b, Operand x, const StepCorners& corners) {
    const Operand s = buildPart(b, x, corners);
    const Operand cube = b.multiply(b.multiply(s, s), s);
    const Operand w = b.multiply(cube, buildPolynomial(b, s, {b.number(10), b.number(-15), b.number(6)}));
    return buildBlend(b, w, corners);
}

Operand buildHavsin(ProgramBuilder& b, Operand x, const StepCorners& corners) {
    const Operand angle = b.multiply(b.number(SimTK::Pi), buildPart(b, x, corners));
    const Operand w = b.multiply(b.number(0.5), b.subtract(b.number(1), b.call(Function::Cos, angle)));
    return buildBlend(b, w, corners);
}

Operand buildImpact(ProgramBuilder& b, Operand x, Operand rate, Operand x1, const Contact& contact) {
    const Operand penetration = b.subtract(x1, x), zero = b.number(0);
    const Operand push = buildPush(b, penetration, b.negate(rate), contact);
    return b.select(penetration, zero, zero, push);
}

Operand buildBistop(ProgramBuilder& b, Operand x, Operand rate, Operand x1, Operand x2,
                    const Contact& contact) {
    const Operand penetration = b.subtract(x, x2);
    const Operand push = b.negate(buildPush(b, penetration, rate, contact));
    const Operand below = buildImpact(b, x, rate, x1, contact);
    return b.select(penetration, below, below, push);
}

Operand buildPolynomial(ProgramBuilder& b, Operand u, const std::vector<Operand>& a) {
    Operand sum = a.back();
    for (std::size_t k = a.size() - 1; k-- > 0;) sum = b.add(a[k], b.multiply(u, sum));
    return sum;
}

Operand buildChebyshev(ProgramBuilder& b, Operand u, const std::vector<Operand>& a) {
    // T_0 = 1, T_1 = u, T_k+1 = 2u T_k - T_k-1.
    Operand T = b.number(1), next = u, sum = a[0];
    const Operand twice = b.multiply(b.number(2), u);
    for (std::size_t k = 1; k < a.size(); ++k) {
        sum = b.add(sum, b.multiply(a[k], next));
        const Operand afterNext = b.subtract(b.multiply(twice, next), T);
        T = next;
        next = afterNext;
    }
    return sum;
}

Operand buildFourier(ProgramBuilder& b, Function f, Operand u, const std::vector<Operand>& a) {
    Operand sum = a[0];
    for (std::size_t k = 1; k < a.size(); ++k) {
        const Operand harmonic = b.call(f, b.multiply(b.number(static_cast<SimTK::Real>(k)), u));
        sum = b.add(sum, b.multiply(a[k], harmonic));
    }
    return sum;
}

}  // namespace jprim
