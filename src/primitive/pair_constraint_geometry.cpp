// SPDX-License-Identifier: Apache-2.0
#include "primitive/pair_constraint_impl.h"

namespace jprim {

using SimTK::Array_;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;

// Both triads, and through I's origin each constrained direction: red for a force, magenta for a torque.
void PairConstraintImpl::calcDecorativeGeometryAndAppend(const State& state, Stage stage,
                                                         Array_<SimTK::DecorativeGeometry>& geometry) const {
    if (stage != Stage::Position) return;
    constexpr Real TriadSize = 0.1, DirectionSize = 0.15;
    const Placements& placements = getPlacements(state);
    const Transform X_GI = getMarkerI(placements.I).findPoseInGround(state);
    const Transform X_GJ = getMarkerJ(placements.J).findPoseInGround(state);
    for (const auto& [X_GM, colour] : {std::pair(X_GI, SimTK::Orange), std::pair(X_GJ, SimTK::Blue)})
        geometry.push_back(SimTK::DecorativeFrame(TriadSize).setTransform(X_GM).setColor(colour));

    const MarkerPair pair(X_GI, X_GJ);
    Directions d;
    calcDirections(pair, d);
    for (int k = 0; k < getNumEquations(); ++k) {
        const SpatialVec load = pair.calcLoadOnI(d[k]);
        const bool isForce = load[1].normSqr() > 0;
        const Vec3 direction = isForce ? load[1] : load[0];
        if (direction.normSqr() == 0) continue;
        const Vec3 half = DirectionSize * direction.normalize();
        geometry.push_back(SimTK::DecorativeLine(X_GI.p() - half, X_GI.p() + half)
                               .setColor(isForce ? SimTK::Red : SimTK::Magenta)
                               .setLineThickness(3));
    }
}

}  // namespace jprim
