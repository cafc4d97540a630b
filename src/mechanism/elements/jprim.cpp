// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/connection.h"
#include "mechanism/elements/elements.h"

namespace jprim {
namespace {

Primitive makePrimitive(JprimType type, const Marker& I, const Marker& J, const std::string& name) {
    switch (type) {
        case JprimType::AtPoint: return AtPoint(I, J, name);
        case JprimType::InLine: return InLine(I, J, name);
        case JprimType::InPlane: return InPlane(I, J, name);
        case JprimType::Orientation: return Orientation(I, J, name);
        case JprimType::ParallelAxes: return ParallelAxes(I, J, name);
        case JprimType::Perpendicular: break;
    }
    return Perpendicular(I, J, name);
}

}  // namespace

Element makeElement(const JprimStatement& s, const ElementContext& context) {
    const ElementId id{ElementKind::Jprim, s.id};
    const auto makeEquations = [&] {
        return Joint(makePrimitive(s.type, context.getMarker(s.i), context.getMarker(s.j), id.getText()));
    };
    return makeConnection(id, getAdamsName(s.type), s.i, s.j, findLoopEquations(s.type), makeEquations,
                          context);
}

}  // namespace jprim
