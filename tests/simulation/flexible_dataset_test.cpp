// SPDX-License-Identifier: Apache-2.0
// FLEX_BODY in a dataset, from the file of modes to the results.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/format.h"
#include "jprim/flexible/reduce_to_modes.h"
#include "support/run_dataset.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using testing::formatAll;

constexpr int Elements = 8;

// A soft beam along x from (0, 0, 0) to (2, 0, 0), its ends interfaces; the first bending at 0.3 Hz or so.
std::string writeModes() {
    static const std::string file = [] {
        UniformBeam beam = testing::makeSteelBeam(Elements);
        beam.youngsModulus /= 200;
        beam.shearModulus /= 200;
        const std::string name = ::testing::TempDir() + "jprim_soft_beam.modes";
        saveModalBasis(
            reduceToModes(makeFiniteElementModel(beam), {{{1}, 0, {}}, {{Elements + 1}, 0, {}}}, 2), name);
        return name;
    }();
    return file;
}

// A beam held at its start by a FIXED at (0.3, 0.2, 0.1), with a ball at its end, in any unit of
// length.
std::string makeDataset(const std::string& units, double L, const std::string& damping) {
    const auto point = [L](double x, double y, double z) {
        return fmt::format("{},{},{}", x * L, y * L, z * L);
    };
    return "beam and ball\n" + units + fmt::format("\nACCGRAV/KGRAV={}\n", -0.05 * L) +
           "PART/1,GROUND\nMARKER/10,QP=" + point(0.3, 0.2, 0.1) + "\nFLEX_BODY/1,MODES_FILE='" +
           writeModes() + "',QG=" + point(0.3, 0.2, 0.1) + damping +
           "\nMARKER/20,NODE_ID=1\nMARKER/21,NODE_ID=9,QP=" + point(2, 0, -0.1) +
           "\nPART/2,MASS=0.5,CM=30,QG=" + point(2.3, 0.2, 0) +
           fmt::format(",IP={0},{0},{0}\nMARKER/30\nMARKER/31", 0.01 * L * L) +
           "\nJOINT/1,FIXED,I=20,J=10\nJPRIM/2,ATPOINT,I=31,J=21\n"
           "REQUEST/1,DISPLACEMENT,I=21,J=10\nREQUEST/2,FORCE,I=20,J=10\nEND\n";
}

const std::string Metres = "UNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=METER,TIME=SECOND";
const std::string Millimetres = "UNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=SECOND";

// Damped out, the root carries both weights and their moments, m g L/2 + M g L, and the end hangs by
// rho A g L^4/(8 E I) + M g L^3/(3 E I).
TEST(FlexibleDataset, ComesToRestWhereBeamTheorySays) {
    constexpr double Tolerance = 5e-3;  // the end is down by 1 % of the length
    const Mechanism mechanism = testing::buildOrFail(makeDataset(Metres, 1, ",CRATIO=1"));
    const SimulationOutcome outcome = testing::run(mechanism, 40, 4, 1e-8);
    const double g = 0.05, length = 2, mass = 7850 * 6e-4 * length, ball = 0.5, EI = 2.1e11 / 200 * 2e-8;
    const double down = (mass * g / 8 + ball * g / 3) * std::pow(length, 3) / EI;
    EXPECT_NEAR(outcome.results.requests.getColumn("R1.Z").back(), -down - 0.1, Tolerance * down);
    EXPECT_NEAR(outcome.results.requests.getColumn("R2.FZ").back(), (mass + ball) * g, Tolerance * mass * g);
    EXPECT_NEAR(outcome.results.reactions.getColumn("JOINT/1.I.TY").back(), -(mass / 2 + ball) * g * length,
                Tolerance * mass * g * length);
    EXPECT_FALSE(mechanism.isConservative());
    EXPECT_LT(outcome.summary.largestImbalance, 1e-4 * outcome.summary.energyScale);
}

TEST(FlexibleDataset, KeepsItsEnergyWithoutDamping) {
    const Mechanism mechanism =
        testing::buildOrFail(makeDataset(Metres, 1, ",CRATIO=0,INVARIANTS=T:T:F:F:F:T:T:F:F"));
    const SimulationOutcome outcome = testing::run(mechanism, 1, 50, 1e-8);
    EXPECT_TRUE(mechanism.isConservative());
    EXPECT_LT(outcome.summary.largestEnergyChange, 1e-6 * outcome.summary.energyScale);
    EXPECT_EQ(outcome.summary.degreesOfFreedom, 8 + 12 - 6 - 3);
}

// Metres or millimetres: the same numbers times a thousand, modal coordinates too.
TEST(FlexibleDataset, UnitsDoNotMatter) {
    const auto simulate = [](const std::string& units, double L) {
        return testing::run(testing::buildOrFail(makeDataset(units, L, "")), 0.5, 5, 1e-9).results;
    };
    const Results m = simulate(Metres, 1), mm = simulate(Millimetres, 1000);
    for (const char* column :
         {"FLEX_BODY/1.X", "FLEX_BODY/1.Z", "FLEX_BODY/1.Q1", "FLEX_BODY/1.Q8", "PART/2.Z"}) {
        const double a = m.parts.getColumn(column).back(), b = mm.parts.getColumn(column).back();
        EXPECT_NEAR(b / 1000, a, 1e-6) << column;
    }
    EXPECT_GT(std::abs(m.parts.getColumn("FLEX_BODY/1.Q1").back()), 1e-4);
    EXPECT_NEAR(m.parts.getColumn("FLEX_BODY/1.X").front(), 1.3, 1e-9);
}

// Given positions that do not fit are met by moving the body, not by bending it.
TEST(FlexibleDataset, AssemblesUndeformed) {
    std::string text = makeDataset(Metres, 1, ",VZ=0.1");
    text.replace(text.find("MARKER/10,QP=0.3,"), 17, "MARKER/10,QP=0.4,");
    const Mechanism mechanism = testing::buildOrFail(text);
    const AssembledState assembled = assemble(mechanism);
    const FlexibleBody& body = *mechanism.getParts()[2].flexible;
    EXPECT_LT(assembled.after.length, 1e-9);
    EXPECT_EQ(body.getModalCoordinates(assembled.state).normInf(), 0);
    EXPECT_LT(body.getModalVelocities(assembled.state).normInf(), 1e-12);
    ASSERT_EQ(assembled.moved.size(), 2u);
    EXPECT_EQ(assembled.moved[1].part, "FLEX_BODY/1");
    EXPECT_NEAR(assembled.moved[1].distance, 0.1, 1e-6);
}

// A MOTION bends the beam at its end by d, against 3 E I d/L^3. Adams would not have its marker there.
TEST(FlexibleDataset, AMotionMayBendABeam) {
    const Mechanism mechanism = testing::buildOrFail(
        "bend\nPART/1,GROUND\nMARKER/10\nFLEX_BODY/1,MODES_FILE='" + writeModes() +
        "',CRATIO=1\nMARKER/20,NODE_ID=1\nMARKER/21,NODE_ID=9,QP=2,0,0\nJOINT/1,FIXED,I=20,J=10\n"
        "MOTION/1,I=21,J=10,Z,FUNCTION=STEP(TIME,0,0,1,-0.02)\n"
        "REQUEST/1,F2=DZ(21,10)\\F3=MOTION(1,0,4)\\F4=JOINT(1,0,7)\nEND\n");
    const Table r = testing::run(mechanism, 20, 4, 1e-6).results.requests;
    const double EI = 2.1e11 / 200 * 2e-8, force = 3 * EI * 0.02 / 8;
    EXPECT_NEAR(r.getColumn("R1.F2").back(), -0.02, 1e-6);
    EXPECT_NEAR(r.getColumn("R1.F3").back(), -force, 5e-3 * force);  // the beam yields to shear as well
    EXPECT_NEAR(r.getColumn("R1.F4").back(), -2 * force, 5e-3 * 2 * force);
}

TEST(FlexibleDataset, NamesWhatIsMissing) {
    const auto build = [](const std::string& text) {
        Diagnostics diagnostics;
        EXPECT_FALSE(testing::buildFromText(text, diagnostics));
        return formatAll(diagnostics);
    };
    EXPECT_EQ(build("t\nPART/1,GROUND\nFLEX_BODY/1,MODES_FILE=none.modes\nEND\n"),
              "3:1: error: FLEX_BODY/1: none.modes: cannot be opened\n");
    EXPECT_EQ(
        build("t\nPART/1,GROUND\nFLEX_BODY/1,MODES_FILE='" + writeModes() + "'\nMARKER/3,NODE_ID=77\nEND\n"),
        "4:1: error: MARKER/3: beam: has no node 77\n");
}

}  // namespace
}  // namespace jprim
