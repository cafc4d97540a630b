// SPDX-License-Identifier: Apache-2.0
// Accuracy is relative to the motion that there is, however small, whatever the unit and the output step.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/format.h"
#include "jprim/jprim.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

constexpr double OfAmplitude = 1e-3;  // at the default accuracy of 1e-6, over some ten periods

double findLargestError(const Table& requests, const std::function<double(double)>& exact) {
    double largest = 0;
    for (size_t row = 0; row < requests.getNumRows(); ++row)
        largest = std::max(largest, std::abs(requests.getValue(row, 1) - exact(requests.getValue(row, 0))));
    return largest;
}

SimulationOutcome simulateWith(const Mechanism& mechanism, double end, int steps,
                               const std::string& integrator) {
    SimulationOptions options;
    options.end = end;
    options.steps = steps;
    options.integrator = integrator;
    SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    EXPECT_EQ(outcome.failure, "");
    EXPECT_LE(outcome.summary.largestImbalance, outcome.summary.tolerableImbalance);
    return outcome;
}

constexpr double Size = 0.31, Mass = 47.3, Stiffness = 2.06e5;

// A block on a slide along an axis of no special direction, shot off from where its spring is not strained.
std::string writeBlock(double amplitude, bool inMillimeters) {
    const double L = inMillimeters ? 1000 : 1, speed = L * amplitude * Size * std::sqrt(Stiffness / Mass);
    const SimTK::Vec3 axis(std::sin(0.3) * std::sin(1.1), -std::cos(0.3) * std::sin(1.1), std::cos(1.1));
    const SimTK::Vec3 anchor = -L * Size * axis, v = speed * axis;
    return fmt::format(
        "block\nUNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH={},TIME=SECOND\nPART/1,GROUND\n"
        "MARKER/11,QP={},{},{},REULER=0.3,1.1,0\nPART/2,MASS={},CM=2,IP={},{},{},VX={},VY={},VZ={}\nMARKER/2\n"
        "MARKER/21,REULER=0.3,1.1,0\nJOINT/1,TRANSLATIONAL,I=21,J=11\n"
        "SPRINGDAMPER/1,TRANSLATION,I=2,J=11,K={},C=0,LENGTH={}\nREQUEST/1,F2=DZ(2,11,11)-{}\\\n",
        inMillimeters ? "MILLIMETER" : "METER", anchor[0], anchor[1], anchor[2], Mass, L * L, 1.3 * L * L,
        1.1 * L * L, v[0], v[1], v[2], Stiffness / L, L * Size, L * Size);
}

class SmallVibration : public ::testing::TestWithParam<std::tuple<double, bool, Formulation, const char*>> {};

TEST_P(SmallVibration, IsRightToAThousandth) {
    const auto& [amplitude, inMillimeters, formulation, integrator] = GetParam();
    const Mechanism mechanism =
        testing::buildOrFail(writeBlock(amplitude, inMillimeters) + "END\n", {formulation});
    const double A = amplitude * Size * (inMillimeters ? 1000 : 1), w = std::sqrt(Stiffness / Mass);
    for (const int steps : {20, 333}) {
        const SimulationOutcome outcome = simulateWith(mechanism, 1, steps, integrator);
        const double error =
            findLargestError(outcome.results.requests, [&](double t) { return A * std::sin(w * t); });
        EXPECT_LT(error, OfAmplitude * A) << steps;
    }
}

INSTANTIATE_TEST_SUITE_P(Amplitudes, SmallVibration,
                         ::testing::Combine(::testing::Values(1e-9, 1e-6, 1e-3, 0.5), ::testing::Bool(),
                                            ::testing::Values(Formulation::Tree, Formulation::Constraints),
                                            ::testing::Values("RungeKuttaMerson", "CPodes")));

// x = F/(m w^2) (w t - sin w t): at first neither moves nor is accelerated.
TEST(SmallMotion, BeginsFromRest) {
    constexpr double Force = 3e-5, Frequency = 31, End = 2;
    const Mechanism mechanism = testing::buildOrFail(
        fmt::format("m\nPART/1,GROUND\nMARKER/1\nPART/2,MASS=2.5,CM=20,IP=1,1,1,QG=0,0,0.5\nMARKER/20\n"
                    "JOINT/1,TRANSLATIONAL,I=20,J=1\nREQUEST/1,F2=DZ(20,1,1)-0.5\\\n"
                    "SFORCE/1,TRANSLATION,I=20,J=1,FUNCTION={}*SIN({}*TIME)\nEND\n",
                    Force, Frequency));
    const double A = Force / (2.5 * Frequency * Frequency);
    for (const char* integrator : {"RungeKuttaMerson", "CPodes"}) {
        const SimulationOutcome outcome = simulateWith(mechanism, End, 7, integrator);
        EXPECT_LT(findLargestError(outcome.results.requests,
                                   [&](double t) { return A * (Frequency * t - std::sin(Frequency * t)); }),
                  OfAmplitude * A * Frequency * End)
            << integrator;
    }
}

// Let go a little beside where it hangs: theta = A cos w t, w^2 = m g l/(I + m l^2).
TEST(SmallMotion, SwingsFromRest) {
    constexpr double A = 1e-7, Length = 0.4, w2 = 3 * 9.81 * Length / (0.2 + 3 * Length * Length);
    const Mechanism mechanism = testing::buildOrFail(
        fmt::format("p\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/1\n"
                    "PART/2,MASS=3,CM=20,IP=0.1,0.1,0.2,REULER={},0,0\nMARKER/20,QP=0,{},0\nMARKER/21\n"
                    "JOINT/1,REVOLUTE,I=21,J=1\nREQUEST/1,F2=AZ(21,1)\\\nEND\n",
                    A, -Length));
    const SimulationOutcome outcome = simulateWith(mechanism, 10, 20, "RungeKuttaMerson");
    EXPECT_LT(
        findLargestError(outcome.results.requests, [&](double t) { return A * std::cos(std::sqrt(w2) * t); }),
        OfAmplitude * A);
}

// What moves little beside what moves much.
TEST(SmallMotion, BesideAFastRotor) {
    constexpr double Amplitude = 1e-4;
    const std::string text = writeBlock(Amplitude, false) +
                             "MARKER/12,PART=1,QP=0,0,2\nPART/3,MASS=1,CM=30,IP=0.1,0.1,0.2,QG=0,0,2,WZ=100\n"
                             "MARKER/30\nJOINT/2,REVOLUTE,I=30,J=12\nEND\n";
    for (const Formulation formulation : {Formulation::Tree, Formulation::Constraints}) {
        const SimulationOutcome outcome =
            simulateWith(testing::buildOrFail(text, {formulation}), 1, 20, "RungeKuttaMerson");
        const double A = Amplitude * Size, w = std::sqrt(Stiffness / Mass);
        EXPECT_LT(findLargestError(outcome.results.requests, [&](double t) { return A * std::sin(w * t); }),
                  OfAmplitude * A);
    }
}

// At rest there is nothing to hold errors against, and no reason for shorter steps than those that keep an explicit
// method from making much of rounding errors.
TEST(SmallMotion, RestCostsNothing) {
    constexpr double Time = 10, OfRadian = 0.5, Rounding = 1e-10;
    const std::string weight =
        "w\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/1\nPART/2,MASS=14.3,CM=20,IP=1,1,1,QG=0.1,-0.5,0.3\n"
        "MARKER/20\nMARKER/21,QP=0.1,0.1,0\nSPRINGDAMPER/1,TRANSLATION,I=21,J=1,K=7213.7,C=0,LENGTH=0.3\nEND\n";
    struct Case {
        std::string text;
        double frequency;
    };
    for (const Case& c : {Case{writeBlock(0, true) + "END\n", std::sqrt(Stiffness / Mass)},
                          Case{weight, std::sqrt(7213.7 / 14.3)}})
        for (const char* integrator : {"RungeKuttaMerson", "CPodes"}) {
            const Mechanism mechanism = testing::buildOrFail(c.text, {Formulation::Tree});
            AssembledState initial = assemble(mechanism);
            initial.state = findEquilibrium(mechanism, initial.state);
            SimulationOptions options;
            options.end = Time;
            options.steps = 10;
            options.integrator = integrator;
            const SimulationSummary summary = simulate(mechanism, initial, options).summary;
            const double most = integrator == std::string("CPodes") ? 40 : c.frequency * Time / OfRadian;
            EXPECT_LT(summary.stepsTaken, most) << integrator;
            EXPECT_LE(summary.largestImbalance, summary.tolerableImbalance) << integrator;
            EXPECT_LT(summary.largestImbalance, Rounding) << integrator;
        }
}

}  // namespace
}  // namespace jprim
