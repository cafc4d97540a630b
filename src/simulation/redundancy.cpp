// SPDX-License-Identifier: Apache-2.0
#include "simulation/redundancy.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "jprim/analysis/constraint_report.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;

namespace {

const Primitive* findPrimitive(const Mechanism& mechanism, SimTK::ConstraintIndex index) {
    for (const Connection& connection : mechanism.getConnections()) {
        if (!connection.joint) continue;
        for (const Primitive& primitive : connection.joint->getPrimitives())
            if (primitive.getConstraintIndex() == index) return &primitive;
    }
    return nullptr;
}

}  // namespace

// The equation of a GCON, MOTION or COUPLER stays: it has no load that a user would miss, and its least-norm
// share does no harm.
DroppedEquations::DroppedEquations(const Mechanism& mechanism, State& state)
    : m_lengthUnit(mechanism.getUnits().length) {
    const ConstraintReport report =
        analyzeConstraints(mechanism.getMatter(), state, mechanism.getElementNames());
    for (const RedundantEquation& redundant : report.redundant) {
        const ConstraintEquation& equation = report.equations[size_t(redundant.equation)];
        const Primitive* primitive = findPrimitive(mechanism, equation.constraint);
        if (redundant.onlyHere || !primitive) continue;
        primitive->dropEquation(state, equation.number);
        m_dropped.push_back({*primitive, equation.number});
        m_texts.push_back(equation.getText());
    }
}

void DroppedEquations::check(const State& state, Real tolerance) const {
    for (size_t k = 0; k < m_dropped.size(); ++k) {
        const Real error = m_dropped[k].primitive.calcEquationError(state, m_dropped[k].equation);
        if (std::abs(error) <= tolerance) continue;
        const bool isLength = m_dropped[k].primitive.isTranslational();
        throw std::runtime_error(fmt::format(
            "{}, which was dropped because it followed from other equations, is violated by {:.3g} {}: it is "
            "in conflict with them now",
            m_texts[k], isLength ? std::abs(error) / m_lengthUnit : std::abs(error),
            isLength ? "length units" : "rad"));
    }
}

}  // namespace jprim
