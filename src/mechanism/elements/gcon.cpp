// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/elements.h"
#include "mechanism/elements/equation.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;
using SimTK::Transform;

namespace {

// Of an equation between two markers the one that is not i; 0 if it is not of that kind.
int findOther(const std::vector<int>& markers, int i) {
    if (markers.size() != 2 || (markers[0] != i && markers[1] != i)) return 0;
    return markers[0] == i ? markers[1] : markers[0];
}

// Whether keeping f = 0 may take work: if f depends on time, or is an equation of velocities that rest does not
// satisfy. In which position does not matter, as long as it is not a special one.
bool doesWork(const MarkerExpression& f) {
    if (f.program.getTimeInput() >= 0) return true;
    if (f.program.getLevel() != KinematicLevel::Velocity) return false;
    std::vector<MarkerMotion> atRest;
    for (size_t k = 0; k < f.markers.size(); ++k)
        atRest.push_back({Transform(SimTK::Rotation(1.1 + Real(k), SimTK::UnitVec3(1, 2, 3)),
                                    SimTK::Vec3(1.3, -0.7, 2.1) * (1.9 + Real(k)))});
    Evaluation evaluation(f.program);
    f.setInputs(0, atRest.data(), evaluation);
    return evaluation.calcValue() != 0;
}

}  // namespace

// A GCON has no J, but one between two markers is reported on both.
Element makeElement(const GconStatement& s, const ElementContext& context) {
    const Expression f =
        context.write(FunctionUse::Equation, [&s](FunctionWriter& w) { return w.scalar(s.function); });
    Element element = makeEquation({ElementKind::Gcon, s.id}, f, context);
    element.i = s.i;
    element.j = findOther(f.getImplementation().markerIds, s.i);
    element.doesWork = doesWork(f.getImplementation());
    const auto on = [constraint = *element.getGeneralConstraint()](int marker) -> LoadFunction {
        return [constraint, marker](const State& state) { return constraint.calcReactionOn(state, marker); };
    };
    element.onI = on(element.i);
    if (element.j != 0) element.onJ = on(element.j);
    return element;
}

}  // namespace jprim
