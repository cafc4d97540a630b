// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_REACTION_WATCH_H_
#define JPRIM_SRC_SIMULATION_REACTION_WATCH_H_

#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// Holds reactions against the loads that there are to be carried.
class ReactionWatch {
public:
    explicit ReactionWatch(const Mechanism& mechanism) : m_mechanism(mechanism) {}

    /// Requires Stage::Acceleration.
    /// @throws std::runtime_error naming the element, if a reaction is more than LargestLever times the largest applied
    ///         load, weight or inertia force of any part so far: a multiplier found by dividing by a rounding error
    void check(const SimTK::State& state);

    /// A toggle multiplies loads by one over its angle from the dead point.
    static constexpr SimTK::Real LargestLever = 1e8;

private:
    const Mechanism& m_mechanism;
    SimTK::Real m_largestLoad = 0;  // a force, or a moment over a part's size
};

}  // namespace jprim

#endif
