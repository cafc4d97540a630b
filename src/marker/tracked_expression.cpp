// SPDX-License-Identifier: Apache-2.0
#include "marker/tracked_expression.h"

namespace jprim {

using SimTK::Real;
using SimTK::Stage;
using SimTK::State;
using SimTK::Value;
using SimTK::Vec3;

void TrackedExpression::allocate(const SimTK::Subsystem& subsystem, State& state) {
    m_subsystem = subsystem.getMySubsystemIndex();
    m_angles.allocate(subsystem, state, get().program.getNumAngles());
    m_evaluation = subsystem.allocateCacheEntry(state, Stage::Topology,
                                                new Value<Evaluation>(Evaluation(get().program)));
}

Evaluation& TrackedExpression::prepare(const State& state, InputLevel highest) const {
    Evaluation& evaluation =
        Value<Evaluation>::updDowncast(state.updCacheEntry(m_subsystem, m_evaluation)).upd();
    get().setInputs(state, evaluation, highest);
    m_angles.recall(state, evaluation);
    return evaluation;
}

Real TrackedExpression::calcValue(const State& state) const {
    Evaluation& evaluation = prepare(state, InputLevel::Acceleration);
    const Real value = evaluation.calcValue();
    m_angles.remember(state, evaluation);
    return value;
}

Vec3 TrackedExpression::calcVector(const State& state) const {
    Evaluation& evaluation = prepare(state, InputLevel::Acceleration);
    const Vec3 value = evaluation.calcVectorValue();
    m_angles.remember(state, evaluation);
    return value;
}

Real TrackedExpression::calcRate(const State& state) const {
    Evaluation& evaluation = prepare(state, InputLevel::Acceleration);
    const std::vector<MarkerMotion> motions = get().findMotions(state, InputLevel::Velocity);
    get().setInputs(state.getTime(), motions.data(), evaluation);
    const Real rate = evaluation.calcTaylor().first;
    m_angles.remember(state, evaluation);
    return rate;
}

void TrackedExpression::followAngles(const State& state) const {
    if (get().program.getNumAngles() == 0) return;
    Evaluation& evaluation = prepare(state, InputLevel::Position);
    if (get().program.isVector())
        evaluation.calcVectorValue();
    else
        evaluation.calcValue();
    m_angles.remember(state, evaluation);
}

}  // namespace jprim
