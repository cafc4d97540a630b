// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MARKER_LOAD_H_
#define JPRIM_MARKER_LOAD_H_

#include <string>

#include "jprim/marker/marker.h"

namespace jprim {

/// A load [moment, force] given in Ground's axes, in the axes of a marker; its point stays. Requires
/// Stage::Position.
SimTK::SpatialVec expressLoadIn(const SimTK::State& state, const SimTK::SpatialVec& load_G,
                                const Marker& axes);

/// One component of a load [moment, force]: 1 … 8 = FM FX FY FZ TM TX TY TZ; FM and TM are magnitudes.
SimTK::Real getLoadComponent(const SimTK::SpatialVec& load, int component);

/// One component of a reaction, chosen as Adams' functions JPRIM(id, jflag, comp, rm) and JOINT(…) do.
/// @param onI,onJ  the load on I at I's origin and on J at J's, both in the wanted axes
/// @param jflag    0: onI; 1: onJ
/// @param comp     1 … 8 = FM FX FY FZ TM TX TY TZ; FM and TM are magnitudes
/// @param element  named in the message
/// @throws Error   for any other jflag or comp
SimTK::Real getReactionComponent(const SimTK::SpatialVec& onI, const SimTK::SpatialVec& onJ, int jflag,
                                 int comp, const std::string& element);

}  // namespace jprim

#endif
