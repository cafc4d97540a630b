// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_MECHANISM_UNITS_H_
#define JPRIM_SRC_MECHANISM_MECHANISM_UNITS_H_

#include "jprim/dataset/dataset.h"
#include "mechanism/given_poses.h"
#include "mechanism/load_modes.h"
#include "mechanism/reporter.h"

namespace jprim {

/// A dataset's units in SI.
UnitSystem findUnits(const Dataset& dataset, Reporter& reporter);

/// 1 m, or the power of 1000 of it that suits the largest reach of a part: tolerances of assembly and integration are
/// absolute numbers, and Simbody weighs lengths against angles; both assume that a part's size is of order one.
/// @param poses  in metres
double chooseLengthUnit(const Dataset& dataset, const ModesOfBodies& modes, const GivenPoses& poses);

/// Units in SI in terms of kg, s and a unit of length of L metres, in which the unit of force is L newtons.
UnitSystem convertUnits(const UnitSystem& toSI, double lengthUnit);

}  // namespace jprim

#endif
