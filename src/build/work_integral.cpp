// SPDX-License-Identifier: Apache-2.0
#include "build/work_integral.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;

void WorkIntegral::realizeTopology(State& state) const {
    m_z = m_forces.allocateZ(state, SimTK::Vector(1, Real(0)));
}

void WorkIntegral::setWeight(State& state) const {
    constexpr Real Unnoticed = 1e-100;
    state.updZWeights(m_forces.getMySubsystemIndex())[m_z] = Unnoticed;
}

void WorkIntegral::realizeAcceleration(const State& state) const {
    m_forces.updZDot(state)[m_z] = calcPower(state);
}

Real WorkIntegral::calcPower(const State& state) const {
    const SimTK::SimbodyMatterSubsystem& matter = m_system.getMatterSubsystem();
    const auto& onBodies = m_system.getRigidBodyForces(state, SimTK::Stage::Dynamics);
    Real power = ~m_system.getMobilityForces(state, SimTK::Stage::Dynamics) * state.getU();
    for (SimTK::MobilizedBodyIndex b(1); b < matter.getNumBodies(); ++b)
        power += ~onBodies[b] * matter.getMobilizedBody(b).getBodyVelocity(state);
    for (const SimTK::Constraint& constraint : m_constraints)
        if (!constraint.isDisabled(state)) power += constraint.calcPower(state);
    return power;
}

}  // namespace jprim
