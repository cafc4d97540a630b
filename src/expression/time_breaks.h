// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_TIME_BREAKS_H_
#define JPRIM_SRC_EXPRESSION_TIME_BREAKS_H_

#include <optional>
#include <utility>
#include <vector>

#include "expression/interval.h"
#include "expression/program.h"

namespace jprim {

/// A moment at which a function of time goes over to another branch: the last number before it and the first behind.
struct TimeBreak {
    SimTK::Real before, behind;
};

/// When what a Program does with time, and time alone, goes over to another branch: at the corners of STEP, the points
/// of a spline, the jumps of IF, MOD, AINT. They are found by intervals: a branch that is the same for all that a value can
/// be between two times has no break there, however short. Values that whole intervals do not bound, such as quotients by
/// what passes zero, are asked in 64 places of a span; what is left of them may be overlooked.
class TimeBreaks {
public:
    /// @param unit  of the program's time, in that of the breaks
    TimeBreaks(const Program& program, SimTK::Real unit);

    /// True if there are no branches of that kind.
    bool isEmpty() const { return m_joints.empty(); }

    /// The first break behind `after` that begins not behind `until`.
    std::optional<TimeBreak> findFirst(SimTK::Real after, SimTK::Real until);

private:
    /// An instruction with branches, and which is taken: the first and the last of all that may be.
    struct Joint {
        Instruction instruction;
        SimTK::Real first = 0, last = 0;

        bool isSure() const { return first == last; }
    };

    void run(SimTK::Real from, SimTK::Real to);
    void look(Joint& joint) const;
    Interval calc(const Instruction& instruction) const;
    bool isSure() const;
    bool isBounded() const;
    std::vector<SimTK::Real> findBranches(SimTK::Real time);
    std::optional<TimeBreak> search(SimTK::Real from, SimTK::Real to, int halvings);
    std::vector<bool> findZeros(SimTK::Real time);
    SimTK::Real leaveZero(SimTK::Real time, int direction, SimTK::Real closest);
    std::optional<TimeBreak> narrow(SimTK::Real from, SimTK::Real to);

    Program m_program;
    SimTK::Real m_unit;
    std::vector<Instruction> m_instructions;  // those that depend on time alone, as far as branches need them
    std::vector<Joint> m_joints;
    std::vector<Interval> m_ranges;  // of the scalar registers
    int m_numRuns = 0;               // in this search
};

}  // namespace jprim

#endif
