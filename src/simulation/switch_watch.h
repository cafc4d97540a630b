// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_SWITCH_WATCH_H_
#define JPRIM_SRC_SIMULATION_SWITCH_WATCH_H_

#include <functional>
#include <optional>
#include <vector>

#include "jprim/mechanism/mechanism.h"
#include "marker/tracked_expression.h"

namespace jprim {

/// When a switch changes its sign within a step: it is changed at `begin`, and again soon after `end`.
struct Excursion {
    SimTK::Real begin, end;
};

/// Values whose signs decide something, from step to step. One that goes through zero and comes back within a step, such
/// as the penetration of a contact, may not have been seen by the integrator at all. Where the rates at both ends of a step
/// leave that possible, the motion in between - a cubic through the coordinates, states and their rates at both ends - is followed
/// until it is found or ruled out. Of values that depend on velocities one moment is asked, of those that depend on
/// accelerations none.
class SwitchWatch {
public:
    using Switch = TrackedExpression::Switch;
    /// Tells the switches at a State of Stage::Velocity or Stage::Acceleration, always as many.
    using Source = std::function<void(const SimTK::State&, std::vector<Switch>&)>;

    /// What decides branches of forces and of the rates of states.
    static Source getLoads(const Mechanism& mechanism);

    SwitchWatch(const SimTK::MultibodySystem& system, const Source& source)
        : m_system(system), m_source(source) {}

    /// Where a motion begins. Requires Stage::Velocity, like check().
    void start(const SimTK::State& state);

    /// The first excursion since start() or the last check(), if there is one.
    /// @param withOneWay  a change of sign that stays at the end of the step counts as well
    std::optional<Excursion> check(const SimTK::State& state, bool withOneWay = false);

    bool isEmpty() const { return m_last.empty(); }

private:
    struct Moment {
        SimTK::Real time;
        SimTK::Vector q, qDot, z, zDot;
    };
    /// A switch at a part s of the step.
    struct Point {
        SimTK::Real s, value, rate;
    };

    Moment makeMoment(const SimTK::State& state) const;
    Point findBetween(const Moment& end, size_t k, SimTK::Real s);
    std::optional<Point> findBeyond(const Moment& end, size_t k, Point from, Point to);
    SimTK::Real findCrossing(const Moment& end, size_t k, SimTK::Real before, SimTK::Real behind);

    const SimTK::MultibodySystem& m_system;
    Source m_source;
    SimTK::State m_between;
    Moment m_start;
    std::vector<Switch> m_last, m_now;
    std::vector<SimTK::Real> m_largest;
};

}  // namespace jprim

#endif
