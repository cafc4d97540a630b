// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_BENCHMARKS_MEASURE_H_
#define JPRIM_BENCHMARKS_MEASURE_H_

#include <ctime>

namespace jprim::benchmarks {

/// Processor time, of which other processes take nothing.
inline double getSeconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

template <class Action>
double measureSeconds(Action action) {
    const double start = getSeconds();
    action();
    return getSeconds() - start;
}

}  // namespace jprim::benchmarks

#endif
