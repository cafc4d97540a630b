// SPDX-License-Identifier: Apache-2.0
// Output times and breaks of functions of time may coincide, to the last digit or but for it; no integrator is disturbed.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "jprim/jprim.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

constexpr double Mass = 2.3;

// A free part, and a force along z.
std::string writePushed(const std::string& force, double speed = 0) {
    return fmt::format(
        "push\nPART/1,GROUND\nMARKER/1\nPART/2,MASS={},CM=20,IP=1,1.2,0.9,VZ={}\nMARKER/20\n"
        "SFORCE/1,TRANSLATION,ACTIONONLY,I=20,J=1,FUNCTION={}\nEND\n",
        Mass, speed, force);
}

SimulationOutcome simulateWith(const std::string& text, double end, int steps,
                               const std::string& integrator) {
    const Mechanism mechanism = testing::buildOrFail(text);
    SimulationOptions options;
    options.end = end;
    options.steps = steps;
    options.integrator = integrator;
    options.accuracy = integrator == "SemiExplicitEuler2" ? 1e-4 : 1e-6;
    return simulate(mechanism, assemble(mechanism), options);
}

class OutputTimes : public ::testing::TestWithParam<std::string> {
protected:
    // The speed at the end, in which a constant force has no errors of any method.
    void expectSpeed(const std::string& force, double end, int steps, double exact) const {
        constexpr double Rounding = 1e-9;
        for (const double start : {0., 0.3}) {
            const SimulationOutcome outcome = simulateWith(writePushed(force, start), end, steps, GetParam());
            const auto where = fmt::format("{} {} {} {}", force, end, steps, start);
            EXPECT_EQ(outcome.failure, "") << where;
            EXPECT_LE(outcome.summary.largestImbalance, outcome.summary.tolerableImbalance) << where;
            const std::vector<double> speeds = outcome.results.parts.getColumn("PART/2.VZ");
            EXPECT_NEAR(speeds.back() - start, exact, Rounding * std::max(1., std::abs(exact))) << where;
            EXPECT_EQ(outcome.results.parts.getColumn("time").back(), end) << where;
        }
    }
};
INSTANTIATE_TEST_SUITE_P(Integrators, OutputTimes, ::testing::ValuesIn(getIntegratorNames()),
                         [](const auto& info) { return info.param; });

TEST_P(OutputTimes, MayBeThoseOfAJump) {
    for (const char* force : {"IF(TIME-1:0,0,1000)", "IF(TIME-1:0,1000,1000)", "IF(1-TIME:1000,-7E5,0)"})
        for (const int steps : {1, 2, 10}) expectSpeed(force, 2, steps, 1000 / Mass);
}

TEST_P(OutputTimes, MayBeNextToThoseOfAJump) {
    constexpr double Jump = 0.7;
    for (const double end : {std::nextafter(2 * Jump, 0), 2 * Jump, std::nextafter(2 * Jump, 3)})
        expectSpeed("IF(TIME-0.7:0,0,13)", end, 2, 13 * Jump / Mass);
}

// Nothing of what begins there can be seen.
TEST_P(OutputTimes, MayEndAtAJump) {
    expectSpeed("IF(TIME-2:10,10,1E9)", 2, 3, 20 / Mass);
    expectSpeed("IF(TIME-2:10,1E9,1E9)", 2, 3, 20 / Mass);
}

TEST_P(OutputTimes, MayBeginAtAJump) {
    expectSpeed("IF(TIME:0,0,10)", 2, 3, 20 / Mass);
    expectSpeed("IF(TIME:0,1E6,10)", 2, 3, 20 / Mass);
    expectSpeed("IF(SIN(TIME):0,1E6,10)", 2, 3, 20 / Mass);
}

// Where a sine passes a level rounding decides, and IF has a branch for what it hits exactly.
TEST_P(OutputTimes, BesideJumpsWhereASinePasses) {
    for (const double level : {0.5, 0.99}) {
        const double first = std::asin(level), second = SimTK::Pi - first;
        const double push = 2 * (second - first) - std::max(0., 2 * SimTK::Pi + second - 8);
        for (const int steps : {1, 2, 7, 10})
            expectSpeed(fmt::format("IF(SIN(TIME)-{}:0,0,1)", level), 8, steps, push / Mass);
    }
}

// Pulses shorter than output steps, and than errors of positions.
TEST_P(OutputTimes, FarFromShortPulses) {
    for (const double length : {0.1, 1e-4, 1e-7, 1e-10})
        for (const double begin : {1.0, 1.3, 2.0625000000000004})
            expectSpeed(fmt::format("IF(TIME-{}:0,0,IF(TIME-{:.17g}:{},0,0))", begin, begin + length, 10),
                        3.3, 7, 10 * (begin + length - begin) / Mass);
}

}  // namespace
}  // namespace jprim
