// SPDX-License-Identifier: Apache-2.0
// Neither the units of a dataset nor the size of a mechanism changes its physics.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "support/bead_on_swing.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using testing::buildOrFail;
using testing::makeBeadOnSwing;

double findLargest(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

// Millimetre, kilogram, newton, second is Adams' default. Conversion to SI and back is rounding.
constexpr double UnitTolerance = 1e-9;

TEST(Units, MillimetresAndMetresGiveTheSamePhysics) {
    const Mechanism inM = buildOrFail(makeBeadOnSwing("UNITS/SYSTEM=MKS", 1, 1, 1));
    const Mechanism inMm = buildOrFail(
        makeBeadOnSwing("UNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=SECOND", 1000, 1, 1));
    const Results m = testing::run(inM, 1, 20, 1e-8).results;
    const Results mm = testing::run(inMm, 1, 20, 1e-8).results;
    const std::vector<std::string> lengths = {".X",
                                              ".Y",
                                              ".Z",
                                              ".MAG",
                                              ".VX",
                                              ".VY",
                                              ".VZ",
                                              ".VM",
                                              ".ACCX",
                                              ".ACCY",
                                              ".ACCZ",
                                              ".ACCM",
                                              ".TX",
                                              ".TY",
                                              ".TZ",
                                              ".TM",
                                              "energy.kinetic",
                                              "energy.potential",
                                              "energy.total"};
    const auto isLength = [&lengths](const std::string& name) {
        return std::any_of(lengths.begin(), lengths.end(), [&name](const std::string& end) {
            return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
        });
    };
    int compared = 0;
    for (const auto& [tableM, tableMm] :
         {std::pair(&m.requests, &mm.requests), std::pair(&m.reactions, &mm.reactions),
          std::pair(&m.parts, &mm.parts)}) {
        ASSERT_EQ(tableM->columns, tableMm->columns);
        for (const std::string& name : tableM->columns) {
            const std::vector<double> a = tableM->getColumn(name), b = tableMm->getColumn(name);
            const double factor = isLength(name) ? 1e-3 : 1;
            for (size_t row = 0; row < a.size(); ++row)
                ASSERT_NEAR(a[row], factor * b[row], UnitTolerance * (1e-3 + findLargest(a)))
                    << name << " row " << row;
            ++compared;
        }
    }
    EXPECT_GT(compared, 80);
}

// Slugs, feet and minutes, where even the time axis differs.
TEST(Units, TimeAndForceUnitsAreConverted) {
    const double ft = 1 / 0.3048, lb = 1 / 0.45359237, lbf = 1 / 4.4482216152605, minute = 1. / 60;
    const Mechanism inM = buildOrFail(makeBeadOnSwing("UNITS/SYSTEM=MKS", 1, 1, 1));
    const Mechanism inFt = buildOrFail(
        makeBeadOnSwing("UNITS/FORCE=POUND_FORCE,MASS=POUND_MASS,LENGTH=FOOT,TIME=MINUTE", ft, lb, minute));
    const Results m = testing::run(inM, 1, 10, 1e-8).results;
    const Results feet = testing::run(inFt, minute, 10, 1e-8).results;
    EXPECT_NEAR(feet.parts.getColumn("time").back(), minute, 1e-15);
    EXPECT_NEAR(feet.parts.getColumn("PART/3.X").back() / ft, m.parts.getColumn("PART/3.X").back(), 1e-9);
    EXPECT_NEAR(feet.parts.getColumn("PART/3.VX").back() / ft * minute, m.parts.getColumn("PART/3.VX").back(),
                1e-9);
    EXPECT_NEAR(feet.reactions.getColumn("JPRIM/2.I.FX").back() / lbf,
                m.reactions.getColumn("JPRIM/2.I.FX").back(), 1e-7);
    EXPECT_NEAR(feet.parts.getColumn("energy.total").back() / (ft * lbf),
                m.parts.getColumn("energy.total").back(), 1e-8);
}

// A 10 kg body held by a hinge through a massless link: the hinge carries its weight's share at every size.
std::string makeMasslessLink(double length, const std::string& more) {
    return fmt::format(
        "link\nACCGRAV/KGRAV=-9.81\nPART/1,GROUND\nMARKER/10,REULER=0D,90D,0D\n"
        "PART/2,MASS=10,CM=20,IP={0},{0},{0},QG={1},0,0\nMARKER/20\nMARKER/21,REULER=0D,90D,0D\n"
        "PART/3,CM=30\nMARKER/30,REULER=0D,90D,0D\nMARKER/31,QP={1},0,0,REULER=0D,90D,0D\n"
        "{2}JOINT/1,REVOLUTE,I=10,J=30\nJOINT/2,FIXED,I=21,J=31\nEND\n",
        10 * length * length, length, more);
}

TEST(Sizes, MasslessLinksOfAnySizeCarryLoads) {
    for (const double length : {1e-6, 1e-3, 3e-3, 0.01, 0.05, 1., 30.}) {
        SCOPED_TRACE(length);
        const Results results =
            testing::run(buildOrFail(makeMasslessLink(length, "")), 1e-4, 1, 1e-6).results;
        // I/(I + m l^2) = 1/2 of the weight, downwards on ground.
        EXPECT_NEAR(results.reactions.getColumn("JOINT/1.I.FZ").front(), -49.05, 1e-4);
    }
}

// Where Simbody's solver loses equations of a heavy part to those of a tiny one, the run must not go on.
TEST(Sizes, LostEquationsAreAFailure) {
    const std::string tiny =
        "PART/4,MASS=1E-6,CM=40,IP=1E-14,1E-14,1E-14\nMARKER/40,REULER=0D,90D,0D\n"
        "JOINT/4,REVOLUTE,I=10,J=40\n";
    const Mechanism mechanism = buildOrFail(makeMasslessLink(1, tiny), {Formulation::Constraints});
    SimulationOptions options;
    options.end = 0.1;
    const std::string failure = simulate(mechanism, assemble(mechanism), options).failure;
    EXPECT_NE(failure.find("the accelerations violate JOINT/"), std::string::npos) << failure;
    EXPECT_NE(failure.find("masses and inertias are too different to solve for"), std::string::npos)
        << failure;
    // Joint coordinates have no equations to lose.
    const Mechanism tree = buildOrFail(makeMasslessLink(1, tiny), {Formulation::Tree});
    const Results results = testing::run(tree, 1e-4, 1, 1e-6).results;
    EXPECT_NEAR(results.reactions.getColumn("JOINT/1.I.FZ").front(), -49.05, 1e-4);
}

// A pendulum of one micrometre swings as one of a metre does, a thousand times as fast.
TEST(Sizes, SizeDoesNotMatter) {
    const auto makePendulum = [](double l) {
        return buildOrFail(
            fmt::format("t\nACCGRAV/KGRAV=-9.81\nPART/1,GROUND\nMARKER/10,REULER=0D,90D,0D\n"
                        "PART/2,MASS=1,CM=20,IP={0},{0},{0}\nMARKER/20,QP={1},0,0\n"
                        "MARKER/21,REULER=0D,90D,0D\nJOINT/1,REVOLUTE,I=10,J=21\nEND\n",
                        0.1 * l * l, l));
    };
    const Results metre = testing::run(makePendulum(1), 1, 10, 1e-8).results;
    const Results micrometre = testing::run(makePendulum(1e-6), 1e-3, 10, 1e-8).results;
    for (const char* column : {"PART/2.X", "PART/2.Z"}) {
        const std::vector<double> a = metre.parts.getColumn(column), b = micrometre.parts.getColumn(column);
        for (size_t row = 0; row < a.size(); ++row) EXPECT_NEAR(a[row], 1e6 * b[row], 1e-6) << column << row;
    }
    EXPECT_NEAR(metre.reactions.getColumn("JOINT/1.I.FZ").back(),
                micrometre.reactions.getColumn("JOINT/1.I.FZ").back(), 1e-5);
}

}  // namespace
}  // namespace jprim
