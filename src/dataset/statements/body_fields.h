// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_STATEMENTS_BODY_FIELDS_H_
#define JPRIM_SRC_DATASET_STATEMENTS_BODY_FIELDS_H_

#include "dataset/fields.h"
#include "dataset/language/statement_reader.h"

/// @file
/// What PART, POINT_MASS and FLEX_BODY have in common.
namespace jprim {

/// QG, REULER, ZG, XG.
std::vector<Field<RigidCoordinates>> poseFields();
/// VX, VY, VZ.
std::vector<Field<RigidCoordinates>> velocityFields();
/// WX, WY, WZ, VM, WM of a body that turns.
std::vector<Field<RigidCoordinates>> rotationFields();
/// EXACT with all coordinates of a body, or with X, Y, Z only.
Field<RigidCoordinates> exactField(bool turns);

/// A mass is not negative, and has a centre.
void checkMass(StatementReader& reader, const std::optional<double>& mass, int cm);

/// Euler angles and points are two ways to say the same thing.
void checkOrientation(StatementReader& reader, const char* z, const char* x);

}  // namespace jprim

#endif
