// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/force.h"

namespace jprim {

using SimTK::State;

Element makeForce(const ElementId& id, int i, int j, const ForceLaw& law, bool doesWork,
                  const ElementContext& context) {
    std::optional<Marker> J;
    if (j != 0) J = context.getMarker(j);
    const MarkerForce force(context.contents.forces, context.getMarker(i), J, law, id.getText());
    Element element;
    element.id = id;
    element.i = i;
    element.j = j;
    element.handle = force;
    element.doesWork = doesWork;
    element.onI = [force](const State& state) { return force.calcLoadOnI(state); };
    if (context.functions.floatingMarkers.count(j) > 0)
        element.onJ = [force](const State& state) { return -force.calcLoadOnI(state); };
    else if (J)
        element.onJ = [force](const State& state) { return force.calcLoadOnJ(state); };
    return element;
}

}  // namespace jprim
