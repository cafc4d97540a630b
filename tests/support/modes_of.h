// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_MODES_OF_H_
#define JPRIM_TESTS_SUPPORT_MODES_OF_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <vector>

#include "jprim/simulation/linear_modes.h"
#include "support/run_dataset.h"

namespace jprim::testing {

using Eigenvalues = std::vector<std::complex<double>>;

/// Of a dataset about its assembled State.
inline LinearModes findModes(const std::string& dataset, Formulation formulation) {
    const Mechanism mechanism = buildOrFail(dataset, {formulation});
    return calcLinearModes(mechanism, assemble(mechanism).state);
}

/// Each expected value, of a pair the one with positive imaginary part, is there once, to a relative tolerance, and within
/// ten times the error that is stated for it.
template <class Modes>
void expectEigenvalues(const Modes& modes, Eigenvalues expected, double tolerance) {
    constexpr double Margin = 10, Rounding = 1e-13;
    for (const auto& mode : modes) {
        if (mode.isZero) continue;
        ASSERT_FALSE(expected.empty()) << mode.eigenvalue << " is not expected";
        const auto nearest =
            std::min_element(expected.begin(), expected.end(), [&](const auto& a, const auto& b) {
                return std::abs(a - mode.eigenvalue) < std::abs(b - mode.eigenvalue);
            });
        const double wrong = std::abs(*nearest - mode.eigenvalue), size = std::abs(*nearest);
        EXPECT_LT(wrong, tolerance * size) << mode.eigenvalue;
        if (tolerance < 1e-6) {
            EXPECT_LT(wrong, Margin * mode.error + Rounding * size) << mode.eigenvalue;
        }
        expected.erase(nearest);
    }
    EXPECT_TRUE(expected.empty()) << expected.size() << " are missing, one is " << expected.front();
}

}  // namespace jprim::testing

#endif
