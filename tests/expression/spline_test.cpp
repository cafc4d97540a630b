// SPDX-License-Identifier: Apache-2.0
// Splines against curves that they must reproduce, published slopes, and differences.
#include "jprim/expression/spline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_error.h"

namespace jprim::testing {
namespace {

using SimTK::Real;
using Reals = std::vector<Real>;
using Method = InterpolatingSpline::Method;

const Reals X{-1, 0, 0.5, 2, 3.5, 4};
const Reals Y{2, 1.5, 3, -1, 0.3, 0.7};
const Reals Y2{0, 1, -2, 0.4, 2, 1};

constexpr Real RoundingTolerance = 1e-13;

Reals tabulate(Real (*f)(Real), const Reals& x) {
    Reals y;
    for (const Real v : x) y.push_back(f(v));
    return y;
}

TEST(Spline, PassesThroughItsPoints) {
    const InterpolatingSpline spline("SPLINE/1", X, Y);
    for (const Method method : {Method::Akima, Method::Cubic})
        for (std::size_t i = 0; i < X.size(); ++i)
            EXPECT_NEAR(spline.calcDerivative(method, X[i], 0, 0), Y[i], RoundingTolerance);
}

TEST(Spline, ReproducesAStraightLineEverywhere) {
    const InterpolatingSpline spline("SPLINE/1", X, tabulate([](Real x) { return 3 - 2 * x; }, X));
    for (const Method method : {Method::Akima, Method::Cubic})
        for (const Real x : {-7.0, -0.3, 0.2, 1.9, 3.7, 9.0}) {
            EXPECT_NEAR(spline.calcDerivative(method, x, 0, 0), 3 - 2 * x, RoundingTolerance);
            EXPECT_NEAR(spline.calcDerivative(method, x, 0, 1), -2, RoundingTolerance);
            EXPECT_NEAR(spline.calcDerivative(method, x, 0, 2), 0, RoundingTolerance);
        }
}

// With equal widths Akima's mean of neighbouring chords is a parabola's slope, also at the ends.
TEST(Spline, AkimaReproducesAParabolaOnEqualWidths) {
    const Reals x{1, 1.5, 2, 2.5, 3, 3.5};
    const InterpolatingSpline spline("SPLINE/1", x, tabulate([](Real v) { return v * v - 3 * v; }, x));
    for (const Real v : {1.1, 1.5, 2.2, 3.45}) {
        EXPECT_NEAR(spline.calcDerivative(Method::Akima, v, 0, 0), v * v - 3 * v, RoundingTolerance);
        EXPECT_NEAR(spline.calcDerivative(Method::Akima, v, 0, 1), 2 * v - 3, RoundingTolerance);
        EXPECT_NEAR(spline.calcDerivative(Method::Akima, v, 0, 2), 2, 10 * RoundingTolerance);
    }
}

// Chords 0 0 1 3 1: at x = 2 the weights |3 - 1| and |0 - 0| choose the left chord, at x = 3 they are
// |1 - 3| = 2 and |1 - 0| = 1, so that the slope is (2*1 + 1*3)/3.
TEST(Spline, AkimaWeighsChordsAsPublished) {
    const InterpolatingSpline spline("SPLINE/1", {0, 1, 2, 3, 4, 5}, {0, 0, 0, 1, 4, 5});
    EXPECT_NEAR(spline.calcDerivative(Method::Akima, 2, 0, 1), 0, RoundingTolerance);
    EXPECT_NEAR(spline.calcDerivative(Method::Akima, 3, 0, 1), 5.0 / 3, RoundingTolerance);
    // The straight part stays straight: that is what the method is for.
    EXPECT_NEAR(spline.calcDerivative(Method::Akima, 1.4, 0, 0), 0, RoundingTolerance);
    EXPECT_GT(std::abs(spline.calcDerivative(Method::Cubic, 1.4, 0, 0)), 0.01);
}

// With unit widths M[i-1] + 4 M[i] + M[i+1] = 6 (y[i-1] - 2 y[i] + y[i+1]) for the second derivatives M: here
// 4 M1 + M2 = -12 and M1 + 4 M2 = 12.
TEST(Spline, CubicAgreesWithAHandSolution) {
    const InterpolatingSpline spline("SPLINE/1", {0, 1, 2, 3}, {0, 1, 0, 1});
    EXPECT_NEAR(spline.calcDerivative(Method::Cubic, 1, 0, 2), -4, RoundingTolerance);
    EXPECT_NEAR(spline.calcDerivative(Method::Cubic, 2, 0, 2), 4, RoundingTolerance);
    EXPECT_NEAR(spline.calcDerivative(Method::Cubic, 0, 0, 2), 0, RoundingTolerance);
    EXPECT_NEAR(spline.calcDerivative(Method::Cubic, 0, 0, 1), 1 + 4.0 / 6, RoundingTolerance);
    EXPECT_NEAR(spline.calcDerivative(Method::Cubic, 1.5, 0, 0), 0.5, RoundingTolerance);
}

TEST(Spline, CurvesAreAsSmoothAsPromised) {
    const InterpolatingSpline spline("SPLINE/1", X, Y);
    constexpr Real gap = 1e-10, tolerance = 1e-7;  // of y'' up to 100 across the gap
    for (std::size_t i = 1; i + 1 < X.size(); ++i)
        for (const auto& [method, order] :
             {std::pair(Method::Akima, 0), std::pair(Method::Akima, 1), std::pair(Method::Cubic, 0),
              std::pair(Method::Cubic, 1), std::pair(Method::Cubic, 2)})
            EXPECT_NEAR(spline.calcDerivative(method, X[i] - gap, 0, order),
                        spline.calcDerivative(method, X[i] + gap, 0, order), tolerance);
    // Akima's curvature jumps, so that the check above can fail.
    EXPECT_GT(std::abs(spline.calcDerivative(Method::Akima, 2 - gap, 0, 2) -
                       spline.calcDerivative(Method::Akima, 2 + gap, 0, 2)),
              0.1);
}

TEST(Spline, DerivativesAreThoseOfTheCurve) {
    const InterpolatingSpline spline("SPLINE/1", X, {1, 3}, {Y, Y2});
    constexpr Real h = 1e-4, tolerance = 1e-7;  // central differences of a cubic: h^2 y'''/6
    for (const Method method : {Method::Akima, Method::Cubic})
        for (const Real x : {-3.0, -0.4, 1.1, 3.7, 5.0})
            for (const Real z : {0.2, 1.4, 3.3})
                for (int order = 0; order <= 3; ++order) {
                    const auto along = [&](Real dx, Real dz) {
                        return spline.calcDerivative(method, x + dx, z + dz, order);
                    };
                    EXPECT_NEAR(spline.calcDerivative(method, x, z, order + 1),
                                (along(h, 0) - along(-h, 0)) / (2 * h), tolerance);
                    EXPECT_NEAR(spline.calcSlopeInZ(method, x, z, order),
                                (along(0, h) - along(0, -h)) / (2 * h), tolerance);
                }
}

TEST(Spline, FamiliesAreInterpolatedInZ) {
    const InterpolatingSpline family("SPLINE/1", X, {1, 3}, {Y, Y2});
    const InterpolatingSpline one("SPLINE/1", X, Y), two("SPLINE/1", X, Y2);
    const auto value = [](const InterpolatingSpline& spline, Real z) {
        return spline.calcDerivative(Method::Akima, 1.1, z, 0);
    };
    EXPECT_EQ(value(family, 1), value(one, 0));
    EXPECT_EQ(value(family, -5), value(one, 0));
    EXPECT_EQ(value(family, 3), value(two, 0));
    EXPECT_EQ(value(family, 9), value(two, 0));
    EXPECT_NEAR(value(family, 1.5), 0.75 * value(one, 0) + 0.25 * value(two, 0), RoundingTolerance);
    EXPECT_EQ(one.calcSlopeInZ(Method::Akima, 1.1, 0, 0), 0);
}

TEST(Spline, BeyondItsEndsItGoesOnStraight) {
    const InterpolatingSpline spline("SPLINE/1", X, Y);
    for (const Method method : {Method::Akima, Method::Cubic}) {
        const Real first = spline.calcDerivative(method, -1, 0, 1),
                   last = spline.calcDerivative(method, 4, 0, 1);
        EXPECT_NEAR(spline.calcDerivative(method, -3, 0, 0), 2 - 2 * first, RoundingTolerance);
        EXPECT_NEAR(spline.calcDerivative(method, 6, 0, 0), 0.7 + 2 * last, RoundingTolerance);
        EXPECT_EQ(spline.calcDerivative(method, 6, 0, 1), last);
        EXPECT_EQ(spline.calcDerivative(method, 6, 0, 2), 0);
    }
    EXPECT_TRUE(std::isnan(spline.calcDerivative(Method::Akima, std::nan(""), 0, 0)));
}

TEST(Spline, BadDataAreRefused) {
    const auto makeCurve = [](Reals x, Reals y) {
        return catchError([&] { InterpolatingSpline("SPLINE/7", x, y); });
    };
    const auto makeFamily = [](Reals z, std::vector<Reals> y) {
        return catchError([&] { InterpolatingSpline("SPLINE/7", X, z, y); });
    };
    EXPECT_EQ(makeCurve({1, 2, 3}, {1, 2, 3}), "SPLINE/7: a spline needs at least 4 points, not 3");
    EXPECT_EQ(makeCurve({1, 2, 2, 3}, {1, 2, 3, 4}),
              "SPLINE/7: the values of X must increase, but 2 follows 2");
    EXPECT_EQ(makeCurve({1, 3, 2.5, 4}, {1, 2, 3, 4}),
              "SPLINE/7: the values of X must increase, but 2.5 follows 3");
    EXPECT_EQ(makeCurve({1, 2, 3, SimTK::Infinity}, {1, 2, 3, 4}),
              "SPLINE/7: value 4 of X is not a finite number");
    EXPECT_EQ(makeCurve({1, 2, 3, 4}, {1, 2, 3}), "SPLINE/7: 4 values of X need as many of Y, not 3");
    EXPECT_EQ(makeCurve({1, 2, 3, 4}, {1, SimTK::NaN, 3, 4}),
              "SPLINE/7: a value of Y is not a finite number");
    EXPECT_EQ(makeFamily({1, 2}, {Y}), "SPLINE/7: 2 values of Z need as many curves Y, not 1");
    EXPECT_EQ(makeFamily({}, {}), "SPLINE/7: 0 values of Z need as many curves Y, not 0");
    EXPECT_EQ(makeFamily({2, 1}, {Y, Y2}), "SPLINE/7: the values of Z must increase, but 1 follows 2");
}

}  // namespace
}  // namespace jprim::testing
