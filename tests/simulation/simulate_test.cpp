// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/simulate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"
#include "support/bead_on_swing.h"
#include "support/expect_error.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Vec3;
using testing::buildOrFail;

//---------------------------------------------------------------------------------- a known mechanism
// The statement of the Adams documentation, with its leading zeros, in a mechanism that slides: a block on a
// line inclined by 30 degrees falls with g sin(30) along it and presses with m g cos(30) across it.
TEST(Simulate, DocumentationExampleSlides) {
    const Mechanism mechanism = buildOrFail(
        "slide\nUNITS/SYSTEM=MKS\nACCGRAV/KGRAV=-9.80665\nPART/01,GROUND\nMARKER/0240,REULER=90D,60D,0D\n"
        "PART/02,MASS=3,CM=0140,IP=1,1,1\nMARKER/0140\nJPRIM/0102, INLINE, I=0140, J=0240\n"
        "REQUEST/1,DISPLACEMENT,I=140,J=240,RM=240\nREQUEST/2,FORCE,I=140,J=240,RM=240\nEND\n");
    const SimulationOutcome outcome = testing::run(mechanism, 2, 4, 1e-8);
    const double g = 9.80665, along = g * std::sin(SimTK::Pi / 6);
    EXPECT_NEAR(outcome.results.requests.getColumn("R1.Z").back(), -0.5 * along * 4, 1e-7);
    EXPECT_NEAR(outcome.results.requests.getColumn("R1.X").back(), 0, 1e-7);
    EXPECT_NEAR(outcome.results.requests.getColumn("R2.FM").back(), 3 * g * std::cos(SimTK::Pi / 6), 1e-7);
    EXPECT_NEAR(outcome.results.requests.getColumn("R2.FZ").back(), 0, 1e-9);
    EXPECT_EQ(outcome.summary.degreesOfFreedom, 4);
}

// Nothing accelerates, and rounding must not be taken for a lost equation.
TEST(Simulate, ABalancedRotorTurnsSteadily) {
    const Mechanism mechanism = buildOrFail(
        "rotor\nPART/1,GROUND\nMARKER/10,REULER=0.1,0.2,0.3\n"
        "PART/2,MASS=2,CM=20,IP=0.3,0.3,0.5,WZ=7,REULER=0.1,0.2,0.3\nMARKER/20\n"
        "JOINT/1,REVOLUTE,I=20,J=10\nEND\n");
    const Results results = testing::run(mechanism, 1, 10, 1e-8).results;
    EXPECT_NEAR(results.parts.getColumn("energy.kinetic").back(), 0.5 * 0.5 * 49, 1e-9);
}

// REQUEST/FORCE is the load on its I by its J, whichever of the two the connection calls I.
TEST(Simulate, ForceRequestsLookFromTheirOwnMarker) {
    const Mechanism mechanism = buildOrFail(
        "t\nACCGRAV/KGRAV=-10\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20\n"
        "JOINT/1,FIXED,I=10,J=20\nREQUEST/1,FORCE,I=10,J=20\nREQUEST/2,FORCE,I=20,J=10\n"
        "REQUEST/3,FORCE,I=20\nEND\n");
    const Table requests = testing::run(mechanism, 1, 1, 1e-6).results.requests;
    EXPECT_NEAR(requests.getColumn("R1.FZ").back(), -20, 1e-9);
    EXPECT_NEAR(requests.getColumn("R2.FZ").back(), 20, 1e-9);
    EXPECT_EQ(requests.getColumn("R3.FM").back(), 0);  // no action-only forces exist yet
}

// Two primitives between the same markers, each calling another one I: both count, from the request's side.
TEST(Simulate, ForceRequestsAddWhatActsBetweenTheirMarkers) {
    const Mechanism mechanism = buildOrFail(
        "t\nACCGRAV/IGRAV=3,KGRAV=-10\nPART/1,GROUND\nMARKER/10,REULER=0.4,0.3,0.2\n"
        "PART/2,MASS=2,CM=20,IP=1,2,1.5\nMARKER/20,QP=0.5,0.1,0.2\nMARKER/21,REULER=0.4,0.3,0.2\n"
        "JPRIM/1,ATPOINT,I=21,J=10\nJPRIM/2,PARALLEL_AXES,I=10,J=21\nREQUEST/1,FORCE,I=21,J=10\nEND\n");
    const Results results = testing::run(mechanism, 0.3, 3, 1e-6).results;
    for (const char* component : {"FX", "FY", "FZ", "TX", "TY", "TZ"}) {
        const std::string name = component;
        const double sum = results.reactions.getColumn("JPRIM/1.I." + name).back() +
                           results.reactions.getColumn("JPRIM/2.J." + name).back();
        EXPECT_NEAR(results.requests.getColumn("R1." + name).back(), sum, 1e-12) << name;
        EXPECT_GT(std::abs(sum), 1e-3) << name << ": nothing to add";
    }
}

TEST(Simulate, ColumnsAreNamedAsPromised) {
    const Mechanism mechanism = buildOrFail(testing::makeBeadOnSwing("UNITS/SYSTEM=MKS", 1, 1, 1));
    const Results results = testing::run(mechanism, 0.1, 1, 1e-6).results;
    const std::string requests = join(results.requests.columns, " ");
    EXPECT_EQ(
        requests,
        "time R1.MAG R1.X R1.Y R1.Z R1.PSI R1.THETA R1.PHI R2.VM R2.VX R2.VY R2.VZ R2.WM R2.WX R2.WY R2.WZ "
        "R3.ACCM R3.ACCX R3.ACCY R3.ACCZ R3.WDTM R3.WDTX R3.WDTY R3.WDTZ "
        "R4.FM R4.FX R4.FY R4.FZ R4.TM R4.TX R4.TY R4.TZ R5.FM R5.FX R5.FY R5.FZ R5.TM R5.TX R5.TY R5.TZ");
    const std::string reactions = join(results.reactions.columns, " ");
    EXPECT_EQ(reactions.substr(0, 70),
              "time JPRIM/2.I.FX JPRIM/2.I.FY JPRIM/2.I.FZ JPRIM/2.I.TX JPRIM/2.I.TY ");
    EXPECT_EQ(results.reactions.columns.size(), 1u + 3 * 12);
    const std::string parts = join(results.parts.columns, " ");
    EXPECT_EQ(parts.substr(0, 121),
              "time PART/2.X PART/2.Y PART/2.Z PART/2.E0 PART/2.E1 PART/2.E2 PART/2.E3 PART/2.VX PART/2.VY "
              "PART/2.VZ "
              "PART/2.WX PART/2.WY");
    EXPECT_EQ(parts.substr(parts.size() - 70),
              " energy.kinetic energy.potential energy.total error.length error.angle");
}

TEST(Simulate, SummaryTellsWhatHappened) {
    const Mechanism mechanism = buildOrFail(testing::makeBeadOnSwing("UNITS/SYSTEM=MKS", 1, 1, 1));
    double lastProgress = 0;
    SimulationOptions options;
    options.end = 1;
    options.reportProgress = [&lastProgress](double fraction) { lastProgress = fraction; };
    const SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    EXPECT_EQ(lastProgress, 1);
    EXPECT_EQ(outcome.results.parts.getNumRows(), 101u);
    EXPECT_EQ(outcome.summary.degreesOfFreedom, 1 + 2);
    EXPECT_EQ(outcome.summary.redundantEquations, 0);
    EXPECT_GE(outcome.summary.stepsTaken, 100);
    EXPECT_LT(outcome.summary.largestEnergyChange, 1e-4 * outcome.summary.energyScale);
    EXPECT_LT(outcome.summary.worstViolation.length, 1e-6);
}

SimulationSummary runWithMaximumStep(const std::string& units, double perSecond, double maximumStep) {
    SimulationOptions options;
    options.end = 1 * perSecond;
    options.steps = 1;
    options.accuracy = 1e-3;
    options.maximumStep = maximumStep;
    const Mechanism mechanism = buildOrFail(testing::makeBeadOnSwing(units, 1, 1, perSecond));
    return simulate(mechanism, assemble(mechanism), options).summary;
}

TEST(Simulate, StepsAreNoLongerThanTheMaximumInTheDatasetsUnit) {
    const std::string ms = "UNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=METER,TIME=MILLISECOND";
    EXPECT_LT(runWithMaximumStep(ms, 1000, 1000).stepsTaken, 90);
    const int steps = runWithMaximumStep(ms, 1000, 10).stepsTaken;
    EXPECT_GE(steps, 100);
    EXPECT_LE(steps, 110);
}

TEST(Simulate, ConstraintErrorsAreHeldToTheirTolerance) {
    const Mechanism mechanism =
        buildOrFail(testing::makeBeadOnSwing("UNITS/SYSTEM=MKS", 1, 1, 1), {Formulation::Constraints});
    SimulationOptions options;
    options.end = 1;
    options.steps = 1;
    options.accuracy = 0.09;
    const double loose = simulate(mechanism, assemble(mechanism), options).summary.worstViolation.length;
    options.constraintTolerance = 1e-11;
    const double tight = simulate(mechanism, assemble(mechanism), options).summary.worstViolation.length;
    // The tolerance is on the root mean square of all equations, fewer than a hundred here.
    EXPECT_LT(tight, 1e-10);
    EXPECT_GT(loose, 1e-10);
}

//------------------------------------------------------------------------------------------- failures
// The bead has moved by 0.3 m, 0.22 of it along x; the integrators of lowest order are good to 2 % of that
// here.
TEST(Simulate, EveryIntegratorAgrees) {
    const Mechanism mechanism = buildOrFail(testing::makeBeadOnSwing("UNITS/SYSTEM=MKS", 1, 1, 1));
    const double exact = testing::run(mechanism, 0.5, 5, 1e-9).results.parts.getColumn("PART/3.X").back();
    for (const std::string& name : getIntegratorNames()) {
        SimulationOptions options;
        options.end = 0.5;
        options.steps = 5;
        options.accuracy = 1e-4;
        options.integrator = name;
        const SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
        EXPECT_EQ(outcome.failure, "") << name;
        EXPECT_NEAR(outcome.results.parts.getColumn("PART/3.X").back(), exact, 5e-3) << name;
    }
}

TEST(Simulate, FailureNamesTheTimeAndKeepsTheResultsSoFar) {
    const Mechanism mechanism =
        buildOrFail(testing::makeBeadOnSwing("UNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=METER,TIME=MILLISECOND",
                                             1, 1, 1000),
                    {Formulation::Constraints});
    SimulationOptions options;
    options.end = 1000;  // ms
    options.steps = 10;
    options.reportProgress = [](double fraction) {
        if (fraction > 0.45) throw std::runtime_error("stopped\nhere");
    };
    const SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    EXPECT_EQ(
        outcome.failure.find("at time 500: the simulation cannot go on; the largest constraint error is "),
        0u)
        << outcome.failure;
    EXPECT_EQ(outcome.failure.substr(outcome.failure.size() - 14), ": stopped here");
    EXPECT_EQ(outcome.results.parts.getNumRows(), 6u);
    EXPECT_EQ(outcome.results.parts.getColumn("time").back(), 500);
}

TEST(Simulate, AccelerationsThatAreNotFiniteAreAFailure) {
    const Mechanism mechanism = buildOrFail(
        "t\nACCGRAV/KGRAV=-1E300\nPART/1,GROUND\nMARKER/10\nPART/2,QG=-1,0,0,MASS=1,CM=20,IP=1,1,1\n"
        "MARKER/20\nMARKER/21,QP=1,0,0\nJPRIM/5,ATPOINT,I=21,J=10\nEND\n");
    SimulationOptions options;
    options.end = 1;
    EXPECT_EQ(simulate(mechanism, assemble(mechanism), options).failure,
              "at time 0: the simulation cannot go on: accelerations are not finite");
}

void expectOptionError(const SimulationOptions& options, const std::string& text) {
    const Mechanism mechanism = buildOrFail("t\nPART/1,GROUND\nEND\n");
    EXPECT_EQ(testing::catchError([&] { simulate(mechanism, assemble(mechanism), options); }), text);
}

TEST(Simulate, RefusesImpossibleOptions) {
    SimulationOptions options;
    expectOptionError(options, "end: 0 is not a time after the start at 0");
    options.end = 1;
    options.steps = -1;
    expectOptionError(options, "steps: -1 is not a positive number");
    options.steps = 1;
    options.accuracy = 2;
    expectOptionError(options, "accuracy: 2 is not between 0 and 1");
    options.accuracy = 1e-3;
    options.constraintTolerance = 0;
    expectOptionError(options, "constraint tolerance: 0 is not between 0 and 1");
    options.constraintTolerance = std::nullopt;
    options.maximumStep = std::nan("");
    expectOptionError(options, "maximum step: nan is not a positive time");
    options.maximumStep = 1;
    options.integrator = "Euler";
    expectOptionError(options,
                      "integrator Euler: is not known; use one of RungeKuttaMerson, RungeKutta3, Verlet, "
                      "SemiExplicitEuler2, CPodes");
}

// Nothing accelerates, so that rounding errors are all there is.
TEST(Simulate, AStructureCarriesALoadInDynamics) {
    const Mechanism mechanism = buildOrFail(
        "t\nPART/1,GROUND\nMARKER/10\nMARKER/11,QP=3,0,0\nMARKER/12,QP=2,-1,0\nPART/2,MASS=1,CM=20,IP=1,1,1\n"
        "MARKER/20,QP=0.7,0.5,0.1\nMARKER/21\nMARKER/22,QP=1,1,0\n"
        "PART/3,MASS=2,CM=30,IP=1,1,1,QG=1,1,0\nMARKER/30,QP=0.9,-0.4,0\nMARKER/31\nMARKER/32,QP=2,-1,0\n"
        "JOINT/1,REVOLUTE,I=21,J=10\nJOINT/2,REVOLUTE,I=31,J=22\nJOINT/3,REVOLUTE,I=32,J=11\n"
        "SFORCE/1,TRANSLATION,I=30,J=12,FUNCTION=777.7\nREQUEST/1,FORCE,I=32,J=11\n"
        "REQUEST/2,FORCE,I=21,J=10\nREQUEST/3,FORCE,I=30,J=12\nEND\n");
    SimulationOptions options;
    options.end = 1;
    options.steps = 2;
    options.kind = SimulationKind::Dynamics;
    const SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    ASSERT_EQ(outcome.failure, "");
    for (const char* axis : {"FX", "FY"}) {
        const auto at = [&](const char* request) {
            return outcome.results.requests.getColumn(std::string(request) + axis).back();
        };
        EXPECT_NEAR(at("R1.") + at("R2.") + at("R3."), 0, 1e-9) << axis;
        EXPECT_GT(std::abs(at("R3.")), 1) << axis;
    }
}

TEST(Simulate, AMechanismWithoutMovingPartsRuns) {
    const Mechanism mechanism = buildOrFail("t\nPART/1,GROUND\nEND\n");
    EXPECT_EQ(testing::run(mechanism, 1, 2, 1e-6).results.parts.getNumRows(), 3u);
}

}  // namespace
}  // namespace jprim
