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

/// What is wrong with the given orientations of markers i and j if their axes, which the type wants equal,
/// are nearer to opposite; empty if nothing is.
std::string findFlip(JprimType type, const SimTK::Rotation& R_GI, const SimTK::Rotation& R_GJ, int i, int j);
std::string findFlip(JointType type, const SimTK::Rotation& R_GI, const SimTK::Rotation& R_GJ, int i, int j);

}  // namespace jprim

#endif
