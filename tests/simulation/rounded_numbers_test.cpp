// SPDX-License-Identifier: Apache-2.0
// Doubled hinges on slanted axes: driven, and with numbers that a dataset gives to some digits only, so that something
// is left of equations that say the same twice.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "jprim/marker/angles.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Rotation;
using SimTK::Vec3;

// A lid on an axis through the origin along z of a frame given by 3-1-3 angles, and 1.3 m along it a second hinge whose
// place in ground is given with `digits` decimals.
std::string writeLid(int digits, const std::string& rest) {
    const Vec3 second = Rotation(makeRotation313(Vec3(0.4, 0.7, 0.3))) * Vec3(0, 0, 1.3);
    return fmt::format(
               "lid\nPART/1,GROUND\nMARKER/1,REULER=0.4,0.7,0.3\n"
               "MARKER/2,QP={1:.{0}f},{2:.{0}f},{3:.{0}f},REULER=0.4,0.7,0.3\n"
               "PART/2,MASS=10,CM=20,IP=1,2,3,REULER=0.4,0.7,0.3\nMARKER/20,QP=0.3,-0.2,0.5\nMARKER/21\n"
               "MARKER/22,QP=0,0,1.3\nJOINT/1,REVOLUTE,I=21,J=1\nJOINT/2,REVOLUTE,I=22,J=2\n"
               "REQUEST/1,F2=AZ(21,1)\n",
               digits, second[0], second[1], second[2]) +
           rest + "END\n";
}

struct Row {
    int digits;
    Formulation formulation;
    Redundancy redundancy;
};

class RoundedNumbers : public ::testing::TestWithParam<Row> {
protected:
    double runTo(const std::string& text) const {
        const Mechanism mechanism = testing::buildOrFail(text, {GetParam().formulation});
        SimulationOptions options;
        options.end = 0.4;
        options.steps = 4;
        options.accuracy = 1e-8;
        options.redundancy = GetParam().redundancy;
        const SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
        EXPECT_EQ(outcome.failure, "");
        return outcome.results.requests.getColumn("R1.F2").back();
    }
};

TEST_P(RoundedNumbers, ADrivenLidTurnsAsItIsDriven) {
    EXPECT_NEAR(runTo(writeLid(GetParam().digits, "MOTION/1,JOINT=1,FUNCTION=TIME\n")), 0.4, 1e-7);
}

TEST_P(RoundedNumbers, ALidFallsAsOnOneHinge) {
    std::string single = writeLid(16, "ACCGRAV/JGRAV=-9.81\n");
    single.erase(single.find("JOINT/2"), single.find("REQUEST") - single.find("JOINT/2"));
    const double rounded = std::pow(0.1, GetParam().digits);
    EXPECT_NEAR(runTo(writeLid(GetParam().digits, "ACCGRAV/JGRAV=-9.81\n")), runTo(single), 1e-7 + rounded);
}

INSTANTIATE_TEST_SUITE_P(
    Lids, RoundedNumbers,
    ::testing::Values(
        Row{16, Formulation::Tree, Redundancy::Share}, Row{16, Formulation::Tree, Redundancy::Drop},
        Row{16, Formulation::Constraints, Redundancy::Share}, Row{12, Formulation::Tree, Redundancy::Share},
        Row{11, Formulation::Tree, Redundancy::Share}, Row{11, Formulation::Tree, Redundancy::Drop},
        Row{10, Formulation::Tree, Redundancy::Share}, Row{10, Formulation::Tree, Redundancy::Drop},
        Row{10, Formulation::Constraints, Redundancy::Share}, Row{8, Formulation::Tree, Redundancy::Share},
        Row{8, Formulation::Constraints, Redundancy::Share}, Row{6, Formulation::Tree, Redundancy::Share},
        Row{6, Formulation::Constraints, Redundancy::Drop}, Row{5, Formulation::Tree, Redundancy::Drop},
        Row{5, Formulation::Constraints, Redundancy::Share}));

AssembledState assembleFile(const std::string& name, Formulation formulation) {
    return assemble(testing::buildFileOrFail(testing::getDataFolder() + "assembly/" + name, {formulation}));
}

// What is kept of the equations is met in another place too, where a hinge stands 187 mm open.
TEST(RoundedLoops, CloseWhereAllEquationsAreMetBest) {
    constexpr double Rounded = 1e-6;  // m, of sizes of a metre
    for (const Formulation formulation : {Formulation::Tree, Formulation::Constraints}) {
        const AssembledState assembled = assembleFile("doubled_rockers.adm", formulation);
        EXPECT_FALSE(assembled.leftOut.empty());
        EXPECT_LT(assembled.after.length, Rounded);
    }
}

// Next to nothing is left of the equations where it is drawn, but they can be met.
TEST(RoundedLoops, AreNoneNextToADeadPoint) {
    constexpr double Met = 1e-9;
    for (const Formulation formulation : {Formulation::Tree, Formulation::Constraints}) {
        const AssembledState assembled = assembleFile("short_truss.adm", formulation);
        EXPECT_TRUE(assembled.leftOut.empty());
        EXPECT_LT(assembled.after.length, Met);
    }
}

}  // namespace
}  // namespace jprim
