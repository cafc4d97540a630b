// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/element_context.h"

namespace jprim {

const Marker* ElementContext::findFixedMarker(int id) const {
    const auto found = contents.markers.find(id);
    const bool usable = found != contents.markers.end() && functions.floatingMarkers.count(id) == 0;
    return usable ? &found->second : nullptr;
}

ExpressionMeasure ElementContext::makeMeasure(const ExpressionText& function) const {
    const Expression f =
        write(FunctionUse::Output, [&function](FunctionWriter& w) { return w.scalar(function); });
    return ExpressionMeasure(contents.forces, f);
}

}  // namespace jprim
