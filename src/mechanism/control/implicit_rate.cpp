// SPDX-License-Identifier: Apache-2.0
#include "mechanism/control/implicit_rate.h"

#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;
using SimTK::Value;

void ImplicitRate::setEquation(const Expression& equation, int unknown) {
    if (unknown < 0 || !equation.getImplementation().program.usesScalarInput(unknown))
        throw Error(
            m_name,
            "its FUNCTION does not depend on its derivative, DIF1; without IMPLICIT it is the derivative");
    m_equation = equation;
    m_angles = AngleMemory(equation.getImplementation());
    m_unknown = unknown;
}

void ImplicitRate::realizeTopology(State& state) const {
    m_evaluation = m_forces.allocateCacheEntry(
        state, SimTK::Stage::Topology,
        new Value<Evaluation>(Evaluation(m_equation->getImplementation().program)));
}

Real ImplicitRate::solve(const State& state) const {
    constexpr int MostSteps = 50;
    constexpr Real Converged = 1e-13;
    Evaluation& evaluation =
        Value<Evaluation>::updDowncast(m_forces.updCacheEntry(state, m_evaluation)).upd();
    m_equation->getImplementation().setInputs(state, evaluation);
    m_angles.recall(state, evaluation);
    Real rate = m_guess;
    for (int k = 0; k < MostSteps; ++k) {
        evaluation.setScalarInput(m_unknown, {rate, 0, 0});
        const Real error = evaluation.calcValue();
        if (error == 0) return rate;
        evaluation.calcGradient();
        const Real step = error / evaluation.getScalarGradient(m_unknown);
        if (!std::isfinite(step)) break;
        rate -= step;
        if (std::abs(step) <= Converged * std::abs(rate)) return rate;
    }
    throw Error(m_name,
                fmt::format("no derivative satisfies its FUNCTION at time {:.6g} s; the search began at {}",
                            state.getTime(), m_guess));
}

}  // namespace jprim
