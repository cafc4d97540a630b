// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BUILD_PLANAR_LOOPS_H_
#define JPRIM_SRC_BUILD_PLANAR_LOOPS_H_

#include <functional>
#include <optional>
#include <unordered_map>

#include "SimTKcommon.h"
#include "build/tree_plan.h"

namespace jprim {

/// Finds loops that the joints in the tree keep in a plane: a hinge that closes a four-bar has to hold I's origin
/// on J's z axis, and nothing else. Where axes are parallel is a matter of the markers on each part, not of where
/// the parts are, so that it holds in all positions.
class PlanarLoops {
public:
    /// The pose of a marker in its part's BCS, and the place of its part in the dataset.
    using FindPose = std::function<SimTK::Transform(int)>;
    using FindPart = std::function<int(int)>;

    PlanarLoops(const TreePlan& plan, FindPose findPose, FindPart findPart);

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
    FindPose m_findPose;
    FindPart m_findPart;
};

/// What an element that closes a planar loop has left to do.
enum class LoopEquations { All, InLine, None };
LoopEquations findLoopEquations(JprimType type);
LoopEquations findLoopEquations(JointType type);

}  // namespace jprim

#endif
