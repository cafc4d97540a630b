// SPDX-License-Identifier: Apache-2.0
#include "simulation/stall_watch.h"

#include <algorithm>
#include <stdexcept>

#include "force/marker_force_impl.h"
#include "jprim/base/error.h"
#include "marker/find_implementation.h"
#include "simulation/failure.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;

namespace {

/// A force a little before or behind a State, if the motion goes on as it does there.
class ForceNearby {
public:
    ForceNearby(const Mechanism& mechanism, const MarkerForce& force, const State& state)
        : m_system(mechanism.getSystem()),
          m_impl(*findImplementation<MarkerForceImpl>(force)),
          m_state(state),
          m_nearby(state) {}

    bool jumpsWithin(Real moment) {
        constexpr int Halvings = 40;
        Real same = 0, other = moment;
        const std::vector<int> here = findSigns(same);
        if (here.empty() || findSigns(other) == here) return false;
        for (int k = 0; k < Halvings; ++k) {
            const Real middle = (same + other) / 2;
            (findSigns(middle) == here ? same : other) = middle;
        }
        return isJump(calcLoad(same), calcLoad(other), calcLoad(moment));
    }

private:
    // What grows from nothing, as a contact does, soon is much more than at first.
    static bool isJump(const SpatialVec& a, const SpatialVec& b, const SpatialVec& soon) {
        constexpr Real Part = 0.2;
        for (const int k : {0, 1})
            if ((a[k] - b[k]).norm() > Part * std::max({a[k].norm(), b[k].norm(), soon[k].norm()}))
                return true;
        return false;
    }

    void goTo(Real moment) {
        m_nearby.updQ() = m_state.getQ() + moment * m_state.getQDot();
        m_nearby.updU() = m_state.getU() + moment * m_state.getUDot();
        m_system.realize(m_nearby, SimTK::Stage::Velocity);
    }

    SpatialVec calcLoad(Real moment) {
        goTo(moment);
        return m_impl.calcLoadOnI(m_nearby);
    }

    // At rest a switch is zero, and not on either side.
    std::vector<int> findSigns(Real moment) {
        goTo(moment);
        std::vector<TrackedExpression::Switch> switches;
        m_impl.addSwitches(m_nearby, switches);
        std::vector<int> signs;
        for (const auto& s : switches) signs.push_back((s.value > 0) - (s.value < 0));
        return signs;
    }

    const SimTK::MultibodySystem& m_system;
    const MarkerForceImpl& m_impl;
    const State& m_state;
    State m_nearby;
};

}  // namespace

std::string findJumpingForce(const Mechanism& mechanism, const State& state, Real moment) {
    mechanism.getSystem().realize(state, SimTK::Stage::Acceleration);
    for (const Element& element : mechanism.getElements()) {
        if (!element.getForce() || element.isDisabled(state)) continue;
        ForceNearby nearby(mechanism, *element.getForce(), state);
        for (const Real there : {moment, -moment})
            if (nearby.jumpsWithin(there)) return element.getName();
    }
    return "";
}

void StallWatch::observe(const State& state, Real until) {
    constexpr int Steps = 1000, Times = 3;
    constexpr Real TooMany = 2000, StepsAround = 10;
    if (++m_numSteps < Steps) return;
    const Real step = (state.getTime() - m_begin) / Steps;
    m_begin = state.getTime();
    m_numSteps = 0;
    if (step < SimTK::Eps * std::abs(state.getTime())) throw std::runtime_error(NoStepIsShortEnough);
    const bool isSlow = until - state.getTime() > TooMany * step;
    const std::string name = isSlow ? findJumpingForce(m_mechanism, state, StepsAround * step) : "";
    m_numStalled = name.empty() ? 0 : m_numStalled + 1;
    if (m_numStalled == Times) throw Error(name, WhatJumpingDoes);
}

}  // namespace jprim
