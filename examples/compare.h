// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_EXAMPLES_COMPARE_H_
#define JPRIM_EXAMPLES_COMPARE_H_

#include <algorithm>
#include <cmath>
#include <cstdio>

/// Prints a simulated number beside the exact one.
/// @returns true if they differ by no more than `tolerance`, relative to the exact number or to 1, whichever
/// is larger
inline bool compare(const char* what, double simulated, double exact, double tolerance) {
    const double difference = std::abs(simulated - exact) / std::max(std::abs(exact), 1.0);
    const bool agree = difference <= tolerance;  // false for a NaN
    std::printf("%-38s %15.9f   exact %15.9f   difference %.1e%s\n", what, simulated, exact, difference,
                agree ? "" : "   TOO LARGE");
    return agree;
}

#endif
