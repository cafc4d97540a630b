// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_CHECK_AXES_H_
#define JPRIM_SRC_MECHANISM_CHECK_AXES_H_

#include "mechanism/given_poses.h"

namespace jprim {

/// Reports JPRIMs and JOINTs whose markers are given such that axes which the type wants equal are nearer to opposite, or
/// axes that it wants perpendicular are parallel.
void checkAxes(const Dataset& dataset, const GivenPoses& poses, Reporter& reporter);

}  // namespace jprim

#endif
