// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_STALL_WATCH_H_
#define JPRIM_SRC_SIMULATION_STALL_WATCH_H_

#include <string>

#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// The name of a force whose function jumps within a moment before or behind a State, as that of dry friction does where a
/// body comes to rest: SIGN(F, VX); empty if there is none.
std::string findJumpingForce(const Mechanism& mechanism, const SimTK::State& state, SimTK::Real moment);

/// What is wrong with it, and what to do.
constexpr const char* WhatJumpingDoes =
    "its function jumps here, and on both sides it drives the mechanism back, as dry friction does that changes its sign "
    "at rest; make it continuous, as by STEP or TANH of the velocity";

/// Ends a run that a jumping force keeps in endless short steps: to and fro over the jump, to neither side of which the
/// mechanism can go. Short steps alone are no reason: a stiff mechanism needs them.
class StallWatch {
public:
    explicit StallWatch(const Mechanism& mechanism) : m_mechanism(mechanism) {}

    /// After every step. @throws Error naming the force
    void observe(const SimTK::State& state, SimTK::Real until);

private:
    const Mechanism& m_mechanism;
    int m_numSteps = 0;
    SimTK::Real m_begin = 0;  // of these steps
    int m_numStalled = 0;     // times in a row
};

}  // namespace jprim

#endif
