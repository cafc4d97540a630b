// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_ELEMENTS_ELEMENT_CONTEXT_H_
#define JPRIM_SRC_MECHANISM_ELEMENTS_ELEMENT_CONTEXT_H_

#include <map>
#include <unordered_map>
#include <utility>

#include "mechanism/function_writer.h"
#include "mechanism/given_poses.h"
#include "mechanism/mechanism_contents.h"
#include "mechanism/planar_loops.h"
#include "mechanism/tree_plan.h"

namespace jprim {

/// What elements are made of: all of it is finished, but for the list of elements, to which each is added when it is made.
struct ElementContext {
    const Dataset& dataset;
    const TreePlan& plan;
    const PlanarLoops& planarLoops;
    const GivenPoses& poses;
    const FunctionContext& functions;
    MechanismContents& contents;

    [[nodiscard]] const UnitSystem& getUnits() const { return contents.units; }
    /// Unit of a force, or of a moment.
    [[nodiscard]] SimTK::Real getForceUnit(bool isMoment) const {
        return isMoment ? contents.units.getMoment() : contents.units.force;
    }
    [[nodiscard]] const Marker& getMarker(int id) const { return contents.getMarker(id); }
    [[nodiscard]] const JointStatement& getJoint(int id) const { return *joints.at(id); }

    /// An expression of functions of the dataset. @throws FunctionError
    template <class Compose>
    [[nodiscard]] Expression write(FunctionUse use, const Compose& compose) const {
        const MarkerFrames::FindMarker find = [this](int id) { return findFixedMarker(id); };
        FunctionWriter writer(find, functions, use);
        return writer.finish(compose(writer));
    }
    /// A function's value for output. @throws FunctionError
    [[nodiscard]] ExpressionMeasure makeMeasure(const ExpressionText& function) const;

    std::unordered_map<int, const JointStatement*> joints;

private:
    // Expressions cannot name floating markers, whose place is decided by what names them.
    const Marker* findFixedMarker(int id) const;
};

}  // namespace jprim

#endif
