// SPDX-License-Identifier: Apache-2.0
#include "mechanism/control/control_variables.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;
using SimTK::Vector;

void ControlVariables::realizeTopology(State& state) const {
    Vector initial(int(m_initial.size()));
    for (size_t k = 0; k < m_initial.size(); ++k) initial[int(k)] = m_initial[k];
    if (!m_initial.empty()) m_z = m_forces.allocateZ(state, initial);
    m_sensors = m_forces.allocateDiscreteVariable(state, SimTK::Stage::Dynamics,
                                                  new SimTK::Value<Vector>(Vector(m_numSensors, Real(0))));
}

void ControlVariables::realizeAcceleration(const State& state) const {
    if (m_states.empty()) return;
    Vector& zDot = m_forces.updZDot(state);
    for (size_t k = 0; k < m_states.size(); ++k)
        zDot[m_z + int(k)] = m_states[k].rate.calcValue(state) / m_timeUnit;
}

}  // namespace jprim
