// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_PLANAR_LOOPS_H_
#define JPRIM_SRC_MECHANISM_PLANAR_LOOPS_H_

#include <optional>
#include <unordered_map>

#include "SimTKcommon.h"
#include "mechanism/given_poses.h"
#include "mechanism/tree_plan.h"

namespace jprim {

/// Finds loops that the joints in the tree keep in a plane: a hinge that closes a four-bar has to hold I's origin
/// on J's z axis, and nothing else. Where axes are parallel is a matter of the markers on each part, not of where
/// the parts are, so that it holds in all positions.
class PlanarLoops {
public:
    PlanarLoops(const TreePlan& plan, const GivenPoses& poses);

    /// True if the tree keeps the z axes of the markers alike and lets neither move along them off the other's xy
    /// plane.
    bool isPlanar(int i, int j) const;

private:
    /// A plane in the axes of a part's BCS: its normal, and its height over the BCS' origin.
    struct Plane {
        SimTK::Vec3 normal;
        SimTK::Real height;
    };

    std::unordered_map<int, Plane> carryToRoot(int marker) const;
    std::optional<Plane> carryToParent(const PlannedMobilizer& mobilizer, const Plane& plane) const;

    std::unordered_map<int, const PlannedMobilizer*> m_mobilizers;  // by the part that they move
    const GivenPoses& m_poses;
};

/// What an element that closes a planar loop has left to do.
enum class LoopEquations { All, InLine, None };
LoopEquations findLoopEquations(JprimType type);
LoopEquations findLoopEquations(JointType type);

}  // namespace jprim

#endif
