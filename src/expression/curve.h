// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_CURVE_H_
#define JPRIM_SRC_EXPRESSION_CURVE_H_

#include <memory>

#include "expression/functions.h"
#include "jprim/expression/spline.h"

namespace jprim {

/// A function of x and z, or of x alone, that is given by data.
class Curve {
public:
    virtual ~Curve() = default;

    virtual SimTK::Real calcValue(SimTK::Real x, SimTK::Real z) const = 0;
    virtual Partials calcPartials(SimTK::Real x, SimTK::Real z) const = 0;
    /// How many derivatives there are; those of calcPartials() that are lacking are NaN.
    virtual int getNumDerivatives() const { return 2; }
    /// Which of its pieces x is on, if it is made of several: between any two x of one piece it is smooth.
    virtual int findPiece(SimTK::Real) const { return 0; }
};

/// The derivative of an order of a spline's y(x, z) with respect to x.
class SplineCurve final : public Curve {
public:
    SplineCurve(const InterpolatingSpline& spline, InterpolatingSpline::Method method, int order)
        : m_spline(spline), m_method(method), m_order(order) {}

    SimTK::Real calcValue(SimTK::Real x, SimTK::Real z) const override;
    Partials calcPartials(SimTK::Real x, SimTK::Real z) const override;
    int findPiece(SimTK::Real x) const override { return m_spline.countPointsUpTo(x); }

private:
    InterpolatingSpline m_spline;
    InterpolatingSpline::Method m_method;
    int m_order;
};

/// A function of one or two arguments in Simbody's form. One of one argument has no z.
class FunctionCurve final : public Curve {
public:
    explicit FunctionCurve(std::shared_ptr<const SimTK::Function> function)
        : m_function(std::move(function)) {}

    SimTK::Real calcValue(SimTK::Real x, SimTK::Real z) const override;
    Partials calcPartials(SimTK::Real x, SimTK::Real z) const override;
    int getNumDerivatives() const override { return m_function->getMaxDerivativeOrder(); }

private:
    std::shared_ptr<const SimTK::Function> m_function;
};

}  // namespace jprim

#endif
