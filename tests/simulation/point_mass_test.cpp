// SPDX-License-Identifier: Apache-2.0
// A POINT_MASS moves as Kepler and Huygens say.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "support/dataset_units.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using testing::buildOrFail;
using testing::calcDeviation;
using testing::DatasetUnits;
using testing::MetreSecond;

constexpr double Tolerance = 1e-7;  // over a period, at an accuracy of 1e-10

class PointMasses : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(PointMasses);

//--------------------------------------------------------------------------------------- the ellipse
// An orbit of semi-axis a and eccentricity e about the origin under the force -k/r^2, from its farthest point.
constexpr double k = 5, Mass = 2, SemiAxis = 0.8, Eccentricity = 0.4;

double calcPeriod() {
    return 2 * SimTK::Pi * std::sqrt(SemiAxis * SemiAxis * SemiAxis * Mass / k);
}

Table runOrbit(const DatasetUnits& u, double strength, double seconds) {
    const double far = SemiAxis * (1 + Eccentricity);
    const double speed = std::sqrt(k / Mass * (2 / far - 1 / SemiAxis));
    const std::string text = fmt::format(
        "orbit\n{}PART/1,GROUND\nMARKER/10\nPOINT_MASS/2,MASS={},CM=20,QG={},0,0,REULER=0.3,0.4,0.5,VZ={}\nMARKER/20\n"
        "SFORCE/1,TRANSLATIONAL,I=20,J=10,FUNCTION=-{}/DM(20,10)**2\nREQUEST/1,F2=DX(20)\\F3=DY(20)\\F4=DZ(20)\nEND\n",
        u.statement, Mass, far * u.m, speed * u.m / u.s, strength * u.m * u.m);
    return testing::run(buildOrFail(text), seconds * u.s, 2, 1e-10).results.requests;
}

TEST_P(PointMasses, OrbitsOnAnEllipse) {
    const Table r = runOrbit(u, k, calcPeriod());
    EXPECT_NEAR(r.getColumn("R1.F2")[1] / u.m, -SemiAxis * (1 - Eccentricity), Tolerance);  // half way
    EXPECT_NEAR(r.getColumn("R1.F4")[1] / u.m, 0, 10 * Tolerance);
    EXPECT_NEAR(r.getColumn("R1.F2")[2] / u.m, SemiAxis * (1 + Eccentricity), Tolerance);  // round
    EXPECT_NEAR(r.getColumn("R1.F4")[2] / u.m, 0, 10 * Tolerance);
    EXPECT_NEAR(r.getColumn("R1.F3")[2] / u.m, 0, Tolerance);
}

TEST(PointMassesMutated, AnotherStrengthIsNoticed) {
    EXPECT_GT(std::abs(runOrbit(MetreSecond, 1.001 * k, calcPeriod()).getColumn("R1.F4")[2]),
              1000 * Tolerance);
}

//------------------------------------------------------------------------------- the conical pendulum
// On a string of 0.5 m at 0.7 rad from the vertical: rate^2 = g/(l cos a), tension m g/cos a. The mass centre lies
// off the body's frame, which does not turn.
TEST_P(PointMasses, SwingsOnACone) {
    constexpr double g = 9.8, l = 0.5, a = 0.7;
    const double rate = std::sqrt(g / (l * std::cos(a))), radius = l * std::sin(a), height = l * std::cos(a);
    const std::string text =
        fmt::format("cone\n{0}ACCGRAV/KGRAV={1}\nPART/1,GROUND\nMARKER/10,QP=0,0,{2}\n", u.statement,
                    -g * u.m / u.s / u.s, height * u.m) +
        fmt::format(
            "POINT_MASS/3,MASS={0},CM=30,QG={1},{2},0,VY={3}\nMARKER/30,QP=0,{4},0\n"
            "GCON/1,I=30,FUNCTION=DM(30,10)-{5}\nREQUEST/1,F2=DX(30)\\F3=DY(30)\\F4=GCON(1,0,1)\nEND\n",
            Mass, radius * u.m, -0.2 * u.m, radius * rate * u.m / u.s, 0.2 * u.m, l * u.m);
    const Mechanism mechanism = buildOrFail(text);
    EXPECT_TRUE(mechanism.isConservative());
    const SimulationOutcome outcome = testing::run(mechanism, 3 * u.s, 30, 1e-10);
    EXPECT_EQ(outcome.summary.degreesOfFreedom, 2);
    const Table& r = outcome.results.requests;
    const std::vector<double> time = r.getColumn("time");
    const auto x = [=](double t) { return radius * std::cos(rate * t); };
    const auto y = [=](double t) { return radius * std::sin(rate * t); };
    const auto tension = [=](double) { return Mass * g / std::cos(a); };
    EXPECT_LE(calcDeviation(time, u.s, r.getColumn("R1.F2"), u.m, x), Tolerance);
    EXPECT_LE(calcDeviation(time, u.s, r.getColumn("R1.F3"), u.m, y), Tolerance);
    EXPECT_LE(calcDeviation(time, u.s, r.getColumn("R1.F4"), 1, tension), Tolerance);
}

}  // namespace
}  // namespace jprim
