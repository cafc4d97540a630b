// SPDX-License-Identifier: Apache-2.0
// Parts whose moments of inertia no body has: the motion is what the given numbers say.
#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "jprim/marker/angles.h"
#include "support/random_part.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Mat33;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::Vec3;
using testing::buildFromText;
using testing::buildOrFail;
using testing::formatAll;
using testing::makeInertia;
using testing::RandomPart;

// Above the integrator's accuracy over a few turns, below what any other inertia would give.
constexpr double Accuracy = 1e-11, Tolerance = 1e-8;
constexpr Formulation Both[] = {Formulation::Tree, Formulation::Constraints};

std::string format(const Vec3& v) {
    return fmt::format("{},{},{}", v[0], v[1], v[2]);
}

//------------------------------------------------------------------------------------------- hinges
// A torque of 2.1 N m about a fixed axis through the mass centre: angle = 2.1/(2 I) t^2.
struct HingedPart {
    std::string ip;
    double moment;  // about z
    std::string oddity;
};

std::string makeHinge(const std::string& ip) {
    return "hinge\nPART/1,GROUND\nMARKER/1\nPART/2,MASS=1,CM=20,IP=" + ip +
           "\nMARKER/20\nJOINT/1,REVOLUTE,I=20,J=1\nSFORCE/1,ROTATIONAL,I=20,J=1,FUNCTION=2.1\n"
           "REQUEST/1,F2=AZ(20,1)\\F3=TZ(20,1)\nEND\n";
}

class HingedParts : public ::testing::TestWithParam<HingedPart> {};

TEST_P(HingedParts, TurnByTheirMomentAboutTheAxis) {
    const HingedPart& part = GetParam();
    for (const Formulation formulation : Both) {
        Diagnostics diagnostics;
        const std::optional<Mechanism> mechanism =
            buildFromText(makeHinge(part.ip), diagnostics, {formulation});
        ASSERT_TRUE(mechanism);
        EXPECT_EQ(formatAll(diagnostics), "4:1: warning: PART/2 " + part.oddity + "\n");
        const SimulationOutcome outcome = testing::run(*mechanism, 1, 4, Accuracy);
        EXPECT_NEAR(outcome.results.requests.getColumn("R1.F2").back(), 2.1 / (2 * part.moment), Tolerance);
        EXPECT_EQ(outcome.summary.degreesOfFreedom, 1);
        EXPECT_EQ(outcome.summary.redundantEquations, 0);
        EXPECT_LE(outcome.summary.largestImbalance, Tolerance);
        const double rate = 2.1 / part.moment;  // at the end
        EXPECT_NEAR(outcome.results.parts.getColumn("energy.kinetic").back(), part.moment * rate * rate / 2,
                    Tolerance);
    }
}

std::string describe(const std::string& largest, const std::string& others, const std::string& excess) {
    return "has a principal moment of inertia about the mass centre (" + largest +
           ") that is larger than the sum of the other two (" + others + ") by " + excess +
           ", which no body has; it is used as given";
}
const std::string Vanishes =
    "has no inertia about some axis; a little is used so that the equations can be solved";
const std::string Negative =
    ", which no body has; it is used as given, for no motion that the constraints allow makes its sign felt";

INSTANTIATE_TEST_SUITE_P(
    , HingedParts,
    ::testing::Values(
        HingedPart{"1,1,2.1", 2.1, describe("2.1", "2", "0.1")},
        HingedPart{"5,5,10.00001", 10.00001, describe("10.00001", "10", "1e-05")},
        HingedPart{"1.2346,4.5679,5.8026", 5.8026, describe("5.8026", "5.8025", "0.0001")},
        HingedPart{"5.8026,4.5679,1.2346", 1.2346, describe("5.8026", "5.8025", "0.0001")},
        HingedPart{"1E-3,1E-3,4.8E4", 4.8e4, describe("48000", "0.002", "48000")},
        HingedPart{"0,3,6", 6, Vanishes + "; it " + describe("6", "3.0000006", "3")},
        HingedPart{"0,0,5", 5, Vanishes + "; it " + describe("5", "1e-06", "5")},
        HingedPart{"-3,-7,2", 2,
                   "has a negative principal moment of inertia about the mass centre (-7)" + Negative},
        HingedPart{"0,-7,2", 2,
                   Vanishes + "; it has a negative principal moment of inertia about the mass centre (-7)" +
                       Negative}));

TEST(HingedPartsMutant, OneMillionthMoreInertiaIsNoticed) {
    const SimulationOutcome outcome = testing::run(buildOrFail(makeHinge("1,1,2.1000021")), 1, 4, Accuracy);
    EXPECT_GT(std::abs(outcome.results.requests.getColumn("R1.F2").back() - 0.5), 10 * Tolerance);
}

// Any axis, with products of inertia, IM away from CM and turned: the moment about the axis n through P is
// n.I n + m |n x (C - P)|^2, I that about C.
/// MARKER/20 at the mass centre, MARKER/21 for the inertia; IP about its origin and axes.
std::string writeInertia(Real mass, const Mat33& central, const Vec3& center, const SimTK::Transform& X_BI) {
    const Vec3 c = ~X_BI.R() * (center - X_BI.p());
    const Mat33 I = Mat33(~X_BI.R()) * central * Mat33(X_BI.R()) +
                    mass * (SimTK::dot(c, c) * Mat33(1) - SimTK::outer(c, c));
    return fmt::format("PART/2,MASS={},CM=20,IM=21,IP={},{},{},{},{},{}", mass, I(0, 0), I(1, 1), I(2, 2),
                       -I(0, 1), -I(0, 2), -I(1, 2));
}

std::string writeMarker(int id, int part, const SimTK::Transform& X) {
    return fmt::format("MARKER/{},PART={},QP={},REULER={}\n", id, part, format(X.p()),
                       format(calcAngles313(X.R())));
}

TEST(BrokenInertia, HingesAboutAnyAxis) {
    for (unsigned seed = 1; seed <= 25; ++seed) {
        RandomPart r(seed);
        const Real mass = r.drawOverDecades(0.01, 100), torque = r.draw(-1, 1);
        const Vec3 center = r.drawVec3();
        const Rotation R_GB = r.drawRotation();
        const Mat33 central = makeInertia(r.drawMoments(), r.drawRotation());
        const SimTK::Transform X_BI(r.drawRotation(), r.drawVec3()), X_BJ(r.drawRotation(), r.drawVec3());
        const std::string text =
            "t\nPART/1,GROUND\n" + writeMarker(10, 1, SimTK::Transform(R_GB) * X_BJ) +
            writeInertia(mass, central, center, X_BI) + ",REULER=" + format(calcAngles313(R_GB)) + "\n" +
            writeMarker(20, 2, center) + writeMarker(21, 2, X_BI) + writeMarker(22, 2, X_BJ) +
            fmt::format(
                "JOINT/1,REVOLUTE,I=22,J=10\nSFORCE/1,ROTATIONAL,I=22,J=10,FUNCTION={}\n"
                "REQUEST/1,F2=AZ(22,10)\nEND\n",
                torque);
        const Vec3 n(X_BJ.R().z());
        const Real moment = SimTK::dot(n, central * n) + mass * SimTK::cross(n, center - X_BJ.p()).normSqr();
        for (const Formulation formulation : Both) {
            const Real end = std::sqrt(moment / std::abs(torque));  // half a radian
            const SimulationOutcome outcome =
                testing::run(buildOrFail(text, {formulation}), end, 2, Accuracy);
            EXPECT_NEAR(outcome.results.requests.getColumn("R1.F2").back(), std::copysign(0.5, torque),
                        10 * Tolerance)
                << seed;
        }
    }
}

//---------------------------------------------------------------------------------------- free bodies
// I1 = I2: the angular velocity turns about the third axis at (I3 - I1)/I1 w3. (Euler's equations, any textbook.)
TEST(BrokenInertia, AFreeTopTurnsAsEulerSays) {
    for (const Formulation formulation : Both) {
        const SimulationOutcome outcome = testing::run(
            buildOrFail("top\nPART/1,GROUND\nPART/2,MASS=1,CM=20,IP=1,1,2.1,WX=1,WZ=2\n"
                        "MARKER/20\nREQUEST/1,F2=WX(20,0,20)\\F3=WY(20,0,20)\\F4=WZ(20,0,20)\nEND\n",
                        {formulation}),
            5, 50, 1e-12);
        const Table& table = outcome.results.requests;
        for (size_t k = 0; k < table.getNumRows(); ++k) {
            const double t = table.getColumn("time")[k];
            EXPECT_NEAR(table.getColumn("R1.F2")[k], std::cos(2.2 * t), Tolerance);
            EXPECT_NEAR(table.getColumn("R1.F3")[k], std::sin(2.2 * t), Tolerance);
            EXPECT_NEAR(table.getColumn("R1.F4")[k], 2, Tolerance);
        }
    }
}

// I dw/dt = -w x I w in principal axes, by the classical method of Runge and Kutta.
Vec3 integrateEuler(const Vec3& I, Vec3 w, Real end) {
    const auto derivative = [&I](const Vec3& w) {
        const Vec3 moment = -SimTK::cross(w, I.elementwiseMultiply(w));
        return Vec3(moment[0] / I[0], moment[1] / I[1], moment[2] / I[2]);
    };
    constexpr int Steps = 20000;
    const Real h = end / Steps;
    for (int k = 0; k < Steps; ++k) {
        const Vec3 a = derivative(w), b = derivative(w + h / 2 * a), c = derivative(w + h / 2 * b),
                   d = derivative(w + h * c);
        w += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return w;
}

TEST(BrokenInertia, FreeBodiesOfAnyPositiveMomentsTurnAsEulerSays) {
    for (unsigned seed = 1; seed <= 25; ++seed) {
        RandomPart r(seed);
        const Real mass = r.drawOverDecades(0.01, 100);
        const Vec3 moments = r.drawMoments(), center = r.drawVec3(), w = 2 * r.drawVec3();
        const Rotation R_BC = r.drawRotation();  // principal axes, which are those of MARKER/20
        const SimTK::Transform X_BI(r.drawRotation(), r.drawVec3());
        const std::string text =
            "t\nPART/1,GROUND\n" + writeInertia(mass, makeInertia(moments, R_BC), center, X_BI) +
            fmt::format(",QG=1,2,3,REULER=0.1,1.2,0.3,VX=1,VY=-2,WX={},WY={},WZ={}\n", w[0], w[1], w[2]) +
            writeMarker(20, 2, SimTK::Transform(R_BC, center)) + writeMarker(21, 2, X_BI) +
            "REQUEST/1,F2=WX(20,0,20)\\F3=WY(20,0,20)\\F4=WZ(20,0,20)\\F5=DX(20)\\F6=DY(20)\nEND\n";
        const Mechanism mechanism = buildOrFail(text);
        const AssembledState start = assemble(mechanism);
        const double end = 1 / (1 + std::max({moments[0], moments[1], moments[2]}) /
                                        std::min({moments[0], moments[1], moments[2]}) / 20);
        const SimulationOutcome outcome = testing::run(mechanism, end, 1, Accuracy);
        const Vec3 expected = integrateEuler(moments, w, end);
        const Table& table = outcome.results.requests;
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(table.getColumn(fmt::format("R1.F{}", k + 2)).back(), expected[k], Tolerance) << seed;
        const std::vector<double> x = table.getColumn("R1.F5"), y = table.getColumn("R1.F6");
        EXPECT_NEAR(x.back() - x.front(), end, Tolerance) << seed;
        EXPECT_NEAR(y.back() - y.front(), -2 * end, Tolerance) << seed;
        const auto calcMomentum = [&](const SimTK::State& state) {
            mechanism.getSystem().realize(state, SimTK::Stage::Velocity);
            return mechanism.getMatter().calcSystemCentralMomentum(state)[0];
        };
        EXPECT_LT((calcMomentum(outcome.finalState) - calcMomentum(start.state)).norm(), 100 * Tolerance)
            << seed;
    }
}

}  // namespace
}  // namespace jprim
