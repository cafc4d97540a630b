// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_ANGLE_MEMORY_H_
#define JPRIM_SRC_MARKER_ANGLE_MEMORY_H_

#include "marker/marker_expression.h"

namespace jprim {

/// The angles of an expression as they were at the last step that an integrator completed, from which it
/// counts whole turns. They live in the State: a trial step that is thrown away leaves no trace.
class AngleMemory {
public:
    /// In realizeTopology(). Nothing is allocated for an expression without angles.
    void allocate(const SimTK::Subsystem& subsystem, SimTK::State& state, int numAngles);
    /// Before an evaluation.
    void recall(const SimTK::State& state, Evaluation& evaluation) const;
    /// After one of a State's own positions; these count once the step is complete.
    void remember(const SimTK::State& state, const Evaluation& evaluation) const;

private:
    int m_numAngles = 0;
    SimTK::SubsystemIndex m_subsystem;
    SimTK::DiscreteVariableIndex m_angles;
};

}  // namespace jprim

#endif
