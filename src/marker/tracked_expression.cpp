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
    m_evaluation = subsystem.allocateCacheEntry(state, Stage::Topology,
                                                new Value<Evaluation>(Evaluation(get().program)));
}

Evaluation& TrackedExpression::prepare(const State& state) const {
    Evaluation& evaluation =
        Value<Evaluation>::updDowncast(state.updCacheEntry(m_subsystem, m_evaluation)).upd();
    get().setInputs(state, evaluation);
    m_angles.recall(state, evaluation);
    return evaluation;
}

Real TrackedExpression::calcValue(const State& state) const {
    return prepare(state).calcValue();
}

Vec3 TrackedExpression::calcVector(const State& state) const {
    return prepare(state).calcVectorValue();
}

Real TrackedExpression::calcRate(const State& state) const {
    Evaluation& evaluation = prepare(state);
    const std::vector<MarkerMotion> motions = get().findMotions(state, KinematicLevel::Velocity);
    get().setInputs(state.getTime(), motions.data(), evaluation);
    return evaluation.calcTaylor().first;
}

void TrackedExpression::addSwitches(const State& state, bool withResult,
                                    std::vector<Switch>& switches) const {
    const Program& program = get().program;
    if (program.getNumSwitches() == 0 && !withResult) return;
    Evaluation& evaluation = prepare(state);
    const bool isAccelerated = state.getSystemStage() >= Stage::Acceleration;
    const std::vector<MarkerMotion> motions =
        get().findMotions(state, isAccelerated ? KinematicLevel::Acceleration : KinematicLevel::Velocity);
    get().setInputs(state.getTime(), motions.data(), evaluation);
    Taylor<Real> result;
    if (program.isVector())
        evaluation.calcVectorTaylor();
    else
        result = evaluation.calcTaylor();
    for (int k = 0; k < program.getNumSwitches(); ++k) {
        const Taylor<Real>& value = evaluation.getSwitch(k);
        switches.push_back({value.value, value.first, program.getSwitchLevel(k)});
    }
    if (withResult) switches.push_back({result.value, result.first, program.getLevel()});
}

}  // namespace jprim
