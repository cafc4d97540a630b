// SPDX-License-Identifier: Apache-2.0
#include "simulation/motion_scale.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace jprim {

using SimTK::MobilizedBodyIndex;
using SimTK::Real;
using SimTK::State;
using SimTK::Vector;

MotionScale::MotionScale(const Mechanism& mechanism, const State& state)
    : m_least(state.getQ()), m_most(state.getQ()), m_states(int(mechanism.getStates().size()), Real(0)) {
    std::map<MobilizedBodyIndex, MobilizedBodyIndex> flexibleOf;  // of a mode
    for (const MechanismPart& part : mechanism.getParts())
        if (part.flexible)
            for (const MobilizedBodyIndex mode : part.flexible->getCarriers())
                flexibleOf[mode] = part.body.getMobilizedBodyIndex();
    const SimTK::SimbodyMatterSubsystem& matter = mechanism.getMatter();
    std::map<MobilizedBodyIndex, Group> groups;
    for (MobilizedBodyIndex b(1); b < matter.getNumBodies(); ++b) {
        const SimTK::MobilizedBody& body = matter.getMobilizedBody(b);
        const auto flexible = flexibleOf.find(b);
        Group& group = groups[flexible == flexibleOf.end() ? b : flexible->second];
        group.q.push_back({body.getFirstQIndex(state), body.getNumQ(state)});
        group.u.push_back({body.getFirstUIndex(state), body.getNumU(state)});
    }
    for (const auto& [body, group] : groups) m_groups.push_back(group);
    observe(state);
}

void MotionScale::observe(const State& state) {
    const Vector& q = state.getQ();
    for (int i = 0; i < q.size(); ++i) {
        m_least[i] = std::min(m_least[i], q[i]);
        m_most[i] = std::max(m_most[i], q[i]);
        m_farthest = std::max(m_farthest, std::abs(q[i]));
    }
    for (Group& group : m_groups) {
        for (const Range& range : group.q)
            for (int i = range.first; i < range.first + range.count; ++i)
                group.motion = std::max(group.motion, m_most[i] - m_least[i]);
        for (const Range& range : group.u)
            for (int i = range.first; i < range.first + range.count; ++i)
                group.motion = std::max(group.motion, std::abs(state.getU()[i]));
    }
    for (int k = 0; k < m_states.size(); ++k) m_states[k] = std::max(m_states[k], std::abs(state.getZ()[k]));
}

int MotionScale::Group::countSpeeds() const {
    int count = 0;
    for (const Range& range : u) count += range.count;
    return count;
}

Real MotionScale::calcMotion(const Group& group, const State& state, Real nextStep) const {
    Real motion = group.motion;
    for (const Range& range : group.u)
        for (int i = range.first; i < range.first + range.count; ++i)
            motion = std::max(motion, nextStep * std::abs(state.getUDot()[i]));
    return motion;
}

bool MotionScale::isAtRest(const State& state, Real time) const {
    constexpr Real Rest = 1e-10;
    return std::all_of(m_groups.begin(), m_groups.end(), [&](const Group& group) {
        return calcMotion(group, state, time) <= Rest * m_farthest;
    });
}

bool MotionScale::areStatesAtRest(const State& state, Real time) const {
    constexpr Real Rest = 1e-10;
    for (int k = 0; k < m_states.size(); ++k)
        if (time * std::abs(state.getZDot()[k]) > Rest * std::max(m_states[k], Real(1))) return false;
    return true;
}

Vector MotionScale::calcStateUnits(const State& state, Real nextStep) const {
    constexpr Real Least = 1e-3;
    Vector units(m_states.size());
    for (int k = 0; k < units.size(); ++k)
        units[k] = std::max({m_states[k], nextStep * std::abs(state.getZDot()[k]), Least});
    return units;
}

// Errors are averaged over all speeds; what rests has none, and would make room for those of what moves. Small motions are
// vibrations as a rule, whose errors add up over periods, and are held tighter.
Vector MotionScale::calcUnits(const State& state, Real nextStep, Real accuracy) const {
    constexpr Real OfLargest = 1e-3, Tightest = 0.25, Small = 1. / 3, Rounding = 1e-14;
    std::vector<Real> motions;
    for (const Group& group : m_groups) motions.push_back(calcMotion(group, state, nextStep));
    const Real largest = motions.empty() ? 0 : *std::max_element(motions.begin(), motions.end());
    int moving = 0;
    for (size_t k = 0; k < m_groups.size(); ++k)
        if (motions[k] > OfLargest * largest) moving += m_groups[k].countSpeeds();
    const Real share = std::sqrt(Real(moving) / std::max(1, state.getNU()));
    const Real least = Rounding * m_farthest / accuracy;
    Vector units(state.getNU(), 1.);
    for (size_t k = 0; k < m_groups.size(); ++k) {
        const Real motion = std::max(motions[k], OfLargest * std::min(1., largest));
        const Real tightness = std::clamp(motion / Small, Tightest, 1.);
        const Real unit = std::min(1., std::max(share * tightness * motion, least));
        for (const Range& range : m_groups[k].u)
            for (int i = range.first; i < range.first + range.count; ++i) units[i] = unit;
    }
    return units;
}

}  // namespace jprim
