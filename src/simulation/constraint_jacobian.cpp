// SPDX-License-Identifier: Apache-2.0
#include "simulation/constraint_jacobian.h"

#include <algorithm>

#include "analysis/scaled_equations.h"

namespace jprim {

namespace {

std::vector<ConstraintEquation> findSpeedEquations(const Mechanism& mechanism, const SimTK::State& state) {
    std::vector<ConstraintEquation> equations = mechanism.findEquations(state);
    const auto isOfAccelerations = [](const ConstraintEquation& e) {
        return e.level == KinematicLevel::Acceleration;
    };
    equations.erase(std::find_if(equations.begin(), equations.end(), isOfAccelerations), equations.end());
    return equations;
}

}  // namespace

SpeedEquations::SpeedEquations(const Mechanism& mechanism, const SimTK::State& state) {
    const ScaledEquations scaled(mechanism.getMatter(), findSpeedEquations(mechanism, state), state);
    m_inverseScales.resize(Eigen::Index(scaled.getEquations().size()));
    for (Eigen::Index i = 0; i < m_inverseScales.size(); ++i) {
        const double scale = scaled.getEquations()[size_t(i)].scale;
        m_inverseScales[i] = scale > 0 ? 1 / scale : 0;
    }
    m_G = m_inverseScales.asDiagonal() * scaled.calcCleanJacobian(state);
}

}  // namespace jprim
