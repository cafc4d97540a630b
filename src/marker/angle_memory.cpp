// SPDX-License-Identifier: Apache-2.0
#include "marker/angle_memory.h"

#include <algorithm>

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Real;
using SimTK::Stage;
using SimTK::State;
using SimTK::Value;
using SimTK::Vector;

void checkTurns(const Vector& turns, int numAngles, const std::string& element) {
    if (turns.size() != numAngles)
        throw Error(element, fmt::format("the turns of {} angles are given; AX, AY and AZ are {} in it",
                                         turns.size(), numAngles));
    for (int k = 0; k < numAngles; ++k)
        if (!std::isfinite(turns[k]))
            throw Error(element, fmt::format("a number of turns must be finite, not {}", turns[k]));
}

// The angles differ from those remembered by the motion of one step. Which turn an angle is in does not depend on
// when it was last remembered, so nothing is invalid after an update.
class AngleMemory::Follower final : public SimTK::AbstractMeasure::Implementation {
public:
    explicit Follower(const MarkerExpression& expression) : m_expression(expression) {}

    int getNumAngles() const { return m_expression.program.getNumAngles(); }

    const Vector& getRemembered(const State& state) const {
        return Value<Vector>::downcast(state.getDiscreteVariable(m_subsystem, m_angles)).get();
    }

    void setRemembered(State& state, const Vector& angles) const {
        Value<Vector>::updDowncast(state.updDiscreteVariable(m_subsystem, m_angles)).upd() = angles;
        state.invalidateAllCacheAtOrAbove(Stage::Position);
    }

    void recall(const State& state, Evaluation& evaluation) const {
        const Vector& angles = getRemembered(state);
        for (int k = 0; k < angles.size(); ++k) evaluation.setRememberedAngle(k, angles[k]);
    }

    // No more than positions, which are all that the angles depend on.
    void calcAngles(const State& state, Vector& angles) const {
        Evaluation& evaluation =
            Value<Evaluation>::updDowncast(state.updCacheEntry(m_subsystem, m_evaluation)).upd();
        m_expression.setInputs(state, evaluation, KinematicLevel::Position);
        recall(state, evaluation);
        if (m_expression.program.isVector())
            evaluation.calcVectorValue();
        else
            evaluation.calcValue();
        for (int k = 0; k < angles.size(); ++k) angles[k] = evaluation.getAngle(k);
    }

private:
    Implementation* cloneVirtual() const override { return new Follower(*this); }
    Stage getDependsOnStageVirtual(int) const override { return Stage::Position; }

    void realizeTopology(State& state) const override {
        m_subsystem = getSubsystemIndex();
        m_angles = state.allocateAutoUpdateDiscreteVariable(
            m_subsystem, Stage::Report, new Value<Vector>(Vector(getNumAngles(), Real(0))), Stage::Position);
        m_evaluation = state.allocateCacheEntry(m_subsystem, Stage::Topology,
                                                new Value<Evaluation>(Evaluation(m_expression.program)));
    }

    void realizeMeasurePositionVirtual(const State& state) const override {
        calcAngles(state,
                   Value<Vector>::updDowncast(state.updDiscreteVarUpdateValue(m_subsystem, m_angles)).upd());
        state.markDiscreteVarUpdateValueRealized(m_subsystem, m_angles);
    }

    MarkerExpression m_expression;

    // Topology cache.
    mutable SimTK::SubsystemIndex m_subsystem;
    mutable SimTK::DiscreteVariableIndex m_angles;
    mutable SimTK::CacheEntryIndex m_evaluation;
};

// Markers that are on no body, or in different systems, are for the owner of the expression to refuse.
AngleMemory::AngleMemory(const MarkerExpression& expression) {
    if (expression.program.getNumAngles() == 0) return;
    const auto getMatter = [](const Marker& marker) {
        return marker.isOnBody() ? &marker.getBody().getMatterSubsystem() : nullptr;
    };
    const SimTK::SimbodyMatterSubsystem* matter = getMatter(expression.markers.front());
    if (!matter || !std::all_of(expression.markers.begin(), expression.markers.end(),
                                [&](const Marker& marker) { return getMatter(marker) == matter; }))
        return;
    m_follower = SimTK::AbstractMeasure(new Follower(expression));
    const_cast<SimTK::SimbodyMatterSubsystem*>(matter)->adoptMeasure(m_follower);
}

const AngleMemory::Follower& AngleMemory::getFollower() const {
    return static_cast<const Follower&>(m_follower.getImpl());
}

int AngleMemory::getNumAngles() const {
    return m_follower.hasImpl() ? getFollower().getNumAngles() : 0;
}

void AngleMemory::recall(const State& state, Evaluation& evaluation) const {
    if (m_follower.hasImpl()) getFollower().recall(state, evaluation);
}

Vector AngleMemory::getTurns(const State& state) const {
    Vector angles(getNumAngles());
    if (m_follower.hasImpl()) getFollower().calcAngles(state, angles);
    return angles / (2 * SimTK::Pi);
}

void AngleMemory::setTurns(State& state, const Vector& turns, const std::string& element) const {
    checkTurns(turns, getNumAngles(), element);
    if (m_follower.hasImpl()) getFollower().setRemembered(state, 2 * SimTK::Pi * turns);
}

}  // namespace jprim
