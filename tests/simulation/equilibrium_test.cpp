// SPDX-License-Identifier: Apache-2.0
// Static equilibria against closed forms.
#include "jprim/simulation/equilibrium.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/format.h"
#include "support/expect_error.h"
#include "support/run_dataset.h"

namespace jprim {
namespace {

using SimTK::Real;
using SimTK::State;
using SimTK::Vec3;

constexpr double Exact = 1e-8;  // of balanced forces, EquilibriumTolerance of those at the start

State findFrom(const Mechanism& mechanism) {
    return findEquilibrium(mechanism, assemble(mechanism).state);
}

// A bent lever on a hinge with a torsional spring: kt a = m g (x cos a - y sin a), solved by Newton's method.
TEST(Equilibrium, ALeverOnATorsionalSpring) {
    const Mechanism mechanism = testing::buildOrFail(
        "lever\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2,WZ=3\n"
        "MARKER/20,QP=0.5,0.1,0\nMARKER/21\nJOINT/1,REVOLUTE,I=21,J=10\n"
        "SPRINGDAMPER/1,ROTATIONAL,I=21,J=10,KT=30,CT=2\nREQUEST/1,F2=AZ(21,10)\nEND\n");
    Real a = 0;
    for (int k = 0; k < 20; ++k) {
        const Real moment = 30 * a + 2 * 9.81 * (0.5 * std::cos(a) - 0.1 * std::sin(a));
        a -= moment / (30 + 2 * 9.81 * (-0.5 * std::sin(a) - 0.1 * std::cos(a)));
    }
    const State state = findFrom(mechanism);
    EXPECT_NEAR(mechanism.getRequests()[0].functions[0].second.calcValue(state), a, Exact);
    EXPECT_EQ(state.getU().norm(), 0);
    EXPECT_LT(state.getUDot().normInf(), Exact);
}

// Two links that are given nearly upright, where they could balance too, come to hang straight down.
TEST(Equilibrium, ADoublePendulumHangsDown) {
    const Mechanism mechanism = testing::buildOrFail(
        "links\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=1,CM=20,IP=0.1,0.1,0.1\n"
        "MARKER/20,QP=0.001,0.3,0\nMARKER/21\nMARKER/22,QP=0.002,0.6,0\n"
        "PART/3,MASS=1.5,CM=30,IP=0.1,0.1,0.1\nMARKER/30,QP=0,0.8,0\nMARKER/31,QP=0.002,0.6,0\n"
        "JOINT/1,REVOLUTE,I=21,J=10\nJOINT/2,REVOLUTE,I=31,J=22\nEND\n");
    const State state = findFrom(mechanism);
    const Vec3 elbow = mechanism.getMarker(22).findPoseInGround(state).p();
    const Vec3 center = mechanism.getMarker(30).findPoseInGround(state).p();
    EXPECT_NEAR(elbow[0], 0, Exact);
    EXPECT_NEAR(elbow[1], -std::hypot(0.002, 0.6), Exact);
    EXPECT_NEAR(center[0], 0, Exact);
    EXPECT_NEAR(center[1], elbow[1] - std::hypot(0.002, 0.2), Exact);
}

// Thin rods hang by balls, free to spin about themselves and given in any direction: all come to hang straight down,
// however little resists a spin.
TEST(Equilibrium, AChainOfRodsThatMaySpinHangsDown) {
    for (const Formulation formulation : {Formulation::Tree, Formulation::Constraints})
        for (const double slender : {0.1, 1e-6}) {
            std::string text = "chain\nACCGRAV/IGRAV=3,JGRAV=-9,KGRAV=2\nPART/1,GROUND\nMARKER/3,PART=1\n";
            Vec3 top(0);
            double length = 0;
            for (int k = 1; k <= 4; ++k) {
                const double L = 0.3 + 0.1 * k, mass = 2.7 / k, moment = mass * L * L / 12;
                const SimTK::Rotation R(SimTK::BodyRotationSequence, 0.9 * k, SimTK::ZAxis, 0.4 + 0.3 * k,
                                        SimTK::XAxis, 0.7, SimTK::ZAxis);
                text += fmt::format(
                    "PART/{0}0,MASS={1},IP={2},{3},{3},CM={0}1,QG={4},{5},{6},REULER={7},{8},0.7\n", k, mass,
                    slender * moment, moment, top[0], top[1], top[2], 0.9 * k, 0.4 + 0.3 * k);
                text +=
                    fmt::format("MARKER/{0}1,QP={1},0,0\nMARKER/{0}2\nMARKER/{0}3,QP={2},0,0\n", k, L / 2, L);
                text +=
                    fmt::format("JPRIM/{},ATPOINT,I={}2,J={}3\n", k, k, k == 1 ? "" : std::to_string(k - 1));
                top += R * Vec3(L, 0, 0);
                length += L;
            }
            const Mechanism mechanism = testing::buildOrFail(text + "END\n", {formulation});
            const State state = findFrom(mechanism);
            const Vec3 end = mechanism.getMarker(43).findPoseInGround(state).p();
            EXPECT_LT((end - length * Vec3(3, -9, 2).normalize()).norm(), length * Exact)
                << int(formulation) << slender;
        }
}

// A body on a bushing sags by m g/k; in millimetres and milliseconds the number is 1000 times as large.
TEST(Equilibrium, UnitsDoNotMatter) {
    const auto findSag = [](const char* units, double L, double T) {
        const double F = L / (T * T);  // 1 kg m/s^2
        const Mechanism mechanism = testing::buildOrFail(fmt::format(
            "sag\n{}\nACCGRAV/KGRAV={}\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP={},{},{}\n"
            "MARKER/20\nBUSHING/1,I=20,J=10,K={},{},{},KT={},{},{},FORCE=0,0,{}\nEND\n",
            units, -9.81 * L / (T * T), 0.1 * L * L, 0.2 * L * L, 0.3 * L * L, 300 * F / L, 400 * F / L,
            500 * F / L, 30 * F * L, 40 * F * L, 50 * F * L, 3 * F));
        const State state = findFrom(mechanism);
        return mechanism.getMarker(20).findPoseInGround(state).p()[2] / mechanism.getUnits().length;
    };
    const double expected = (3 - 2 * 9.81) / 500;
    EXPECT_NEAR(findSag("UNITS/SYSTEM=MKS", 1, 1), expected, Exact);
    const double inMillimetres =
        findSag("UNITS/SYSTEM=NONE,UCF=1", 1000, 1000);  // force 1 kg mm/ms^2 = 1000 N: every unit consistent
    EXPECT_NEAR(inMillimetres, 1000 * expected, 1000 * Exact);
}

TEST(Equilibrium, AMotionKeepsItsPresentPosition) {
    const Mechanism mechanism = testing::buildOrFail(
        "driven\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\n"
        "MARKER/20,QP=0.5,0,0\nMARKER/21\nMARKER/22,QP=1,0,0\nPART/3,MASS=1,CM=30,IP=0.1,0.1,0.2\n"
        "MARKER/30,QP=1.4,0,0\nMARKER/31,QP=1,0,0\nJOINT/1,REVOLUTE,I=21,J=10\nJOINT/2,REVOLUTE,I=31,J=22\n"
        "MOTION/1,JOINT=1,FUNCTION=0.3+0.7*TIME**2+TIME\nEND\n");
    const State state = findFrom(mechanism);
    const Vec3 elbow = mechanism.getMarker(22).findPoseInGround(state).p();
    EXPECT_NEAR(std::atan2(elbow[1], elbow[0]), 0.3, Exact);
    const Vec3 hanging = mechanism.getMarker(30).findPoseInGround(state).p() - elbow;
    EXPECT_NEAR(hanging[0], 0, Exact);
    EXPECT_NEAR(hanging[1], -0.4, Exact);
}

TEST(Equilibrium, SaysWhatStillMovesIfThereIsNone) {
    const Mechanism mechanism = testing::buildOrFail(
        "fall\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\nMARKER/20\nEND\n");
    EXPECT_EQ(testing::catchError([&] { findFrom(mechanism); }),
              "equilibrium: none was found from here; PART/2 still moves");
}

}  // namespace
}  // namespace jprim
