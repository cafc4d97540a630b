// SPDX-License-Identifier: Apache-2.0
// The energy's balance tells of wrong results, and of nothing else: whatever drives and brakes a mechanism, whichever
// integrator moves it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "base/format.h"
#include "jprim/jprim.h"
#include "simulation/energy_watch.h"
#include "support/driven_dataset.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

struct IntegratorCase {
    const char* name;
    double accuracy;
};

// Of the accuracies that a method reaches in reasonable time.
const IntegratorCase Cases[] = {{"RungeKuttaMerson", 1e-6}, {"CPodes", 1e-6}, {"CPodes", 1e-4},
                                {"RungeKutta3", 1e-4},      {"Verlet", 1e-5}, {"SemiExplicitEuler2", 1e-4}};

SimulationOutcome simulateWith(const Mechanism& mechanism, const AssembledState& initial,
                               const std::string& integrator, double accuracy) {
    SimulationOptions options;
    options.end = 1;
    options.steps = 20;
    options.integrator = integrator;
    options.accuracy = accuracy;
    return simulate(mechanism, initial, options);
}

// The largest difference of two runs: of each part's positions, velocities and angular velocities, relative to the
// largest changes of these.
double calcDifference(const Table& a, const Table& b) {
    double largest = 0;
    for (const std::vector<const char*>& group :
         {std::vector<const char*>{".X", ".Y", ".Z"}, {".VX", ".VY", ".VZ"}, {".WX", ".WY", ".WZ"}}) {
        double difference = 0, range = 0;
        for (size_t c = 1; c < a.columns.size(); ++c) {
            const std::string& name = a.columns[c];
            for (const char* ending : group) {
                if (name.substr(name.find('.')) != ending) continue;
                for (size_t row = 0; row < std::min(a.getNumRows(), b.getNumRows()); ++row) {
                    difference = std::max(difference, std::abs(a.getValue(row, c) - b.getValue(row, c)));
                    range = std::max(range, std::abs(a.getValue(row, c) - a.getValue(0, c)));
                }
            }
        }
        if (range > 0) largest = std::max(largest, difference / range);
    }
    return largest;
}

int getNumMechanisms() {
    constexpr int Usual = 20;
    const char* wanted = std::getenv("JPRIM_TEST_MECHANISMS");
    return wanted ? std::atoi(wanted) : Usual;
}

TEST(EnergyAlarm, IsSilentWhereResultsAreRight) {
    constexpr double Agreement = 1e-3, Reference = 1e-10, Share = 0.7;
    int agreeing = 0, runs = 0;
    for (int seed = 1; seed <= getNumMechanisms(); ++seed) {
        const std::string text = testing::DrivenDataset(unsigned(seed)).write();
        const Mechanism mechanism = testing::buildOrFail(text);
        const AssembledState initial = assemble(mechanism);
        const SimulationOutcome reference = simulateWith(mechanism, initial, "RungeKuttaMerson", Reference);
        if (reference.summary.isKinematic) continue;
        ASSERT_EQ(reference.failure, "") << text;
        EXPECT_LE(reference.summary.largestImbalance, reference.summary.tolerableImbalance) << seed;
        for (const IntegratorCase& c : Cases) {
            const SimulationOutcome outcome = simulateWith(mechanism, initial, c.name, c.accuracy);
            const double difference = calcDifference(reference.results.parts, outcome.results.parts);
            const double imbalance = outcome.summary.largestImbalance / outcome.summary.tolerableImbalance;
            ++runs;
            if (difference > Agreement) continue;
            ++agreeing;
            EXPECT_EQ(outcome.failure, "") << seed << " " << c.name << "\n" << text;
            EXPECT_LE(imbalance, 1) << seed << " " << c.name << " " << c.accuracy << "\n" << text;
        }
    }
    EXPECT_GT(agreeing, Share * runs);
}

const char* const Pendulum =
    "p\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nMARKER/11,QP=0.9,-0.3,0\n"
    "PART/2,MASS=2,CM=20,IP=0.03,0.05,0.04\nMARKER/20,QP=0.3,0.1,0.02\nMARKER/21\n"
    "JOINT/1,REVOLUTE,I=21,J=10\n";

// What a watch says of two States, one after the other: the change of the balance, in what is tolerable.
double calcImbalance(const Mechanism& mechanism, SimTK::State first, SimTK::State then) {
    SimulationSummary summary;
    EnergyWatch watch(mechanism, summary);
    for (SimTK::State* state : {&first, &then}) {
        mechanism.getSystem().realize(*state, SimTK::Stage::Acceleration);
        watch.observe(*state);
        watch.checkBalance(*state);
    }
    return summary.largestImbalance / summary.tolerableImbalance;
}

// With all the work that was done a run is silent; with a twentieth more or less it is not.
TEST(EnergyAlarm, RingsIfPowerIsWrong) {
    const Mechanism mechanism = testing::buildOrFail(
        std::string(Pendulum) +
        "SFORCE/1,ROTATION,I=21,J=10,FUNCTION=9*STEP(TIME,0.2,0,0.4,1)-0.3*WZ(21,10,10)\nEND\n");
    const AssembledState initial = assemble(mechanism);
    for (const std::string& integrator : getIntegratorNames()) {
        const SimTK::State final = simulateWith(mechanism, initial, integrator, 1e-5).finalState;
        EXPECT_LT(calcImbalance(mechanism, initial.state, final), 1) << integrator;
        for (const double factor : {0.95, 1.05, -1.}) {
            SimTK::State mutant = final;
            mutant.updZ() *= factor;
            EXPECT_GT(calcImbalance(mechanism, initial.state, mutant), 1) << integrator << " " << factor;
        }
    }
}

// A tenth of the speed is a noticeable part of the energy, however little there is; speeds of rounding errors are none.
TEST(EnergyAlarm, RingsForSmallMotionsAndNotAtRest) {
    const std::string spring =
        "PART/1,GROUND\nMARKER/1\nPART/2,MASS=47,CM=20,IP=1,1,1,QG=0,0,0.31\nMARKER/20\n"
        "JOINT/1,TRANSLATIONAL,I=20,J=1\nSPRINGDAMPER/1,TRANSLATION,I=20,J=1,K=2E5,C=0,LENGTH=0.31\nEND\n";
    const Mechanism light = testing::buildOrFail("t\n" + spring);
    const Mechanism heavy = testing::buildOrFail("t\nACCGRAV/KGRAV=-9.81\n" + spring);
    SimTK::State state = assemble(light).state;
    for (const double speed : {1e-8, 1e-4, 1.}) {
        state.updU() = speed;
        SimTK::State slower = state;
        slower.updU() *= 0.9;
        EXPECT_GT(calcImbalance(light, state, slower), 1) << speed;
        slower.updU() = 0.9999 * state.getU();
        EXPECT_LT(calcImbalance(light, state, slower), 1) << speed;
    }
    state = findEquilibrium(heavy, assemble(heavy).state);
    SimTK::State other = state;
    other.updU() = 1e-13;
    other.updQ() += 1e-15;
    EXPECT_LT(calcImbalance(heavy, state, other), 1);
}

// The rod of a crank and a rocker between two balls: the work of the motor was once integrated to first order.
TEST(EnergyAlarm, IsSilentForCPodesAtAnyAccuracy) {
    const Mechanism mechanism = testing::buildOrFail(
        "linkage\nPART/1,GROUND\nMARKER/1\nMARKER/2,QP=3.7,0,0\nPART/2,MASS=1.2,CM=20,IP=0.1,0.1,0.1\n"
        "MARKER/20,QP=0,0.5,0\nMARKER/21\nMARKER/22,QP=0,1,0\n"
        "PART/3,MASS=0.9,CM=30,IP=0.01,0.5,0.5,QG=0,1,0\nMARKER/30,QP=1.8,0.5,0\nMARKER/31\n"
        "MARKER/32,QP=3.7,1,0\nPART/4,MASS=1.1,CM=40,IP=0.1,0.1,0.1,QG=3.7,0,0\nMARKER/40,QP=0,1,0\n"
        "MARKER/41\nMARKER/42,QP=0,2,0\nJOINT/1,REVOLUTE,I=21,J=1\nJOINT/2,SPHERICAL,I=31,J=22\n"
        "JOINT/3,SPHERICAL,I=42,J=32\nJOINT/4,REVOLUTE,I=41,J=2\n"
        "MOTION/1,JOINT=1,FUNCTION=SHF(TIME,0,10D,180D,90D,10D)\nEND\n");
    const AssembledState initial = assemble(mechanism);
    for (const double accuracy : {1e-3, 1e-5, 1e-7}) {
        const SimulationSummary summary = simulateWith(mechanism, initial, "CPodes", accuracy).summary;
        EXPECT_LT(summary.largestImbalance, std::max(1e-6, accuracy) * summary.energyScale) << accuracy;
    }
}

}  // namespace
}  // namespace jprim
