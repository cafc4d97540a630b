// SPDX-License-Identifier: Apache-2.0
#include "jprim/flexible/beam.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "support/expect_error.h"
#include "support/steel_beam.h"

namespace jprim {
namespace {

using testing::makeSteelBeam;

// Cubic elements converge with the fourth power of their length; 40 of them hold the fifth bending mode to
// 1e-4.
constexpr double FrequencyTolerance = 1e-4;

Eigen::MatrixXd makeDense(int size, const std::vector<MatrixTerm>& terms) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    for (const MatrixTerm& term : terms) matrix(term.row, term.column) += term.value;
    return matrix;
}

// Circular frequencies of the free-free beam, ascending, the six rigid motions left out.
std::vector<double> calcFrequencies(const FiniteElementModel& model) {
    const int n = model.getNumFreedoms();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        makeDense(n, model.stiffness), makeDense(n, model.mass), Eigen::EigenvaluesOnly);
    std::vector<double> frequencies;
    for (int i = 6; i < n; ++i) frequencies.push_back(std::sqrt(solver.eigenvalues()[i]));
    return frequencies;
}

void expectFrequency(const std::vector<double>& frequencies, double expected, double tolerance) {
    const auto nearest = std::min_element(
        frequencies.begin(), frequencies.end(),
        [expected](double a, double b) { return std::abs(a - expected) < std::abs(b - expected); });
    EXPECT_NEAR(*nearest / expected, 1, tolerance);
}

// cos(bL) cosh(bL) = 1 (Blevins, Formulas for Natural Frequency and Mode Shape, 1979, table 8-1).
const double FreeFreeRoots[] = {4.730040744862704, 7.853204624095838, 10.995607838001671, 14.137165491257464,
                                17.27875965739948};

TEST(Beam, FreeFreeFrequenciesAgreeWithClosedForms) {
    const UniformBeam beam = makeSteelBeam(40);
    const std::vector<double> frequencies = calcFrequencies(makeFiniteElementModel(beam));
    const double L = beam.length, rhoA = beam.density * beam.area;
    for (const double root : FreeFreeRoots)
        for (const double I : {beam.secondMomentY, beam.secondMomentZ})
            expectFrequency(frequencies, std::pow(root / L, 2) * std::sqrt(beam.youngsModulus * I / rhoA),
                            FrequencyTolerance);
    EXPECT_NEAR(frequencies[0],
                std::pow(FreeFreeRoots[0] / L, 2) * std::sqrt(beam.youngsModulus * beam.secondMomentY / rhoA),
                FrequencyTolerance * frequencies[0]);
}

// Linear elements converge with the second power: (n pi / elements)^2 / 24.
constexpr double LinearElementTolerance = 2e-4;

TEST(Beam, AxialAndTorsionalFrequenciesAgreeWithClosedForms) {
    const UniformBeam beam = makeSteelBeam(100);
    const std::vector<double> frequencies = calcFrequencies(makeFiniteElementModel(beam));
    const double polar = beam.secondMomentY + beam.secondMomentZ;
    for (const int n : {1, 2}) {
        const double k = n * SimTK::Pi / beam.length;
        const double axial = k * std::sqrt(beam.youngsModulus / beam.density);
        const double torsional =
            k * std::sqrt(beam.shearModulus * beam.torsionConstant / (beam.density * polar));
        for (const double expected : {axial, torsional})
            expectFrequency(frequencies, expected, LinearElementTolerance);
    }
}

// Clamped at node 1, loaded at the tip: P L^3/(3 E I) + P L/(kappa G A), exact with one element as with many,
// and the tip turns by P L^2/(2 E I); to either side with the right sign.
TEST(Beam, TipDeflectionWithAndWithoutShear) {
    for (const int elements : {1, 3})
        for (const double factor : {0., 5. / 6}) {
            UniformBeam beam = makeSteelBeam(elements);
            beam.shearFactorY = beam.shearFactorZ = factor;
            const FiniteElementModel model = makeFiniteElementModel(beam);
            const int n = model.getNumFreedoms();
            const Eigen::MatrixXd K = makeDense(n, model.stiffness).bottomRightCorner(n - 6, n - 6);
            const double L = beam.length, GA = beam.shearModulus * beam.area, P = 100;
            const double shear = factor > 0 ? P * L / (factor * GA) : 0;
            const double EIy = beam.youngsModulus * beam.secondMomentY,
                         EIz = beam.youngsModulus * beam.secondMomentZ;
            const int tip = n - 12;

            Eigen::VectorXd f = Eigen::VectorXd::Zero(n - 6);
            f[tip + 1] = P;
            Eigen::VectorXd u = K.fullPivLu().solve(f);
            EXPECT_NEAR(u[tip + 1], P * L * L * L / (3 * EIz) + shear, 1e-9 * u[tip + 1]);
            EXPECT_NEAR(u[tip + 5], P * L * L / (2 * EIz), 1e-9 * u[tip + 5]);
            f.setZero();
            f[tip + 2] = P;
            u = K.fullPivLu().solve(f);
            EXPECT_NEAR(u[tip + 2], P * L * L * L / (3 * EIy) + shear, 1e-9 * u[tip + 2]);
            EXPECT_NEAR(u[tip + 4], -P * L * L / (2 * EIy), -1e-9 * u[tip + 4]);
        }
}

TEST(Beam, RefusesImpossibleProperties) {
    const auto expectError = [](const UniformBeam& beam, const char* text) {
        EXPECT_EQ(testing::catchError([&] { makeFiniteElementModel(beam); }), text);
    };
    UniformBeam beam = makeSteelBeam(0);
    expectError(beam, "beam: number of elements is 0; it must be positive");
    beam = makeSteelBeam(2);
    beam.density = -1;
    expectError(beam, "beam: density is -1; it must be positive");
    beam = makeSteelBeam(2);
    beam.shearFactorZ = -0.5;
    expectError(beam, "beam: shearFactorZ is -0.5; it must not be negative");
    beam = makeSteelBeam(2);
    beam.youngsModulus = SimTK::Infinity;
    expectError(beam, "beam: youngsModulus is inf; it must be finite");
    beam.youngsModulus = SimTK::NaN;
    expectError(beam, "beam: youngsModulus is nan; it must be positive");
}

}  // namespace
}  // namespace jprim
