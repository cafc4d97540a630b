// SPDX-License-Identifier: Apache-2.0
// Modes of datasets, by a tree and by constraints, against closed forms.
#include "jprim/simulation/linear_modes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/format.h"
#include "jprim/flexible/reduce_to_modes.h"
#include "support/dataset_units.h"
#include "support/expect_error.h"
#include "support/modes_of.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using Complex = std::complex<double>;
using testing::DatasetUnits;
using testing::Eigenvalues;
using testing::expectEigenvalues;
using testing::findModes;

constexpr double ByDifferences = 1e-8;  // of an eigenvalue, relative

class Modes : public ::testing::TestWithParam<Formulation> {
protected:
    LinearModes find(const std::string& dataset) const { return findModes(dataset, GetParam()); }
};

std::string getFormulationName(const ::testing::TestParamInfo<Formulation>& info) {
    return info.param == Formulation::Tree ? "Tree" : "Constraints";
}
INSTANTIATE_TEST_SUITE_P(, Modes, ::testing::Values(Formulation::Tree, Formulation::Constraints),
                         getFormulationName);

// Imaginary eigenvalues of M x'' + K x = 0 with two coordinates: w^2 of det(K - w^2 M) = 0.
Eigenvalues solveTwo(double m11, double m12, double m22, double k11, double k12, double k21, double k22) {
    const double a = m11 * m22 - m12 * m12, b = m12 * (k12 + k21) - m11 * k22 - m22 * k11,
                 c = k11 * k22 - k12 * k21;
    const Complex root = std::sqrt(Complex(b * b - 4 * a * c));
    Eigenvalues values;
    for (const Complex square : {(-b + root) / (2 * a), (-b - root) / (2 * a)}) {
        const Complex value = std::sqrt(-square);
        values.push_back(value.imag() > 0 ? value : -value);
        if (std::abs(square.imag()) > 0) values.push_back(-std::conj(values.back()));
    }
    if (values.size() == 4) values.resize(2);
    return values;
}

//--------------------------------------------------------------------------------------- pendulums
constexpr double m1 = 2, m2 = 1.3, a1 = 0.4, l1 = 0.7, a2 = 0.3, J1 = 0.05, J2 = 0.03, g = 9.81;

std::string makeDoublePendulum(const DatasetUnits& u, const std::string& more = "") {
    const double L = u.m, J = u.m * u.m;
    return fmt::format(
        "double pendulum\n{0}ACCGRAV/JGRAV={1}\nPART/1,GROUND\nMARKER/10\n"
        "PART/2,MASS={2},CM=20,IP={3},{3},{3}\nMARKER/20,QP=0,{4},0\nMARKER/21\nMARKER/22,QP=0,{5},0\n"
        "PART/3,MASS={6},CM=30,IP={7},{7},{7}\nMARKER/30,QP=0,{8},0\nMARKER/31,QP=0,{5},0\n"
        "JOINT/1,REVOLUTE,I=21,J=10\nJOINT/2,REVOLUTE,I=31,J=22\n{9}END\n",
        u.statement, -g * L / (u.s * u.s), m1, J1 * J, -a1 * L, -l1 * L, m2, J2 * J, -(l1 + a2) * L, more);
}

Eigenvalues getDoublePendulum() {
    return solveTwo(J1 + m1 * a1 * a1 + m2 * l1 * l1, m2 * l1 * a2, J2 + m2 * a2 * a2,
                    (m1 * a1 + m2 * l1) * g, 0, 0, m2 * a2 * g);
}

TEST_P(Modes, OfADoublePendulumInAnyUnits) {
    for (const DatasetUnits& u : {testing::MetreSecond, testing::MillimetreMillisecond}) {
        const LinearModes modes = find(makeDoublePendulum(u));
        expectEigenvalues(modes.modes, getDoublePendulum(), ByDifferences);
        EXPECT_EQ(modes.numStates, 4);
        EXPECT_EQ(modes.numZero, 0);
        EXPECT_LT(modes.relativeError, 1e-8);
        EXPECT_EQ(modes.acceleratedPart, "");
        EXPECT_FALSE(modes.isMoving);
        EXPECT_NEAR(modes.modes[0].getDampingRatio(), 0, 1e-8);
        EXPECT_FALSE(modes.modes[0].isUnstable());
    }
}

TEST_P(Modes, OfHingesThatAreThereTwiceAreThoseOfOne) {
    const LinearModes modes = find(makeDoublePendulum(
        testing::MetreSecond,
        "JOINT/3,REVOLUTE,I=21,J=10\nJOINT/4,REVOLUTE,I=31,J=22\nJPRIM/5,INPLANE,I=31,J=22\n"));
    expectEigenvalues(modes.modes, getDoublePendulum(), ByDifferences);
    EXPECT_EQ(modes.numStates, 4);
}

// In the slow mode of angles (1, r): translations at the mass centres across gravity, turns about z; the largest is 1.
TEST_P(Modes, HaveShapes) {
    const LinearModes modes = find(makeDoublePendulum(testing::MetreSecond));
    const double square = std::norm(modes.modes[0].eigenvalue);
    const double r = ((m1 * a1 + m2 * l1) * g / square - (J1 + m1 * a1 * a1 + m2 * l1 * l1)) / (m2 * l1 * a2);
    const std::vector<PartShape>& shape = modes.modes[0].shape;
    ASSERT_EQ(shape.size(), 2u);
    EXPECT_EQ(shape[1].part, "PART/3");
    EXPECT_LT(std::abs(shape[1].translation[0] - 1.), 1e-9);
    EXPECT_EQ(modes.modes[0].largestPart, "PART/3");
    const double angle = 1 / (l1 + a2 * r);
    EXPECT_LT(std::abs(shape[0].translation[0] - a1 * angle), 1e-7);
    EXPECT_LT(std::abs(shape[0].rotation[2] - angle), 1e-7);
    EXPECT_LT(std::abs(shape[1].rotation[2] - r * angle), 1e-7);
    EXPECT_LT(std::abs(shape[1].rotation[0]), 1e-9);
    EXPECT_LT(std::abs(shape[1].translation[1]), 1e-9);
}

// Gravity gives the parts' kinetic energy, of which the rest follows; there is no spring.
TEST_P(Modes, SayIfTheStateIsNoEquilibrium) {
    std::string tilted = makeDoublePendulum(testing::MillimetreMillisecond);
    tilted.replace(tilted.find("JGRAV"), 5, "IGRAV");
    const LinearModes modes = find(tilted);
    EXPECT_EQ(modes.acceleratedPart, "PART/3");
    EXPECT_GT(modes.acceleration, 0.5 * g * 1e-3);  // mm/ms^2
    EXPECT_LT(modes.acceleration, 5 * g * 1e-3);
}

//----------------------------------------------------------------------------------------- closed loops
// A parallelogram of two cranks and a coupler that does not turn, held at an angle by a preloaded torsion spring:
//     M = 2 (J + m a^2) + mc l^2,    K = KT - g (2 m a + mc l) sin theta
TEST_P(Modes, OfAFourBarLinkage) {
    constexpr double m = 1.5, mc = 2.2, a = 0.2, l = 0.45, J = 0.04, KT = 30, base = 0.8, theta = 0.9;
    const double x = std::cos(theta), y = std::sin(theta), load = g * (2 * m * a + mc * l);
    const LinearModes modes = find(fmt::format(
        "four-bar\nACCGRAV/JGRAV={0}\nPART/1,GROUND\nMARKER/10\nMARKER/11,QP={1},0,0\n"
        "PART/2,MASS={2},CM=20,IP={3},{3},{3}\nMARKER/20,QP={4},{5},0\nMARKER/21\nMARKER/22,QP={6},{7},0\n"
        "PART/3,MASS={2},CM=30,IP={3},{3},{3},QG={1},0,0\nMARKER/30,QP={4},{5},0\nMARKER/31\nMARKER/32,QP={6},{7},0\n"
        "PART/4,MASS={8},CM=40,IP=1,1,1,QG={6},{7},0\nMARKER/40,QP=0.3,0,0\nMARKER/41\nMARKER/42,QP={1},0,0\n"
        "JOINT/1,REVOLUTE,I=21,J=10\nJOINT/2,REVOLUTE,I=31,J=11\nJOINT/3,REVOLUTE,I=41,J=22\n"
        "JOINT/4,REVOLUTE,I=42,J=32\nSPRINGDAMPER/1,ROTATIONAL,I=21,J=10,KT={9},TORQUE={10}\nEND\n",
        -g, base, m, J, a * x, a * y, l * x, l * y, mc, KT, load * x));
    const double mass = 2 * (J + m * a * a) + mc * l * l;
    EXPECT_EQ(modes.acceleratedPart, "");
    expectEigenvalues(modes.modes, {Complex(0, std::sqrt((KT - load * y) / mass))}, ByDifferences);
}

//------------------------------------------------------------------------------------ spinning rotors
// A rotor in a housing that springs hold at two places b to both sides of its centre. With J of both across the axis, Jp
// of the rotor along it and k of each spring, tilting: J phi'' - i Jp W phi' + 2 k b^2 phi = 0, phi = phi_x + i phi_y.
struct Rotor {
    double m = 3, Jp = 0.05, Jt = 0.03, mHousing = 1, J = 0.02, k = 4000, along = 2500, b = 0.25, W = 120;

    std::string write(const std::string& spin) const {
        return fmt::format(
            "rotor\nPART/1,GROUND\nMARKER/10,QP=0,0,{0}\nMARKER/11,QP=0,0,{1}\n"
            "PART/2,MASS={2},CM=20,IP={3},{3},{3}\nMARKER/20\nMARKER/21,QP=0,0,{0}\nMARKER/22,QP=0,0,{1}\n"
            "PART/3,MASS={4},CM=30,IP={5},{5},{6},WZ={7}\nMARKER/30\nJOINT/1,REVOLUTE,I=30,J=20\n"
            "BUSHING/1,I=21,J=10,K={8},{8},{9},KT=0,0,7\nBUSHING/2,I=22,J=11,K={8},{8},{9}\n{10}END\n",
            b, -b, mHousing, J, m, Jt, Jp, W, k, along, spin);
    }
    Eigenvalues getWhirl() const {
        const double mass = m + mHousing, across = Jt + J, gyro = Jp * W / 2;
        const double root = std::sqrt(gyro * gyro + across * 2 * k * b * b);
        const Complex i(0, 1), shift = i * std::sqrt(2 * k / mass);
        return {shift, shift, i * std::sqrt(2 * along / mass), i * (gyro + root) / across,
                i * (root - gyro) / across};
    }
};

TEST_P(Modes, OfASpinningRotorWhirlForwardAndBackward) {
    const Rotor rotor;
    for (const bool isDriven : {false, true}) {
        const LinearModes modes = find(rotor.write(
            isDriven ? fmt::format("MOTION/1,JOINT=1,ROTATION,FUNCTION={}*TIME\n", rotor.W) : ""));
        Eigenvalues expected = rotor.getWhirl();
        const double twist = isDriven ? rotor.J + rotor.Jp : rotor.J;
        expected.emplace_back(0, std::sqrt(7 / twist));
        expectEigenvalues(modes.modes, expected, ByDifferences);
        EXPECT_EQ(modes.numZero, isDriven ? 0 : 2);
        EXPECT_TRUE(modes.isMoving);
        EXPECT_EQ(modes.acceleratedPart, "");
        for (const LinearMode& mode : modes.modes) EXPECT_FALSE(mode.isUnstable());
    }
}

//----------------------------------------------------------------------------------- a follower force
// Ziegler's double pendulum: masses 2 m and m at the ends of two bars, torsion springs c in both hinges, and a force P that
// stays along the second bar. Source: H. Ziegler, Die Stabilitaetskriterien der Elastomechanik, Ing.-Arch. 20 (1952).
std::string makeZiegler(double P, double m, double l, double c, double J) {
    return fmt::format(
        "Ziegler\nPART/1,GROUND\nMARKER/10\nPART/2,MASS={0},CM=20,IP={1},{1},{1}\nMARKER/20,QP={2},0,0\nMARKER/21\n"
        "PART/3,MASS={3},CM=30,IP={1},{1},{1}\nMARKER/30,QP={4},0,0\nMARKER/31,QP={2},0,0\n"
        "MARKER/32,QP={4},0,0,REULER=90D,-90D,0\nJOINT/1,REVOLUTE,I=21,J=10\nJOINT/2,REVOLUTE,I=31,J=20\n"
        "SPRINGDAMPER/1,ROTATIONAL,I=21,J=10,KT={5}\nSPRINGDAMPER/2,ROTATIONAL,I=31,J=20,KT={5}\n"
        "SFORCE/1,TRANSLATIONAL,ACTIONONLY,I=30,J=32,FUNCTION={6}\nEND\n",
        2 * m, J, l, m, 2 * l, c, P);
}

TEST_P(Modes, FlutterAboveTheCriticalLoad) {
    constexpr double m = 0.8, l = 0.6, c = 5, J = 1e-6;
    const double critical = (3.5 - std::sqrt(2)) * c / l;
    for (const double share : {0.5, 0.99, 1.01, 1.5}) {
        const double P = share * critical;
        const LinearModes modes = find(makeZiegler(P, m, l, c, J));
        const Eigenvalues expected =
            solveTwo(3 * m * l * l + J, m * l * l, m * l * l + J, 2 * c - P * l, P * l - c, -c, c);
        expectEigenvalues(modes.modes, expected, 10 * ByDifferences);  // the values are near each other
        const auto isUnstable = [](const LinearMode& mode) { return mode.isUnstable(); };
        EXPECT_EQ(std::count_if(modes.modes.begin(), modes.modes.end(), isUnstable), share > 1 ? 1 : 0)
            << share;
    }
}

// Masses and inertias that Simbody cannot solve for together.
TEST(ModesByConstraints, LoseNoEquationUnseen) {
    EXPECT_EQ(
        testing::catchError([] { findModes(makeZiegler(1, 0.8, 0.6, 5, 1e-12), Formulation::Constraints); }),
        "linearize: accelerations nearby violate JOINT/1 REVOLUTE: masses and inertias are too different to solve "
        "for");
}

//------------------------------------------------------------------------------------------ flexible
TEST_P(Modes, OfAClampedBeam) {
    const UniformBeam beam = testing::makeSteelBeam(20);
    const std::string file = ::testing::TempDir() + "jprim_clamped_beam.modes";
    saveModalBasis(reduceToModes(makeFiniteElementModel(beam), {{{1}, 0, {}}}, 4), file);
    const LinearModes modes = find("beam\nPART/1,GROUND\nMARKER/10\nFLEX_BODY/1,MODES_FILE='" + file +
                                   "',CRATIO=0.02\nMARKER/20,NODE_ID=1\nJOINT/1,FIXED,I=20,J=10\nEND\n");
    std::filesystem::remove(file);
    const double mass = beam.density * beam.area * std::pow(beam.length, 4);
    const auto calcFrequency = [&](double root, double I) {
        return root * root * std::sqrt(beam.youngsModulus * I / mass) / (2 * SimTK::Pi);
    };
    const double Roots[] = {1.8751040687, 4.6940911330};
    std::vector<double> expected;
    for (const double root : Roots)
        for (const double I : {beam.secondMomentY, beam.secondMomentZ})
            expected.push_back(calcFrequency(root, I));
    constexpr double OfBeamTheory = 1e-3;
    ASSERT_EQ(modes.modes.size(), 4u);
    EXPECT_EQ(modes.numZero, 0);
    for (size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(modes.modes[k].getFrequency() / expected[k], 1, OfBeamTheory);
        EXPECT_GT(modes.modes[k].getDampingRatio(), 0);
        EXPECT_LT(modes.modes[k].getDampingRatio(), 0.02);  // that of the free beam's modes
        ASSERT_EQ(modes.modes[k].shares.size(), 1u);
        EXPECT_NEAR(modes.modes[k].shares[0].strain, 1, 1e-12);
        EXPECT_NEAR(modes.modes[k].shares[0].kinetic, 1, 1e-12);
        EXPECT_NEAR(modes.modes[k].shares[0].dissipated, 1, 1e-12);
    }
}

//------------------------------------------------------------------------------------------ energies
// Two masses on a line, each on a spring to ground's side: of the first mode (1, r) shares m x^2, k dx^2 and c dx^2.
TEST_P(Modes, ShareTheirEnergies) {
    constexpr double ma = 2, mb = 3, ka = 500, kb = 900;
    const LinearModes modes = find(fmt::format(
        "two\nPART/1,GROUND\nMARKER/10,REULER=90D,90D,0\nPART/2,MASS={0},CM=20,IP=1,1,1,QG=1,0,0\n"
        "MARKER/20,REULER=90D,90D,0\nPART/3,MASS={1},CM=30,IP=1,1,1,QG=2,0,0\nMARKER/30,REULER=90D,90D,0\n"
        "JOINT/1,TRANSLATIONAL,I=20,J=10\nJOINT/2,TRANSLATIONAL,I=30,J=10\n"
        "SPRINGDAMPER/1,TRANSLATIONAL,I=20,J=10,K={2},C=0.001,LENGTH=1\n"
        "SPRINGDAMPER/2,TRANSLATIONAL,I=30,J=20,K={3},C=0.004,LENGTH=1\nEND\n",
        ma, mb, ka, kb));
    ASSERT_EQ(modes.modes.size(), 2u);
    for (const LinearMode& mode : modes.modes) {
        const double r = (ka + kb - ma * std::norm(mode.eigenvalue)) / kb, d = (r - 1) * (r - 1);
        ASSERT_EQ(mode.shares.size(), 4u);
        EXPECT_EQ(mode.shares[3].element, "SPRINGDAMPER/2");
        EXPECT_NEAR(mode.shares[0].kinetic, ma / (ma + mb * r * r), 1e-5);
        EXPECT_NEAR(mode.shares[1].kinetic, mb * r * r / (ma + mb * r * r), 1e-5);
        EXPECT_NEAR(mode.shares[2].strain, ka / (ka + kb * d), 1e-5);
        EXPECT_NEAR(mode.shares[3].strain, kb * d / (ka + kb * d), 1e-5);
        EXPECT_NEAR(mode.shares[3].dissipated, 4 * d / (1 + 4 * d), 1e-5);
        EXPECT_EQ(mode.shares[3].kinetic, 0);
    }
}

}  // namespace
}  // namespace jprim
