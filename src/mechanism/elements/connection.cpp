// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/connection.h"

#include "mechanism/mobilizers.h"

namespace jprim {

using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;

namespace {

void addTreeLoad(const TreePlace& place, const ElementContext& context, Element& element) {
    const PlannedMobilizer& m = *place.mobilizer;
    const TreeJoint joint(context.contents.parts[size_t(m.part)].body, context.getMarker(m.i),
                          context.getMarker(m.j), m.reversed);
    const LoadShare share = place.element->share;
    element.onI = [=](const State& state) { return joint.calcLoadOnI(state, share); };
    element.onJ = [=](const State& state) { return joint.calcLoadOnJ(state, share); };
    if (place.element->swapped) std::swap(element.onI, element.onJ);
}

void addLoad(Element& element) {
    const Joint* joint = element.getJoint();
    if (!joint) {
        element.onI = element.onJ = [](const State&) { return SpatialVec(Vec3(0), Vec3(0)); };
        return;
    }
    element.onI = [joint = *joint](const State& s) { return joint.calcReactionOnI(s); };
    element.onJ = [joint = *joint](const State& s) { return joint.calcReactionOnJ(s); };
}

}  // namespace

Element makeConnection(const ElementId& id, const char* type, int i, int j, LoopEquations inPlane,
                       const std::function<Joint()>& makeEquations, const ElementContext& context) {
    Element element;
    element.id = id;
    element.type = type;
    element.i = i;
    element.j = j;
    if (const std::optional<TreePlace> place = context.plan.find(id)) {
        element.inTree = true;
        addTreeLoad(*place, context, element);
        return element;
    }
    const LoopEquations left = context.planarLoops.isPlanar(i, j) ? inPlane : LoopEquations::All;
    if (left == LoopEquations::All) element.handle = makeEquations();
    if (left == LoopEquations::InLine)
        element.handle = Joint(InLine(context.getMarker(i), context.getMarker(j), id.getText()));
    addLoad(element);
    return element;
}

}  // namespace jprim
