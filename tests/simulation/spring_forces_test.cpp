// SPDX-License-Identifier: Apache-2.0
// SPRINGDAMPER and BUSHING against the oscillations that textbooks give, and what is kept where nothing acts from
// outside.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "support/dataset_units.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Vec3;
using testing::buildOrFail;
using testing::calcDeviation;
using testing::DatasetUnits;
using testing::MetreSecond;

// Of an amplitude, or of 1; the integrator's accuracy is 1e-10 over a few periods.
constexpr double Tolerance = 1e-7;

class Springs : public testing::InBothUnits {};
JPRIM_INSTANTIATE_IN_BOTH_UNITS(Springs);

/// m x" + c x' + k (x - rest) = 0, under-damped.
struct Oscillation {
    double m, c, k, rest, x0, v0;

    double operator()(double t) const {
        const double decay = c / (2 * m), frequency = std::sqrt(k / m - decay * decay), a = x0 - rest;
        return rest + std::exp(-decay * t) * (a * std::cos(frequency * t) +
                                              (v0 + decay * a) / frequency * std::sin(frequency * t));
    }
};

double calcEnergyChange(const Results& results) {
    const std::vector<double> energy = results.parts.getColumn("energy.total");
    return std::abs(energy.back() - energy.front());
}

//---------------------------------------------------------------------------------------- SPRINGDAMPER
// Two bodies fly apart from each other along an oblique line; their reduced mass oscillates on the spring.
std::string makePair(const DatasetUnits& u, double stiffness, double damping) {
    return fmt::format(
        "pair\n{0}PART/1,GROUND\nPART/2,MASS=2,CM=20,IP=1,1,1,VX={1},VY={2},VZ={3}\nMARKER/20\n"
        "PART/3,MASS=3,CM=30,IP=1,1,1,QG={4},{5},{6},VX=0,VY=0,VZ=0\nMARKER/30\n"
        "SPRINGDAMPER/1,TRANSLATIONAL,I=30,J=20,K={7},C={8},LENGTH={9},FORCE=6\n"
        "REQUEST/1,F2=DM(30,20)\\F3=SPDP(1,0,1,0)\nEND\n",
        u.statement, -2. / 3 * u.m / u.s, -1. / 3 * u.m / u.s, -2. / 3 * u.m / u.s, 0.8 * u.m, 0.4 * u.m,
        0.8 * u.m, stiffness / u.m, damping * u.s / u.m, 1.1 * u.m);
}

double calcPairDeviation(const DatasetUnits& u, const Table& table, double k, double c) {
    const Oscillation law{6. / 5, c, k, 1.1 + 6 / k, 1.2, 1};
    return calcDeviation(table.getColumn("time"), u.s, table.getColumn("R1.F2"), u.m, law);
}

TEST_P(Springs, ATranslationalOneOscillates) {
    const Mechanism mechanism = buildOrFail(makePair(u, 60, 0));
    EXPECT_TRUE(mechanism.isConservative());
    const Results results = testing::run(mechanism, 3 * u.s, 30, 1e-10).results;
    EXPECT_LE(calcPairDeviation(u, results.requests, 60, 0), Tolerance);
    EXPECT_LE(calcEnergyChange(results), Tolerance * u.m);
}

TEST_P(Springs, ATranslationalOneIsDamped) {
    const Mechanism mechanism = buildOrFail(makePair(u, 60, 2.5));
    EXPECT_FALSE(mechanism.isConservative());
    const Results results = testing::run(mechanism, 3 * u.s, 30, 1e-10).results;
    EXPECT_LE(calcPairDeviation(u, results.requests, 60, 2.5), Tolerance);
    // At the start: |-c v - k (x - l) + f|
    EXPECT_NEAR(results.requests.getColumn("R1.F3")[0], std::abs(-2.5 * 1 - 60 * 0.1 + 6), 1e-9);
    // Nothing acts from outside: the momentum stays.
    const Table& p = results.parts;
    for (const char* component : {"VX", "VY", "VZ"}) {
        const std::vector<double> a = p.getColumn(fmt::format("PART/2.{}", component)),
                                  b = p.getColumn(fmt::format("PART/3.{}", component));
        EXPECT_NEAR(2 * a.back() + 3 * b.back(), 2 * a[0] + 3 * b[0], 1e-9 * u.m / u.s);
    }
}

TEST(SpringsMutated, OnePercentMoreStiffnessIsNoticed) {
    const Results results = testing::run(buildOrFail(makePair(MetreSecond, 60.6, 0)), 3, 30, 1e-10).results;
    EXPECT_GT(calcPairDeviation(MetreSecond, results.requests, 60, 0), 1e-3);
}

// There is no line between coincident markers, so nothing acts along it.
TEST_P(Springs, CoincidentMarkersFeelNothing) {
    const std::string text = fmt::format(
        "coincident\n{}PART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=1,1,1\nMARKER/20\n"
        "SPRINGDAMPER/1,TRANSLATIONAL,I=20,J=10,K={},C={},LENGTH={}\nSFORCE/1,TRANSLATIONAL,I=20,J=10,FUNCTION=7\n"
        "REQUEST/1,F2=SPDP(1,0,1)\\F3=VR(20,10)\\F4=UV(DXYZ(20,10))*UV(DXYZ(20,10))\nEND\n",
        u.statement, 5 / u.m, 2 * u.s / u.m, 0.3 * u.m);
    const Table r = testing::run(buildOrFail(text), 1 * u.s, 1, 1e-8).results.requests;
    for (const char* name : {"R1.F2", "R1.F3", "R1.F4"}) EXPECT_EQ(r.getColumn(name).back(), 0) << name;
}

// A rotor swings by more than a turn to either side.
std::string makeRotor(const DatasetUnits& u, double damping) {
    return fmt::format(
        "rotor\n{0}PART/1,GROUND\nMARKER/10,REULER=0.3,0.4,0.5\n"
        "PART/2,MASS=1,CM=20,IP={1},{1},{1},REULER=0.3,0.4,0.5,WZ={2}\nMARKER/20\nJOINT/1,REVOLUTE,I=20,J=10\n"
        "SPRINGDAMPER/1,ROTATIONAL,I=20,J=10,KT={3},CT={4},ANGLE=30D,TORQUE={5}\n"
        "REQUEST/1,F2=AZ(20,10)\\F3=SPDP(1,0,8,10)\\F4=SPDP(1,1,8,10)\nEND\n",
        u.statement, 0.3 * u.m * u.m, 25 / u.s, 1.2 * u.m, damping * u.m * u.s, 0.7 * u.m);
}

TEST_P(Springs, ARotationalOneCountsTurns) {
    for (const double damping : {0., 0.11}) {
        const Mechanism mechanism = buildOrFail(makeRotor(u, damping));
        EXPECT_EQ(mechanism.isConservative(), damping == 0);
        const Results results = testing::run(mechanism, 6 * u.s, 60, 1e-10).results;
        const Oscillation law{0.3, damping, 1.2, SimTK::Pi / 6 + 0.7 / 1.2, 0, 25};
        const Table& r = results.requests;
        EXPECT_LE(calcDeviation(r.getColumn("time"), u.s, r.getColumn("R1.F2"), 1, law), Tolerance);
        EXPECT_GT(law(0.8), 2 * SimTK::Pi);
        EXPECT_EQ(r.getColumn("R1.F3")[7], -r.getColumn("R1.F4")[7]);
        if (damping == 0) {
            EXPECT_LE(calcEnergyChange(results), 1e-5 * u.m);
        }
    }
}

//---------------------------------------------------------------------------------------------- BUSHING
// Small enough for the angles to be those of linear theory, to 1e-4 of themselves.
constexpr double Amplitude = 1e-4;

const Vec3 K(50, 80, 110), C(1.5, 2.5, 0.5), KT(3, 5, 8), CT(0.1, 0.2, 0.3), Moments(0.5, 0.6, 0.7);

std::string makeBushing(const DatasetUnits& u, bool isDamped) {
    const auto list = [](const Vec3& v) { return fmt::format("{},{},{}", v[0], v[1], v[2]); };
    const double d = isDamped ? 1 : 0;
    return fmt::format(
        "bushing\n{}PART/1,GROUND\nMARKER/10,REULER=0.3,0.4,0.5\nMARKER/11,PART=1,REULER=0.3,0.4,0.5\n"
        "PART/2,MASS=2,CM=20,IP={},REULER=0.3,0.4,0.5,VM=11,VX={},VY={},VZ={},WX={},WY={},WZ={}\nMARKER/20\n"
        "BUSHING/1,I=20,J=10,K={},C={},KT={},CT={}\n"
        "REQUEST/1,F2=DX(20,10,10)\\F3=DY(20,10,10)\\F4=DZ(20,10,10)\\F6=AX(20,10)\\F7=AY(20,10)\\F8=AZ(20,10)\n"
        "END\n",
        u.statement, list(Moments * u.m * u.m), Amplitude * u.m / u.s, 2 * Amplitude * u.m / u.s,
        3 * Amplitude * u.m / u.s, Amplitude / u.s, 2 * Amplitude / u.s, 3 * Amplitude / u.s, list(K / u.m),
        list(d * C * u.s / u.m), list(KT * u.m), list(d * CT * u.m * u.s));
}

TEST_P(Springs, ABushingHasSixFrequencies) {
    for (const bool isDamped : {false, true}) {
        const Mechanism mechanism = buildOrFail(makeBushing(u, isDamped));
        const Table r = testing::run(mechanism, 3 * u.s, 30, 1e-10).results.requests;
        const double d = isDamped ? 1 : 0;
        for (int k = 0; k < 3; ++k) {
            const Oscillation move{2, d * C[k], K[k], 0, 0, k + 1.},
                turn{Moments[k], d * CT[k], KT[k], 0, 0, k + 1.};
            const std::vector<double> time = r.getColumn("time");
            const std::vector<double> x = r.getColumn(fmt::format("R1.F{}", k + 2)),
                                      a = r.getColumn(fmt::format("R1.F{}", k + 6));
            EXPECT_LE(calcDeviation(time, u.s, x, Amplitude * u.m, move), 1e-4) << k;
            EXPECT_LE(calcDeviation(time, u.s, a, Amplitude, turn), 1e-4) << k;
        }
    }
}

// Far from small: the load on I, and on J with the lever; two free bodies keep both momenta.
std::string makeLoosePair(const DatasetUnits& u) {
    return fmt::format(
        "loose pair\n{0}PART/1,GROUND\nPART/2,MASS=2,CM=20,IP={1},{2},{3},VX={4},WY={5}\nMARKER/20\nMARKER/21,QP={6},0,0\n"
        "PART/3,MASS=3,CM=30,IP={2},{3},{3},QG={7},{8},{6},REULER=0.2,0.3,0.1\nMARKER/30\nMARKER/31,QP=0,{6},0\n"
        "BUSHING/1,I=21,J=31,K={9},{9},{9},C={10},0,0,KT={11},{11},0,CT=0,0,{12},FORCE=3,0,-2,TORQUE=0,{11},0\n",
        u.statement, 0.5 * u.m * u.m, 0.6 * u.m * u.m, 0.7 * u.m * u.m, 1.5 * u.m / u.s, 0.8 / u.s, 0.2 * u.m,
        0.6 * u.m, -0.1 * u.m, 40 / u.m, 5 * u.s / u.m, 2 * u.m, 0.3 * u.m * u.s);
}

TEST_P(Springs, ABushingActsAndReactsWithItsLever) {
    const std::string text =
        makeLoosePair(u) +
        "REQUEST/1,F2=BUSH(1,0,2)\\F3=BUSH(1,0,3)\\F4=BUSH(1,0,4)\\F6=BUSH(1,0,6)\\F7=BUSH(1,0,7)\\F8=BUSH(1,0,8)\n"
        "REQUEST/2,F2=BUSH(1,1,2)\\F3=BUSH(1,1,3)\\F4=BUSH(1,1,4)\\F6=BUSH(1,1,6)\\F7=BUSH(1,1,7)\\F8=BUSH(1,1,8)\n"
        "REQUEST/3,F2=DX(21,31)\\F3=DY(21,31)\\F4=DZ(21,31)\n"
        "REQUEST/4,F2=BUSH(1,0,2,31)\\F3=3-40*DX(21,31,31)/" +
        fmt::format("{}", u.m) +
        fmt::format("-5*VX(21,31,31,31)*{}\\F6=BUSH(1,0,7,31)\\F7=2*{}*(1-AY(21,31))\nEND\n", u.s / u.m, u.m);
    const Results results = testing::run(buildOrFail(text), 2 * u.s, 10, 1e-10).results;
    const Table& r = results.requests;
    const auto get = [&r](int request, int first, size_t row) {
        const auto at = [&](int k) { return r.getColumn(fmt::format("R{}.F{}", request, first + k))[row]; };
        return Vec3(at(0), at(1), at(2));
    };
    for (size_t k = 0; k < r.getNumRows(); ++k) {
        const Vec3 F = get(1, 2, k), T = get(1, 6, k), lever = get(3, 2, k);
        EXPECT_LT((get(2, 2, k) + F).norm(), 1e-9);
        EXPECT_LT((get(2, 6, k) + T + lever % F).norm(), 1e-9 * u.m);
        EXPECT_GT((lever % F).norm(), 1e-3 * u.m);
        EXPECT_NEAR(r.getColumn("R4.F2")[k], r.getColumn("R4.F3")[k], 1e-9);
        EXPECT_NEAR(r.getColumn("R4.F6")[k], r.getColumn("R4.F7")[k], 1e-9 * u.m);
    }
}

// Angular momentum about the origin, from the velocities of the parts and their moments of inertia.
Vec3 calcAngularMomentum(const Table& t, size_t row, const char* part, double mass, const Vec3& moments) {
    const auto get = [&](const char* name) { return t.getColumn(std::string(part) + name)[row]; };
    const SimTK::Rotation R(SimTK::Quaternion(get(".E0"), get(".E1"), get(".E2"), get(".E3")));
    const Vec3 x(get(".X"), get(".Y"), get(".Z")), v(get(".VX"), get(".VY"), get(".VZ"));
    const Vec3 w = ~R * Vec3(get(".WX"), get(".WY"), get(".WZ"));
    return mass * x % v + R * w.elementwiseMultiply(moments);
}

TEST(Springs, ABushingKeepsMomentum) {
    const Table p =
        testing::run(buildOrFail(makeLoosePair(MetreSecond) + "END\n"), 2, 10, 1e-10).results.parts;
    const auto total = [&p](size_t row) {
        return calcAngularMomentum(p, row, "PART/2", 2, {0.5, 0.6, 0.7}) +
               calcAngularMomentum(p, row, "PART/3", 3, {0.6, 0.7, 0.7});
    };
    const auto onlyOne = [&p](size_t row) {
        return calcAngularMomentum(p, row, "PART/2", 2, {0.5, 0.6, 0.7});
    };
    EXPECT_LT((total(10) - total(0)).norm(), 1e-8);
    EXPECT_GT((onlyOne(10) - onlyOne(0)).norm(), 0.1);
}

}  // namespace
}  // namespace jprim
