// SPDX-License-Identifier: Apache-2.0
#include "expression/curve.h"

namespace jprim {

using SimTK::Real;
using SimTK::Vector;

Real SplineCurve::calcValue(Real x, Real z) const {
    return m_spline.calcDerivative(m_method, x, z, m_order);
}

Partials SplineCurve::calcPartials(Real x, Real z) const {
    return {m_spline.calcDerivative(m_method, x, z, m_order + 1),
            m_spline.calcSlopeInZ(m_method, x, z, m_order),
            m_spline.calcDerivative(m_method, x, z, m_order + 2),
            m_spline.calcSlopeInZ(m_method, x, z, m_order + 1), 0};
}

namespace {

Vector getArguments(const SimTK::Function& function, Real x, Real z) {
    Vector arguments(function.getArgumentSize(), x);
    if (arguments.size() > 1) arguments[1] = z;
    return arguments;
}

}  // namespace

Real FunctionCurve::calcValue(Real x, Real z) const {
    return m_function->calcValue(getArguments(*m_function, x, z));
}

Partials FunctionCurve::calcPartials(Real x, Real z) const {
    const Vector arguments = getArguments(*m_function, x, z);
    const auto calc = [&](const std::vector<int>& components) {
        if (int(components.size()) > getNumDerivatives()) return SimTK::NaN;
        return m_function->calcDerivative(SimTK::Array_<int>(components), arguments);
    };
    if (arguments.size() == 1) return {calc({0}), 0, calc({0, 0}), 0, 0};
    return {calc({0}), calc({1}), calc({0, 0}), calc({0, 1}), calc({1, 1})};
}

}  // namespace jprim
