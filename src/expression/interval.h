// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_EXPRESSION_INTERVAL_H_
#define JPRIM_SRC_EXPRESSION_INTERVAL_H_

#include "expression/functions.h"

namespace jprim {

/// All numbers from low to high: where a value must be, if its arguments are anywhere in theirs. Ends are not rounded
/// outwards; of single numbers they are the value to the last digit. What is not known to be bounded is everything.
struct Interval {
    SimTK::Real low = -SimTK::Infinity;
    SimTK::Real high = SimTK::Infinity;

    bool isBounded() const;
    bool contains(SimTK::Real x) const { return low <= x && x <= high; }
};

Interval operator+(const Interval& a, const Interval& b);
Interval operator-(const Interval& a, const Interval& b);
Interval operator-(const Interval& a);
Interval operator*(const Interval& a, const Interval& b);
Interval operator/(const Interval& a, const Interval& b);
/// The smallest interval that holds both.
Interval unite(const Interval& a, const Interval& b);
/// Where f(x, y) must be.
Interval calcRange(Function function, const Interval& x, const Interval& y);

}  // namespace jprim

#endif
