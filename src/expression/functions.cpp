// SPDX-License-Identifier: Apache-2.0
#include "expression/functions.h"

#include <cmath>

namespace jprim {

using SimTK::Real;

Real calcFunction(Function function, Real x, Real y) {
    switch (function) {
        case Function::Abs: return std::abs(x);
        case Function::Acos: return std::acos(x);
        case Function::Aint: return std::trunc(x);
        case Function::Anint: return std::round(x);
        case Function::Asin: return std::asin(x);
        case Function::Atan: return std::atan(x);
        case Function::Cos: return std::cos(x);
        case Function::Cosh: return std::cosh(x);
        case Function::Exp: return std::exp(x);
        case Function::Log: return std::log(x);
        case Function::Log10: return std::log10(x);
        case Function::Sin: return std::sin(x);
        case Function::Sinh: return std::sinh(x);
        case Function::Sqrt: return std::sqrt(x);
        case Function::Tan: return std::tan(x);
        case Function::Tanh: return std::tanh(x);
        case Function::Power: return std::pow(x, y);
        case Function::Mod: return std::fmod(x, y);
        case Function::Atan2: return std::atan2(x, y);
        case Function::Unwind: return x + 2 * SimTK::Pi * std::round((y - x) / (2 * SimTK::Pi));
    }
    return SimTK::NaN;
}

namespace {

// Of asin. 1 - x^2 as a product keeps its digits near the ends.
Partials calcAsinPartials(Real x) {
    const Real square = (1 - x) * (1 + x);
    const Real slope = 1 / std::sqrt(square);
    return {slope, 0, x * slope / square, 0, 0};
}

Partials calcPowerPartials(Real x, Real y, Real f) {
    const Real log = std::log(x), oneLess = std::pow(x, y - 1);
    return {y * oneLess, f * log, y * (y - 1) * std::pow(x, y - 2), oneLess * (1 + y * log), f * log * log};
}

Partials calcAtan2Partials(Real x, Real y) {
    const Real r = std::hypot(x, y);
    const Real sine = x / r, cosine = y / r;
    const Real bend = 2 * sine * cosine / r / r;
    return {cosine / r, -sine / r, -bend, (sine - cosine) * (sine + cosine) / r / r, bend};
}

Partials calcFormalPartials(Function function, Real x, Real y, Real f) {
    const auto ofX = [](Real first, Real second) { return Partials{first, 0, second, 0, 0}; };
    const Real square = 1 + x * x;
    switch (function) {
        case Function::Abs: return ofX(Real(x > 0) - Real(x < 0), 0);
        case Function::Acos: {
            const Partials asin = calcAsinPartials(x);
            return ofX(-asin.x, -asin.xx);
        }
        case Function::Aint:
        case Function::Anint: return {};
        case Function::Asin: return calcAsinPartials(x);
        case Function::Atan: return ofX(1 / square, -2 * x / (square * square));
        case Function::Cos: return ofX(-std::sin(x), -f);
        case Function::Cosh: return ofX(std::sinh(x), f);
        case Function::Exp: return ofX(f, f);
        case Function::Log: return ofX(1 / x, -1 / (x * x));
        case Function::Log10: return ofX(SimTK::Log10E / x, -SimTK::Log10E / (x * x));
        case Function::Sin: return ofX(std::cos(x), -f);
        case Function::Sinh: return ofX(std::cosh(x), f);
        case Function::Sqrt: return ofX(0.5 / f, -0.25 / (f * x));
        case Function::Tan: return ofX(1 + f * f, 2 * f * (1 + f * f));
        case Function::Tanh: return ofX((1 - f) * (1 + f), -2 * f * (1 - f) * (1 + f));
        case Function::Power: return calcPowerPartials(x, y, f);
        case Function::Mod: return {1, (f - x) / y, 0, 0, 0};
        case Function::Atan2: return calcAtan2Partials(x, y);
        case Function::Unwind: return {1, 0, 0, 0, 0};
    }
    return {};
}

}  // namespace

Partials calcPartials(Function function, Real x, Real y, Real f) {
    Partials partials = calcFormalPartials(function, x, y, f);
    for (Real* d : {&partials.x, &partials.y, &partials.xx, &partials.xy, &partials.yy})
        if (!std::isfinite(*d)) *d = 0;
    return partials;
}

}  // namespace jprim
