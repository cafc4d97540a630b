// SPDX-License-Identifier: Apache-2.0
// The breaks of functions of time are found to the last digit, however close together, and nothing else is taken for one.
#include "expression/time_breaks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jprim {
namespace {

using SimTK::Real;

std::vector<Real> findAll(const Program& program, Real after, Real until, Real unit = 1) {
    constexpr size_t Most = 1000;
    // Rounding holds the condition of an IF that is nearly stationary at zero so long.
    constexpr Real HeldAtZero = 1e-12;
    TimeBreaks breaks(program, unit);
    std::vector<Real> times;
    while (const auto next = breaks.findFirst(after, until)) {
        EXPECT_LT(next->before, next->behind);
        EXPECT_LE(next->behind - next->before, HeldAtZero * std::max(Real(1), std::abs(next->behind)));
        times.push_back(next->behind);
        after = next->behind;
        if (times.size() > Most) break;
    }
    return times;
}

void expectBreaks(const Program& program, Real until, const std::vector<Real>& expected, Real unit = 1) {
    const std::vector<Real> found = findAll(program, -0.123, until, unit);
    ASSERT_EQ(found.size(), expected.size());
    for (size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-12 * until) << k;
}

TEST(TimeBreaks, OfAShortPulse) {
    ProgramBuilder b;
    const Operand late = b.subtract(b.time(), b.number(57.31)),
                  early = b.subtract(b.number(57.31001), b.time());
    const Program program = b.finish(b.max(b.number(0), b.min(late, early)));
    expectBreaks(program, 1000, {57.31, 57.310005, 57.31001});
    expectBreaks(program, 1e6, {57310, 57310.005, 57310.01}, 1000);
    expectBreaks(program, 57.3, {});
}

TEST(TimeBreaks, OfWhatTurnsAndReturns) {
    ProgramBuilder b;
    const Operand sine = b.call(Function::Sin, b.multiply(b.number(3.7), b.time()));
    expectBreaks(b.finish(b.max(sine, b.number(2))), 1000, {});
    const Operand tip = b.subtract(sine, b.number(1 - 1e-9));
    const Program narrow = b.finish(b.select(tip, b.number(0), b.number(0), b.number(1)));
    const Real half = std::acos(1 - 1e-9) / 3.7, first = SimTK::Pi / 2 / 3.7;
    expectBreaks(narrow, 2, {first - half, first + half});
    EXPECT_EQ(findAll(narrow, 0, 100).size(), 2 * std::floor(100 * 3.7 / (2 * SimTK::Pi) + 0.75));
}

// The branch for zero is one number; what lies behind the break is the next.
TEST(TimeBreaks, OfIfLeaveItsBranchForZero) {
    ProgramBuilder b;
    const Operand late = b.subtract(b.time(), b.number(0.437));
    TimeBreaks breaks(b.finish(b.select(late, b.number(1), b.number(1), b.number(2))), 1);
    const auto found = breaks.findFirst(0, 1);
    ASSERT_TRUE(found);
    EXPECT_LT(found->before, 0.437);
    EXPECT_GT(found->behind, 0.437);
}

// Both ends of it are where the function itself, to its last digit, is on one side; zero is on neither.
TEST(TimeBreaks, LeaveZeroOnBothSides) {
    for (const Real level : {0.5, 0.99, 0.3}) {
        ProgramBuilder b;
        const Operand over = b.subtract(b.call(Function::Sin, b.time()), b.number(level));
        TimeBreaks breaks(b.finish(b.select(over, b.number(0), b.number(7), b.number(1))), 1);
        Real after = 0;
        for (int k = 0; k < 20; ++k) {
            const auto found = breaks.findFirst(after, 100);
            ASSERT_TRUE(found);
            const Real before = std::sin(found->before) - level, behind = std::sin(found->behind) - level;
            EXPECT_LT(before * behind, 0) << found->before;
            after = found->behind;
        }
    }
}

// Zero itself is within the break, from whichever side.
TEST(TimeBreaks, AreFoundWhereASearchEnds) {
    ProgramBuilder b;
    const Operand early = b.subtract(b.number(1), b.time());
    const auto found =
        TimeBreaks(b.finish(b.select(early, b.number(0), b.number(7), b.number(1))), 1).findFirst(0, 1);
    ASSERT_TRUE(found);
    EXPECT_LT(found->before, 1);
    EXPECT_GT(found->behind, 1);
}

// Numbers next to zero are too close to each other to go on behind.
TEST(TimeBreaks, AtZeroLeaveIt) {
    ProgramBuilder b;
    for (const Program& program : {b.finish(b.select(b.time(), b.number(0), b.number(0), b.number(1))),
                                   b.finish(b.call(Function::Abs, b.time()))}) {
        const auto found = TimeBreaks(program, 1).findFirst(-1e-3, 1e-3);
        ASSERT_TRUE(found);
        EXPECT_LT(found->before, 0);
        EXPECT_GT(found->behind, 1e-24);
        EXPECT_LT(found->behind, 1e-18);
    }
}

TEST(TimeBreaks, OfWhatJumps) {
    ProgramBuilder b;
    expectBreaks(b.finish(b.mod(b.time(), b.number(0.7))), 3, {0.7, 1.4, 2.1, 2.8});
    expectBreaks(b.finish(b.call(Function::Aint, b.time())), 3.5, {1, 2, 3});
    expectBreaks(b.finish(b.call(Function::Anint, b.time())), 3, {0.5, 1.5, 2.5});
    expectBreaks(b.finish(b.call(Function::Abs, b.subtract(b.time(), b.number(0.3)))), 3, {0.3});
}

// Branches that depend on anything else are not of time alone; those decided by time are, whatever they lead to.
TEST(TimeBreaks, OfTimeAlone) {
    ProgramBuilder b;
    const Operand x = b.component(b.addVectorInput(KinematicLevel::Position), 0);
    EXPECT_TRUE(TimeBreaks(b.finish(b.max(x, b.time())), 1).isEmpty());
    EXPECT_TRUE(TimeBreaks(b.finish(b.multiply(x, b.time())), 1).isEmpty());
    const Operand late = b.subtract(b.time(), b.number(0.9));
    expectBreaks(b.finish(b.select(late, b.number(0), x, x)), 3, {0.9});
}

// Of a quotient by what passes zero nothing is bounded; all ends all the same.
TEST(TimeBreaks, EndWhereNothingIsKnown) {
    ProgramBuilder b;
    const Operand pole = b.divide(b.number(1), b.subtract(b.time(), b.number(0.51)));
    expectBreaks(b.finish(b.max(pole, b.number(0))), 3, {0.51});
    const Operand s = b.call(Function::Sin, b.time()), c = b.call(Function::Cos, b.time());
    const Operand noise = b.subtract(b.add(b.multiply(s, s), b.multiply(c, c)), b.number(1));
    TimeBreaks(b.finish(b.max(noise, b.number(0))), 1).findFirst(0, 1);
}

}  // namespace
}  // namespace jprim
