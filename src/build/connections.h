// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BUILD_CONNECTIONS_H_
#define JPRIM_SRC_BUILD_CONNECTIONS_H_

#include <string>

#include "jprim/dataset/dataset.h"
#include "jprim/joint/joint.h"

namespace jprim {

/// The one place where the dataset's types meet the library's joints.
Joint makeConnection(JprimType type, const Marker& I, const Marker& J, const std::string& name);
Joint makeConnection(JointType type, const Marker& I, const Marker& J, const std::string& name);

/// What is wrong with the given orientations of markers i and j: axes that the type wants equal are nearer to
/// opposite, or axes that it wants perpendicular are parallel. Empty if nothing is.
std::string findMisalignment(JprimType type, const SimTK::Rotation& R_GI, const SimTK::Rotation& R_GJ, int i,
                             int j);
std::string findMisalignment(JointType type, const SimTK::Rotation& R_GI, const SimTK::Rotation& R_GJ, int i,
                             int j);

}  // namespace jprim

#endif
