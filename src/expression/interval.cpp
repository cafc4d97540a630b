// SPDX-License-Identifier: Apache-2.0
#include "expression/interval.h"

#include <algorithm>
#include <cmath>

namespace jprim {

using SimTK::Pi;
using SimTK::Real;

namespace {

// Of values one of which may be no number.
Interval span(std::initializer_list<Real> values) {
    if (std::any_of(values.begin(), values.end(), [](Real x) { return std::isnan(x); })) return {};
    return {std::min(values), std::max(values)};
}

}  // namespace

bool Interval::isBounded() const {
    return std::isfinite(low) && std::isfinite(high);
}

Interval operator+(const Interval& a, const Interval& b) {
    return span({a.low + b.low, a.high + b.high});
}

Interval operator-(const Interval& a, const Interval& b) {
    return span({a.low - b.high, a.high - b.low});
}

Interval operator-(const Interval& a) {
    return {-a.high, -a.low};
}

Interval operator*(const Interval& a, const Interval& b) {
    return span({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
}

Interval operator/(const Interval& a, const Interval& b) {
    if (b.contains(0)) return {};
    return span({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high});
}

Interval unite(const Interval& a, const Interval& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

namespace {

// Of sin or cos: from the values at both ends and at the turning points in between. `firstTop` is that of 1, in halves of
// a turn.
Interval calcWaveRange(Function function, const Interval& x, Real firstTop) {
    if (!x.isBounded()) return {-1, 1};
    const Real first = std::ceil(x.low / Pi - firstTop), last = std::floor(x.high / Pi - firstTop);
    Interval range = span({calcFunction(function, x.low, 0), calcFunction(function, x.high, 0)});
    for (Real k = first; k <= std::min(last, first + 1); ++k) {
        const Real turning = std::fmod(k, 2) == 0 ? 1 : -1;
        range = unite(range, {turning, turning});
    }
    return range;
}

Interval calcPowerRange(const Interval& x, const Interval& y) {
    const bool isWhole = y.low == y.high && y.low == std::round(y.low);
    if (x.low < 0 && !(isWhole && y.low > 0)) return {};
    const auto ends = span(
        {std::pow(x.low, y.low), std::pow(x.low, y.high), std::pow(x.high, y.low), std::pow(x.high, y.high)});
    return x.contains(0) && y.low > 0 ? unite(ends, {0, 0}) : ends;
}

}  // namespace

Interval calcRange(Function function, const Interval& x, const Interval& y) {
    const auto atEnds = [&] {
        return span({calcFunction(function, x.low, y.low), calcFunction(function, x.high, y.low)});
    };
    if (x.low == x.high && y.low == y.high) return atEnds();
    switch (function) {
        case Function::Acos:
        case Function::Aint:
        case Function::Anint:
        case Function::Asin:
        case Function::Atan:
        case Function::Exp:
        case Function::Log:
        case Function::Log10:
        case Function::Sinh:
        case Function::Sqrt:
        case Function::Tanh: return atEnds();
        case Function::Abs: return x.contains(0) ? unite(atEnds(), {0, 0}) : atEnds();
        case Function::Cosh: return x.contains(0) ? unite(atEnds(), {1, 1}) : atEnds();
        case Function::Cos: return calcWaveRange(function, x, 0);
        case Function::Sin: return calcWaveRange(function, x, 0.5);
        case Function::Tan: {
            const bool hasPole = std::floor(x.low / Pi + 0.5) != std::floor(x.high / Pi + 0.5);
            return hasPole || !x.isBounded() ? Interval{} : atEnds();
        }
        case Function::Power: return calcPowerRange(x, y);
        case Function::Mod: {
            const bool isSmooth = y.low == y.high && std::trunc(x.low / y.low) == std::trunc(x.high / y.low);
            if (isSmooth) return atEnds();
            const Real most = std::max(std::abs(y.low), std::abs(y.high));
            return {x.low < 0 ? -most : 0, x.high > 0 ? most : 0};
        }
        case Function::Atan2: return {-Pi, Pi};
        case Function::Unwind: return {};
    }
    return {};
}

}  // namespace jprim
