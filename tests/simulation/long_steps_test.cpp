// SPDX-License-Identifier: Apache-2.0
// What happens within a step that could be long is not stepped over: short pulses, contacts, sensors, at any output step
// and by any integrator.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "jprim/jprim.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

SimulationOutcome simulateWith(const std::string& text, double end, int steps, const std::string& integrator,
                               double accuracy = 1e-6) {
    const Mechanism mechanism = testing::buildOrFail(text);
    SimulationOptions options;
    options.end = end;
    options.steps = steps;
    options.integrator = integrator;
    options.accuracy = accuracy;
    return simulate(mechanism, assemble(mechanism), options);
}

double getLast(const SimulationOutcome& outcome, const std::string& column) {
    return outcome.results.parts.getColumn(column).back();
}

// Euler's method takes very many steps where errors may be small.
double getAccuracy(const std::string& integrator) {
    return integrator == "SemiExplicitEuler2" ? 1e-4 : 1e-6;
}

class LongSteps : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Integrators, LongSteps, ::testing::ValuesIn(getIntegratorNames()),
                         [](const auto& info) { return info.param; });

// A free part of 2.3 kg, and a force along z.
std::string writePushed(const std::string& force, const std::string& time = "SECOND") {
    return fmt::format(
        "push\nUNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=METER,TIME={}\nPART/1,GROUND\nMARKER/1\n"
        "PART/2,MASS=2.3,CM=20,IP=1,1.2,0.9,VX=0.7\nMARKER/20\n"
        "SFORCE/1,TRANSLATION,ACTIONONLY,I=20,J=1,FUNCTION={}\nEND\n",
        time, force);
}

// Two steps of 10 ms, 52.2 ms apart: 52.2 ms of 7 N.
TEST_P(LongSteps, FeelAPulseInTime) {
    for (const std::string& pulse :
         {std::string("7*STEP(TIME,57.31,0,57.32,1)*STEP(TIME,57.3622,1,57.3722,0)"),
          std::string("7*MAX(0,MIN(1,MIN((TIME-57.31)/0.01,(57.3722-TIME)/0.01)))"),
          std::string("IF(TIME-57.315:0,0,IF(TIME-57.3672:7,7,0))"),
          std::string("IF(SIN((TIME-57.31585)/30)**2+(TIME-57.3411)**2-0.0261**2:7,7,0)")}) {
        const bool isExact = pulse.find("SIN") == std::string::npos;
        const double exact = 7 * 0.0522 / 2.3;
        for (const int steps : {1, 7, 300}) {
            const SimulationOutcome outcome =
                simulateWith(writePushed(pulse), 100, steps, GetParam(), getAccuracy(GetParam()));
            EXPECT_EQ(outcome.failure, "");
            EXPECT_NEAR(getLast(outcome, "PART/2.VZ"), exact, (isExact ? 2e-3 : 1e-2) * exact)
                << pulse << " " << steps;
        }
    }
}

// Balls on one line, the one flying into the other: elastic, so that momentum and energy tell the speeds after it.
TEST_P(LongSteps, FeelAnImpact) {
    constexpr double m1 = 1.3, m2 = 2.9, v1 = 1.7, v2 = -0.4;
    const std::string text = fmt::format(
        "balls\nPART/1,GROUND\nMARKER/1\nPART/2,MASS={},CM=20,IP=1,1,1,QG=0.3,0,-83.1,VZ={}\nMARKER/20\n"
        "PART/3,MASS={},CM=30,IP=1,1,1,QG=0.3,0,41.7,VZ={}\nMARKER/30\n"
        "SFORCE/1,TRANSLATION,I=20,J=30,FUNCTION=IMPACT(DM(20,30),VR(20,30),0.2,8.3E4,1.5,0,0.001)\nEND\n",
        m1, v1, m2, v2);
    const double common = (m1 * v1 + m2 * v2) / (m1 + m2);
    for (const int steps : {1, 3, 50}) {
        const SimulationOutcome outcome = simulateWith(text, 100, steps, GetParam(), getAccuracy(GetParam()));
        EXPECT_EQ(outcome.failure, "");
        EXPECT_NEAR(getLast(outcome, "PART/2.VZ"), 2 * common - v1, 1e-2) << steps;
        EXPECT_NEAR(getLast(outcome, "PART/3.VZ"), 2 * common - v2, 1e-2) << steps;
    }
}

// Past a marker at 0.2 m; within 0.25 m for 0.43 s.
TEST_P(LongSteps, SeeASensorThatIsTrueForAMoment) {
    const auto run = [](const std::string& function) {
        return simulateWith(
            "fly\nPART/1,GROUND\nMARKER/1\nMARKER/2,QP=31.3,0.2,0\n"
            "PART/2,MASS=2.3,CM=20,IP=1,1.2,0.9,VX=0.7\nMARKER/20\nSENSOR/4," +
                function + "\nEND\n",
            100, 2, GetParam(), 1e-4);
    };
    const double close = (31.3 - std::sqrt(0.25 * 0.25 - 0.2 * 0.2)) / 0.7;
    for (const char* text : {"LE,VALUE=0.25,ERROR=1E-6,RETURN,FUNCTION=DM(20,2)",
                             "GE,VALUE=-0.25,ERROR=1E-6,HALT,FUNCTION=-DM(20,2)",
                             "EQ,VALUE=0.25,ERROR=1E-6,HALT,FUNCTION=DM(20,2)",
                             "GE,VALUE=1,RETURN,FUNCTION=IF(DM(20,2)-0.25:1,1,0)"}) {
        const SimulationOutcome outcome = run(text);
        EXPECT_EQ(outcome.summary.endedBy, "SENSOR/4") << text;
        EXPECT_NEAR(getLast(outcome, "time"), close, 1e-4) << text;
    }
    const SimulationOutcome outcome =
        run("GE,VALUE=0.5,RETURN,FUNCTION=STEP(TIME,43.17,0,43.18,1)*IF(TIME-43.19:1,1,0)");
    EXPECT_EQ(outcome.summary.endedBy, "SENSOR/4");
    EXPECT_NEAR(getLast(outcome, "time"), 43.175, 1e-4);
}

// A tooth of a spline over time, whatever its unit: 3.1 N for 20 ms on both sides of its tip.
TEST_P(LongSteps, FeelATooth) {
    for (const bool isMilli : {false, true}) {
        const double s = isMilli ? 1000 : 1;
        std::string text = writePushed("CUBSPL(TIME,0,3)", isMilli ? "MILLISECOND" : "SECOND");
        text.insert(text.find("END\n"), fmt::format("SPLINE/3,X=0,{},{},{},{},{},Y=0,0,0,3.1,0,0\n", 20 * s,
                                                    40.01 * s, 40.03 * s, 40.05 * s, 90 * s));
        const SimulationOutcome fine = simulateWith(text, 50 * s, 2000, "RungeKuttaMerson");
        const SimulationOutcome coarse = simulateWith(text, 50 * s, 2, GetParam(), getAccuracy(GetParam()));
        const double exact = getLast(fine, "PART/2.VZ");
        EXPECT_NE(exact, 0);
        EXPECT_NEAR(getLast(coarse, "PART/2.VZ"), exact, 5e-3 * std::abs(exact));
    }
}

}  // namespace
}  // namespace jprim
