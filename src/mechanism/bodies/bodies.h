// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_BODIES_BODIES_H_
#define JPRIM_SRC_MECHANISM_BODIES_BODIES_H_

#include <string>
#include <vector>

#include "mechanism/given_poses.h"
#include "mechanism/load_modes.h"
#include "mechanism/mechanism_contents.h"
#include "mechanism/part_mass.h"
#include "mechanism/reporter.h"
#include "mechanism/tree_plan.h"

/// @file
/// PARTs, POINT_MASSes and FLEX_BODYs as bodies of the system: each kind is one file.
namespace jprim {

/// What bodies are made of, and where they go.
struct BodyContext {
    const Dataset& dataset;
    const TreePlan& plan;
    const GivenPoses& poses;
    const ModesOfBodies& modes;  ///< in SI
    SimTK::Real lightestMass;    ///< of those that the dataset gives
    MechanismContents& contents;
    Reporter& reporter;
};

/// The smallest mass in a dataset that is not zero, in kg; 1 if there is none.
[[nodiscard]] SimTK::Real findLightestMass(const Dataset& dataset, const UnitSystem& units);

/// A part with a negative principal moment of inertia: whether that matters shows when all constraints are there.
struct NegativeMoment {
    const PartStatement* statement;
    int part;
    SimTK::Mat33 inertia;  ///< about the mass centre
    SimTK::Real moment;    ///< the smallest
    std::string oddities;  ///< what else is to be said of it
};

/// Ground, then every PART after the one that it hangs on.
void addParts(const BodyContext& context, std::vector<NegativeMoment>& negativeMoments);
void addPointMasses(const BodyContext& context);
/// Those whose modes are there.
void addFlexBodies(const BodyContext& context);

/// A part without body: its name and what RigidCoordinates say.
[[nodiscard]] MechanismPart startPart(const std::string& name, const RigidCoordinates& statement, int place,
                                      const BodyContext& context);

/// Mass and inertia to solve with; what is not as of a body is reported, or noted if it is a negative moment.
/// @param size  of the part
[[nodiscard]] SolvableMass chooseMass(const PartStatement& statement, int part, SimTK::Real size,
                                      const BodyContext& context,
                                      std::vector<NegativeMoment>& negativeMoments);
/// A part may have any moment about axes about which nothing lets it turn; what it must not do is take the kinetic
/// energy from a motion.
void checkNegativeMoments(const Mechanism& mechanism, const std::vector<NegativeMoment>& negativeMoments,
                          Reporter& reporter);

}  // namespace jprim

#endif
