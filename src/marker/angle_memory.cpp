// SPDX-License-Identifier: Apache-2.0
#include "marker/angle_memory.h"

namespace jprim {

using SimTK::Real;
using SimTK::Stage;
using SimTK::State;
using SimTK::Value;
using SimTK::Vector;

// The angles differ from those remembered by the motion of one step. Which turn an angle is in does not
// depend on when it was last remembered, so nothing is invalid after an update.
void AngleMemory::allocate(const SimTK::Subsystem& subsystem, State& state, int numAngles) {
    m_numAngles = numAngles;
    if (numAngles == 0) return;
    m_subsystem = subsystem.getMySubsystemIndex();
    m_angles = state.allocateAutoUpdateDiscreteVariable(
        m_subsystem, Stage::Report, new Value<Vector>(Vector(numAngles, Real(0))), Stage::Position);
}

void AngleMemory::recall(const State& state, Evaluation& evaluation) const {
    if (m_numAngles == 0) return;
    const Vector& angles = Value<Vector>::downcast(state.getDiscreteVariable(m_subsystem, m_angles));
    for (int k = 0; k < m_numAngles; ++k) evaluation.setRememberedAngle(k, angles[k]);
}

void AngleMemory::remember(const State& state, const Evaluation& evaluation) const {
    if (m_numAngles == 0) return;
    Vector& angles = Value<Vector>::updDowncast(state.updDiscreteVarUpdateValue(m_subsystem, m_angles));
    for (int k = 0; k < m_numAngles; ++k) angles[k] = evaluation.getAngle(k);
    state.markDiscreteVarUpdateValueRealized(m_subsystem, m_angles);
}

}  // namespace jprim
