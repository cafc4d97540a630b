// SPDX-License-Identifier: Apache-2.0
// What GCONs hold: a rolling disc, distances, what a joint would hold as well, and what cannot be held.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "jprim/simulation/equilibrium.h"
#include "support/dataset_units.h"
#include "support/expect_error.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using testing::buildOrFail;
using testing::calcDeviation;
using testing::DatasetUnits;
using testing::MetreSecond;

constexpr double Tolerance = 1e-7;

class Equations : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(Equations);

//-------------------------------------------------------------------------------------------- rolling
constexpr double Radius = 0.25, Spin = 6, Yaw = 1.5;  // m, rad/s, rad/s

// An upright disc, its own axis z horizontal, rolls on the ground's xy plane without slipping: the velocity of the
// centre is w x (R z_ground). It spins and turns about the vertical steadily, on a circle of R Spin/Yaw.
std::string makeDisc(const DatasetUnits& u, double radius = Radius) {
    const double R = radius * u.m;
    return fmt::format(
               "disc\n{0}ACCGRAV/KGRAV={1}\nPART/1,GROUND\nMARKER/10,QP=0,0,{2}\n"
               "PART/2,MASS=3,CM=20,IP={3},{3},{4},QG=0,0,{2},REULER=0,90D,0,WM=10,WX=0,WY={5},WZ={6}\n"
               "MARKER/20\nJPRIM/1,PERPENDICULAR,I=20,J=10\nJPRIM/2,INPLANE,I=20,J=10\n",
               u.statement, -9.8 * u.m / u.s / u.s, Radius * u.m, 0.05 * u.m * u.m, 0.09 * u.m * u.m,
               Spin / u.s, Yaw / u.s) +
           fmt::format(
               "GCON/1,I=20,FUNCTION=VX(20)-{0}*WY(20)\nGCON/2,I=20,FUNCTION=VY(20)\n,+{0}*WX(20)\n"
               "REQUEST/1,F2=GCON(1,0,2)\\F3=GCON(2,0,3)\nEND\n",
               R);
}

double calcDiscDeviation(const DatasetUnits& u, const Results& results) {
    const std::vector<double> time = results.parts.getColumn("time");
    const double circle = Radius * Spin / Yaw;
    const auto x = [=](double t) { return circle * std::sin(Yaw * t); };
    const auto y = [=](double t) { return circle * (1 - std::cos(Yaw * t)); };
    return std::max(calcDeviation(time, u.s, results.parts.getColumn("PART/2.X"), u.m, x),
                    calcDeviation(time, u.s, results.parts.getColumn("PART/2.Y"), u.m, y));
}

TEST_P(Equations, ADiscRollsOnACircle) {
    const Mechanism mechanism = buildOrFail(makeDisc(u));
    EXPECT_TRUE(mechanism.isConservative());
    const SimulationOutcome outcome = testing::run(mechanism, 5 * u.s, 25, 1e-10);
    EXPECT_EQ(outcome.summary.degreesOfFreedom, 2);
    EXPECT_LE(calcDiscDeviation(u, outcome.results), Tolerance);
    // Friction alone bends the path: m v Yaw towards the centre of the circle, which is at +y at the start.
    EXPECT_NEAR(outcome.results.requests.getColumn("R1.F2")[0], 0, Tolerance);
    EXPECT_NEAR(outcome.results.requests.getColumn("R1.F3")[0], 3 * Radius * Spin * Yaw, 1e-6);
    const std::vector<double> energy = outcome.results.parts.getColumn("energy.total");
    EXPECT_NEAR(energy.back(), energy[0], Tolerance * u.m);
}

TEST(EquationsMutated, ADiscOfAnotherRadiusIsNoticed) {
    const Results results =
        testing::run(buildOrFail(makeDisc(MetreSecond, 1.001 * Radius)), 5, 25, 1e-10).results;
    EXPECT_GT(calcDiscDeviation(MetreSecond, results), 1e-4);
}

//--------------------------------------------------------------------------------- what a joint holds
std::string makePendulum(const DatasetUnits& u, const std::string& constraints) {
    return fmt::format(
        "pendulum\n{0}ACCGRAV/KGRAV={1}\nPART/1,GROUND\nMARKER/10,QP={2},0,0,REULER=0.3,0.4,0.5\n"
        "PART/2,MASS=2,CM=20,IP={3},{4},{4},WX={5},WZ={6}\nMARKER/20\nMARKER/21,QP={2},0,0,REULER=0.3,0.4,0.5\n"
        "{7}REQUEST/1,FORCE,I=21,J=10\nEND\n",
        u.statement, -9.8 * u.m / u.s / u.s, 0.4 * u.m, 0.02 * u.m * u.m, 0.3 * u.m * u.m, 2 / u.s, 1 / u.s,
        constraints);
}

void expectSame(const Table& a, const Table& b, double length) {
    ASSERT_EQ(a.columns, b.columns);
    for (size_t k = 0; k < a.values.size(); ++k)
        EXPECT_NEAR(a.values[k], b.values[k], 10 * Tolerance * length) << a.columns[k % a.columns.size()];
}

TEST_P(Equations, ThreeOfThemAreAnAtpoint) {
    const auto run = [this](const std::string& constraints) {
        return testing::run(buildOrFail(makePendulum(u, constraints)), 2 * u.s, 10, 1e-10).results;
    };
    const Results equations = run(
        "GCON/1,I=21,FUNCTION=DX(21,10)\nGCON/2,I=21,FUNCTION=DY(21,10)\nGCON/3,I=21,FUNCTION=DZ(21,10)\n");
    const Results primitive = run("JPRIM/1,ATPOINT,I=21,J=10\n");
    expectSame(equations.parts, primitive.parts, u.m);
    expectSame(equations.requests, primitive.requests, u.m);
}

//----------------------------------------------------------------- equations that no motion changes
constexpr Formulation Formulations[] = {Formulation::Tree, Formulation::Constraints};
const std::string Guard = "GCON/1,FUNCTION=UVZ(21)*UVZ(10)-1\n";

// The guard that the manual advises for PARALLEL_AXES has no gradient where it holds: it takes nothing away. In a
// tree it is the only equation.
TEST_P(Equations, AGuardOfParallelAxesIsRedundant) {
    for (const Formulation formulation : Formulations) {
        SCOPED_TRACE(int(formulation));
        const auto run = [&](const std::string& guard) {
            const std::string text =
                makePendulum(u, "JPRIM/1,ATPOINT,I=21,J=10\nJPRIM/2,PARALLEL_AXES,I=21,J=10\n" + guard);
            return testing::run(buildOrFail(text, {formulation}), 2 * u.s, 10, 1e-10);
        };
        const SimulationOutcome with = run(Guard), without = run("");
        EXPECT_EQ(with.summary.degreesOfFreedom, 1);
        EXPECT_EQ(with.summary.redundantEquations, 1);
        EXPECT_EQ(without.summary.redundantEquations, 0);
        EXPECT_EQ(with.summary.droppedEquations.size(), formulation == Formulation::Tree ? 1 : 0);
        expectSame(with.results.parts, without.results.parts, u.m);
        EXPECT_EQ(with.results.reactions.getColumn("GCON/1.I.TX"), std::vector<double>(11, 0));
    }
}

// Positions that have to be found first, a given angle, and the search of an equilibrium.
TEST_P(Equations, AGuardDisturbsNoAssembly) {
    for (const Formulation formulation : Formulations) {
        SCOPED_TRACE(int(formulation));
        std::string text = makePendulum(u, "JOINT/1,REVOLUTE,I=21,J=10,IC=0.4\n" + Guard);
        text.replace(text.find(",WX="), 4, fmt::format(",QG={},0,0,REULER=0.1,0,0.05,WX=", 0.1 * u.m));
        const Mechanism mechanism = buildOrFail(text, {formulation});
        const AssembledState initial = assemble(mechanism);
        EXPECT_EQ(initial.moved.size(), 1u);
        EXPECT_LT(initial.after.angle, Tolerance);
        AssembledState again = reassemble(mechanism, initial.state);
        again.state = findEquilibrium(mechanism, again.state);
        SimulationOptions options;
        options.end = 0.5 * u.s;
        options.steps = 5;
        const SimulationOutcome outcome = simulate(mechanism, again, options);
        EXPECT_EQ(outcome.failure, "");
        EXPECT_NEAR(outcome.results.parts.getColumn("PART/2.VZ").back(), 0, 1e-5 * u.m);
    }
}

// Alone it keeps nothing parallel: a body that turns about another axis violates it.
TEST_P(Equations, AGuardOfNothingIsViolated) {
    const Mechanism mechanism = buildOrFail(makePendulum(u, Guard));
    SimulationOptions options;
    options.end = 1 * u.s;
    const SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    EXPECT_EQ(outcome.summary.droppedEquations, std::vector<std::string>{"GCON/1: its equation"});
    EXPECT_NE(outcome.failure.find(
                  "GCON/1: its equation, which was dropped because no motion changed it, is violated by"),
              std::string::npos)
        << outcome.failure;
    EXPECT_NE(outcome.failure.find(" rad: by itself it cannot hold what it says"), std::string::npos)
        << outcome.failure;
}

//------------------------------------------------------------------------------------------ distances
// A mass on a string that is hauled in: r(t) = 1 - t/2 on a frictionless table keeps the angular momentum.
std::string makeString(const DatasetUnits& u, double rate) {
    return fmt::format(
        "string\n{0}PART/1,GROUND\nMARKER/10\nPOINT_MASS/2,MASS=2,CM=20,QG={1},0,0,VY={2}\nMARKER/20,POINT_MASS=2\n"
        "GCON/1,I=20,FUNCTION=DM(20,10)-{1}*(1-{3}*TIME)\nREQUEST/1,F2=DM(20)\\F3=VY(20)*DX(20)-VX(20)*DY(20)\n"
        "REQUEST/2,F2=GCON(1,0,1)\nEND\n",
        u.statement, u.m, 0.8 * u.m / u.s, rate / u.s);
}

TEST_P(Equations, ADistanceMayFollowTime) {
    const Mechanism mechanism = buildOrFail(makeString(u, 0.5));
    EXPECT_FALSE(mechanism.isConservative());
    const Results results = testing::run(mechanism, 1 * u.s, 10, 1e-10).results;
    EXPECT_NEAR(results.requests.getColumn("R1.F2").back() / u.m, 0.5, Tolerance);
    EXPECT_NEAR(results.requests.getColumn("R1.F3").back() * u.s / u.m / u.m, 0.8, Tolerance);
    // m h^2/r^3 pulls.
    EXPECT_NEAR(results.requests.getColumn("R2.F2").back(), 2 * 0.64 * 8, 1e-6);
}

TEST_P(Equations, ADistanceOfZeroNamesAtpoint) {
    const std::string text = fmt::format(
        "zero\n{}PART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20\n"
        "GCON/4,FUNCTION=DM(20,10)-0\nEND\n",
        u.statement);
    const Mechanism mechanism = buildOrFail(text);
    EXPECT_EQ(
        testing::catchError([&] { assemble(mechanism); }),
        "GCON/4: the distance between markers 20 and 10 has become zero, where a single equation cannot keep "
        "it; to hold two points together use JPRIM ATPOINT");
}

// Straight in, so that it gets there: the run ends with the element, the time and the remedy.
TEST_P(Equations, ADistanceThatBecomesZeroNamesAtpoint) {
    std::string text = makeString(u, 0.5);
    text.replace(text.find(",VY="), 4, ",VX=");
    const Mechanism mechanism = buildOrFail(text);
    SimulationOptions options;
    options.end = 4 * u.s;
    options.steps = 8;
    const SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    EXPECT_EQ(outcome.results.requests.getNumRows(), 4u);
    EXPECT_NE(outcome.failure.find("GCON/1: the distance between markers 20 and 10 has become zero"),
              std::string::npos)
        << outcome.failure;
    EXPECT_NE(outcome.failure.find("use JPRIM ATPOINT"), std::string::npos) << outcome.failure;
}

}  // namespace
}  // namespace jprim
