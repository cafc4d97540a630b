// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_MOTION_SCALE_H_
#define JPRIM_SRC_SIMULATION_MOTION_SCALE_H_

#include <vector>

#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// How much of a motion there is: over a run so far, how far each mobilizer's coordinates have gone and how fast, in
/// length units, radians and seconds, and how large each state of the control systems has been. Simbody's integrators
/// hold errors against 1, or a speed where that is larger; a vibration of a thousandth would be nothing to them.
class MotionScale {
public:
    MotionScale(const Mechanism& mechanism, const SimTK::State& state);

    /// Requires Stage::Velocity.
    void observe(const SimTK::State& state);

    /// For each speed, and the coordinates that go with it, what errors are to be held against: the motion of its
    /// mobilizer so far, or what the present acceleration makes of it within the next step, or a small part of what
    /// moves most; of small motions a part of that; 1 at most, and not less than what rounding lets an integrator see.
    /// Requires Stage::Acceleration.
    SimTK::Vector calcUnits(const SimTK::State& state, SimTK::Real nextStep, SimTK::Real accuracy) const;

    /// The same for each state: how large it has been, or will be after the next step at its present rate; not less than a
    /// thousandth, because nobody knows which of a state's digits are rounding errors of what it is the integral of.
    SimTK::Vector calcStateUnits(const SimTK::State& state, SimTK::Real nextStep) const;

    /// True if nothing has moved by more than rounding errors may, nor is accelerated to do so within a time. Requires
    /// Stage::Acceleration.
    bool isAtRest(const SimTK::State& state, SimTK::Real time) const;
    /// True if the states do not change within a time.
    bool areStatesAtRest(const SimTK::State& state, SimTK::Real time) const;

private:
    struct Range {
        int first, count;
    };
    /// A mobilizer; a flexible body's with those of its modes.
    struct Group {
        std::vector<Range> q, u;
        SimTK::Real motion = 0;

        int countSpeeds() const;
    };

    SimTK::Real calcMotion(const Group& group, const SimTK::State& state, SimTK::Real nextStep) const;

    std::vector<Group> m_groups;
    SimTK::Vector m_least, m_most;  // coordinates so far
    SimTK::Real m_farthest = 1;     // of them
    SimTK::Vector m_states;         // the largest so far
};

}  // namespace jprim

#endif
