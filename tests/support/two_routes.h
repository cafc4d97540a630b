// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_TWO_ROUTES_H_
#define JPRIM_TESTS_SUPPORT_TWO_ROUTES_H_

#include <string>

#include "jprim/results/results.h"

namespace jprim::testing {

/// The largest difference of values in the columns of `a`, which `b` must have too, relative to the largest value of
/// `a` or 1. Orientations and angles are not compared: quaternions may differ in sign, angles by a turn, and they show
/// in the motion of what hangs on a part. Infinity if `b` has no such columns or rows.
double findDifference(const Table& a, const Table& b);

/// True if a dataset's motion and reactions are its own and not those of a formulation: without redundant equations,
/// whose loads nothing but the formulation decides; not near a position where some become so, which no integration
/// could follow, nor thrown into one by given velocities that hardly fit.
bool isDetermined(const std::string& dataset);

}  // namespace jprim::testing

#endif
