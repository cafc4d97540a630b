// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "mechanism/elements/coordinates.h"
#include "mechanism/elements/elements.h"

namespace jprim {

using SimTK::State;

Element makeElement(const MotionStatement& s, const ElementContext& context) {
    const auto [i, j, coordinate] = findMotionCoordinate(s, context);
    const UnitSystem& units = context.getUnits();
    const double unit = units.getDisplacement(getDimension(coordinate)) / std::pow(units.time, int(s.level));
    const Expression function = context.write(
        FunctionUse::OfTime, [&](FunctionWriter& w) { return w.scale(unit, w.scalar(s.function)); });
    Element element;
    element.id = {ElementKind::Motion, s.id};
    element.i = i;
    element.j = j;
    const PrescribedMotion motion(context.getMarker(i), context.getMarker(j), coordinate, function, s.level,
                                  element.getName());
    element.handle = motion;
    element.dimension = getDimension(coordinate);
    element.doesWork = true;
    element.onI = [motion](const State& state) { return motion.calcReactionOnI(state); };
    element.onJ = [motion](const State& state) { return motion.calcReactionOnJ(state); };
    return element;
}

}  // namespace jprim
