// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_BREAK_WATCH_H_
#define JPRIM_SRC_SIMULATION_BREAK_WATCH_H_

#include <optional>
#include <vector>

#include "expression/time_breaks.h"
#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// Finds when a function of time goes over to another branch, so that a step can end there and
/// the next begin behind it.
class BreakWatch {
public:
    static BreakWatch ofLoads(const Mechanism& mechanism);
    /// Of the sensors that end a run.
    static BreakWatch ofSensors(const Mechanism& mechanism);

    /// The first break behind `after` and not behind `until`.
    std::optional<TimeBreak> findNext(SimTK::Real after, SimTK::Real until);

    /// The break within which a State stands that begins, or else none.
    /// @param span  of the times that a run goes through
    std::optional<TimeBreak> findAround(SimTK::Real time, SimTK::Real span);

    /// What bodies with masses cannot follow: at a break a function asks for other positions or other velocities.
    /// @param before  a State at the last moment before the break
    /// @param highest  Position where velocities may jump
    /// @throws Error naming the MOTION or GCON
    static void requireNoJump(const Mechanism& mechanism, const SimTK::State& before, SimTK::Real behind,
                              KinematicLevel highest = KinematicLevel::Velocity);
    /// True if accelerations, or the rates of the first states of control systems, are others behind a break. Requires
    /// Stage::Acceleration.
    static bool doRatesJump(const SimTK::State& before, const SimTK::State& behind, int numStates);

private:
    /// The breaks of a function, of which the next is known, or that there is none until a time.
    struct Function {
        explicit Function(TimeBreaks of) : breaks(std::move(of)) {}

        TimeBreaks breaks;
        SimTK::Real searchedFrom = SimTK::Infinity, searchedUntil = -SimTK::Infinity;
        std::optional<TimeBreak> next;
        int count = 0;
    };
    void add(const MarkerExpression& expression);

    std::vector<Function> m_functions;
};

}  // namespace jprim

#endif
