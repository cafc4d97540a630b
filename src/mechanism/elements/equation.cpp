// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/equation.h"

#include <algorithm>
#include <cmath>

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;

Element makeEquation(const ElementId& id, const Expression& f, const ElementContext& context) {
    const MarkerExpression& e = f.getImplementation();
    std::vector<MarkerMotion> motions(e.markers.size());
    std::vector<Real> sizes;
    for (size_t k = 0; k < e.markers.size(); ++k) {
        motions[k].X = context.poses.getPose(e.markerIds[k]);
        sizes.push_back(context.contents.parts[size_t(context.poses.getPart(e.markerIds[k]))].size);
    }
    Evaluation evaluation(e.program);
    e.setInputs(0, motions.data(), evaluation);
    evaluation.calcValue();
    evaluation.calcGradient();
    Real linear = 0, angular = 0;
    for (size_t k = 0; k < e.markers.size(); ++k) {
        const SpatialVec direction = e.getDirection(evaluation, motions.data(), int(k));
        linear = std::max(linear, direction[1].norm());
        angular = std::max(angular, direction[0].norm() / sizes[k]);
    }
    GeneralConstraint constraint(f, id.getText());
    const Real size = std::max(linear, angular);
    if (size > 0 && std::isfinite(size)) constraint.setDefaultScale(std::exp2(-std::round(std::log2(size))));
    Element element;
    element.id = id;
    element.handle = constraint;
    element.dimension = linear > 0 ? Dimension::Length : Dimension::Angle;
    return element;
}

}  // namespace jprim
