// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_EXPRESSION_SPLINE_H_
#define JPRIM_EXPRESSION_SPLINE_H_

#include <string>
#include <vector>

#include "SimTKcommon.h"

namespace jprim {

/// A curve y(x), or a family of curves y(x; z), through given points: Adams' SPLINE.
///
/// Between two points a curve is the cubic with the values and slopes of both. The slopes come from one of
/// two methods, so that y has one or two continuous derivatives:
///
/// - Akima: from the five points around, which keeps a bend local (H. Akima, J. ACM 17, 1970, 589-602);
/// - Cubic: y'' continuous, and zero at both ends (the natural spline).
///
/// Between two curves of a family y is linear in z. Beyond the first and last x a curve goes on along its
/// tangent; beyond the first and last z the nearest curve counts. Adams' manual does not state its rules
/// there: these are ours.
class InterpolatingSpline {
public:
    enum class Method { Akima, Cubic };

    /// One curve.
    /// @param name  for messages, for example "SPLINE/7"
    /// @param x     at least 4 abscissae, strictly increasing
    /// @param y     as many values
    /// @throws Error for other data
    InterpolatingSpline(const std::string& name, std::vector<SimTK::Real> x, std::vector<SimTK::Real> y);

    /// A family of curves with the same abscissae.
    /// @param z         at least one parameter, strictly increasing
    /// @param families  for each parameter as many values as there are abscissae
    /// @throws Error for other data
    InterpolatingSpline(const std::string& name, std::vector<SimTK::Real> x, std::vector<SimTK::Real> z,
                        const std::vector<std::vector<SimTK::Real>>& families);

    /// The derivative of this order (0 to 4) with respect to x. Where it jumps, at a point: the one to the
    /// right.
    SimTK::Real calcDerivative(Method method, SimTK::Real x, SimTK::Real z, int order) const;

    /// The derivative once more with respect to z; zero for a single curve. Where it jumps: the one to the
    /// right.
    SimTK::Real calcSlopeInZ(Method method, SimTK::Real x, SimTK::Real z, int order) const;

    /// How many of the abscissae are not beyond x: between two of them a curve is one cubic.
    int countPointsUpTo(SimTK::Real x) const;

private:
    // A curve of the family: values, and slopes by method, at each abscissa.
    struct Curve {
        std::vector<SimTK::Real> y, akima, cubic;
    };

    SimTK::Real calcOnCurve(const Curve& curve, Method method, SimTK::Real x, int order) const;

    std::vector<SimTK::Real> m_x, m_z;
    std::vector<Curve> m_curves;
};

}  // namespace jprim

#endif
