// SPDX-License-Identifier: Apache-2.0
#include "jprim/marker/load.h"

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;

SpatialVec expressLoadIn(const State& state, const SpatialVec& load_G, const Marker& axes) {
    return ~axes.findPoseInGround(state).R() * load_G;
}

Real getLoadComponent(const SpatialVec& load, int component) {
    const Vec3& half = component <= 4 ? load[1] : load[0];
    const int axis = (component - 1) % 4;  // 0 is the magnitude
    return axis == 0 ? half.norm() : half[axis - 1];
}

Real getReactionComponent(const SpatialVec& onI, const SpatialVec& onJ, int jflag, int comp,
                          const std::string& element) {
    if (jflag != 0 && jflag != 1)
        throw Error(
            element,
            fmt::format("jflag {} does not exist; use 0 for the load on I, 1 for the load on J", jflag));
    if (comp < 1 || comp > 8)
        throw Error(element, fmt::format("component {} of a reaction does not exist; use 1 to 8 for "
                                         "FM FX FY FZ TM TX TY TZ",
                                         comp));
    return getLoadComponent(jflag == 0 ? onI : onJ, comp);
}

}  // namespace jprim
