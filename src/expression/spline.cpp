// SPDX-License-Identifier: Apache-2.0
#include "jprim/expression/spline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {
namespace {

using SimTK::Real;
using Reals = std::vector<Real>;

constexpr std::size_t LeastPoints = 4;

void requireIncreasing(const std::string& name, const char* what, const Reals& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i]))
            throw Error(name, fmt::format("value {} of {} is not a finite number", i + 1, what));
        if (i > 0 && values[i] <= values[i - 1])
            throw Error(name, fmt::format("the values of {} must increase, but {} follows {}", what,
                                          values[i], values[i - 1]));
    }
}

// (y[i + 1] - y[i]) / (x[i + 1] - x[i]).
Reals calcChords(const Reals& x, const Reals& y) {
    Reals chords(x.size() - 1);
    for (std::size_t i = 0; i < chords.size(); ++i) chords[i] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    return chords;
}

// The slope at a point is a mean of the chords beside it, each weighted by how much the other side bends. Two
// chords are added at each end, as if a parabola went on there.
Reals calcAkimaSlopes(const Reals& x, const Reals& y) {
    const Reals chords = calcChords(x, y);
    const std::size_t n = chords.size();
    Reals m(n + 4);
    std::copy(chords.begin(), chords.end(), m.begin() + 2);
    m[1] = 2 * m[2] - m[3];
    m[0] = 2 * m[1] - m[2];
    m[n + 2] = 2 * m[n + 1] - m[n];
    m[n + 3] = 2 * m[n + 2] - m[n + 1];
    Reals slopes(x.size());
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const Real bendLeft = std::abs(m[i + 1] - m[i]), bendRight = std::abs(m[i + 3] - m[i + 2]);
        const Real bend = bendLeft + bendRight;
        // Straight on both sides: neither chord is the better one.
        slopes[i] =
            bend > 0 ? (bendRight * m[i + 1] + bendLeft * m[i + 2]) / bend : (m[i + 1] + m[i + 2]) / 2;
    }
    return slopes;
}

// With h and c the widths and chords of the intervals, y'' is continuous at point i if
//     d[i-1]/h[i-1] + 2 (1/h[i-1] + 1/h[i]) d[i] + d[i+1]/h[i] = 3 (c[i-1]/h[i-1] + c[i]/h[i]),
// and zero at the ends if 2 d[0] + d[1] = 3 c[0] and d[n-1] + 2 d[n] = 3 c[n-1]: the same equation without the
// interval that is missing. The matrix is tridiagonal with a dominant diagonal: no pivoting is needed.
Reals calcCubicSlopes(const Reals& x, const Reals& y) {
    const Reals chords = calcChords(x, y);
    const std::size_t n = chords.size();
    Reals d(x.size()), upper(x.size());  // the right side, then the solution; the row's last entry
    for (std::size_t i = 0; i <= n; ++i) {
        const Real before = i > 0 ? 1 / (x[i] - x[i - 1]) : 0;
        const Real after = i < n ? 1 / (x[i + 1] - x[i]) : 0;
        Real diagonal = 2 * (before + after);
        d[i] = 3 * ((i > 0 ? chords[i - 1] * before : 0) + (i < n ? chords[i] * after : 0));
        if (i > 0) {
            diagonal -= before * upper[i - 1];
            d[i] -= before * d[i - 1];
        }
        upper[i] = after / diagonal;
        d[i] /= diagonal;
    }
    for (std::size_t i = n; i-- > 0;) d[i] -= upper[i] * d[i + 1];
    return d;
}

// The interval in which to look for x: the last one that begins at or before it, or the first.
std::size_t findInterval(const Reals& x, Real at) {
    const auto after = std::upper_bound(x.begin() + 1, x.end() - 1, at);
    return static_cast<std::size_t>(after - x.begin()) - 1;
}

// The derivative of y + m t + b t^2 + a t^3 at t.
Real calcCubic(Real y, Real m, Real b, Real a, Real t, int order) {
    switch (order) {
        case 0: return y + t * (m + t * (b + t * a));
        case 1: return m + t * (2 * b + t * 3 * a);
        case 2: return 2 * b + 6 * a * t;
        case 3: return 6 * a;
        default: return 0;
    }
}

}  // namespace

InterpolatingSpline::InterpolatingSpline(const std::string& name, Reals x, Reals y)
    : InterpolatingSpline(name, std::move(x), {0}, {std::move(y)}) {}

InterpolatingSpline::InterpolatingSpline(const std::string& name, Reals x, Reals z,
                                         const std::vector<Reals>& families)
    : m_x(std::move(x)), m_z(std::move(z)) {
    if (m_x.size() < LeastPoints)
        throw Error(name, fmt::format("a spline needs at least {} points, not {}", LeastPoints, m_x.size()));
    requireIncreasing(name, "X", m_x);
    requireIncreasing(name, "Z", m_z);
    if (m_z.empty() || m_z.size() != families.size())
        throw Error(name,
                    fmt::format("{} values of Z need as many curves Y, not {}", m_z.size(), families.size()));
    for (const Reals& y : families) {
        if (y.size() != m_x.size())
            throw Error(name, fmt::format("{} values of X need as many of Y, not {}", m_x.size(), y.size()));
        if (!std::all_of(y.begin(), y.end(), [](Real v) { return std::isfinite(v); }))
            throw Error(name, "a value of Y is not a finite number");
        m_curves.push_back({y, calcAkimaSlopes(m_x, y), calcCubicSlopes(m_x, y)});
    }
}

Real InterpolatingSpline::calcOnCurve(const Curve& curve, Method method, Real x, int order) const {
    const Reals& slopes = method == Method::Akima ? curve.akima : curve.cubic;
    if (x < m_x.front()) return calcCubic(curve.y.front(), slopes.front(), 0, 0, x - m_x.front(), order);
    if (x >= m_x.back()) return calcCubic(curve.y.back(), slopes.back(), 0, 0, x - m_x.back(), order);
    const std::size_t i = findInterval(m_x, x);
    const Real width = m_x[i + 1] - m_x[i];
    const Real chord = (curve.y[i + 1] - curve.y[i]) / width;
    const Real first = slopes[i] - chord, last = slopes[i + 1] - chord;
    return calcCubic(curve.y[i], slopes[i], -(2 * first + last) / width, (first + last) / (width * width),
                     x - m_x[i], order);
}

int InterpolatingSpline::countPointsUpTo(Real x) const {
    return static_cast<int>(std::upper_bound(m_x.begin(), m_x.end(), x) - m_x.begin());
}

Real InterpolatingSpline::calcDerivative(Method method, Real x, Real z, int order) const {
    if (m_z.size() == 1 || z <= m_z.front()) return calcOnCurve(m_curves.front(), method, x, order);
    if (z >= m_z.back()) return calcOnCurve(m_curves.back(), method, x, order);
    const std::size_t k = findInterval(m_z, z);
    const Real part = (z - m_z[k]) / (m_z[k + 1] - m_z[k]);
    return (1 - part) * calcOnCurve(m_curves[k], method, x, order) +
           part * calcOnCurve(m_curves[k + 1], method, x, order);
}

Real InterpolatingSpline::calcSlopeInZ(Method method, Real x, Real z, int order) const {
    if (m_z.size() == 1 || z < m_z.front() || z >= m_z.back()) return 0;
    const std::size_t k = findInterval(m_z, z);
    return (calcOnCurve(m_curves[k + 1], method, x, order) - calcOnCurve(m_curves[k], method, x, order)) /
           (m_z[k + 1] - m_z[k]);
}

}  // namespace jprim
