// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/elements.h"
#include "mechanism/elements/force.h"

namespace jprim {
namespace {

// Three components, or the vector that is given as a whole; nothing if neither is.
std::optional<Expression> writeVector(const VectorForceStatement& s, bool isMoment,
                                      const ElementContext& context) {
    const std::optional<ExpressionText>& whole = isMoment ? s.txyz : s.fxyz;
    const auto* parts = &s.components[isMoment ? 3 : 0];
    if (!whole && !parts[0] && !parts[1] && !parts[2]) return std::nullopt;
    return context.write(FunctionUse::Force, [&](FunctionWriter& w) {
        const auto part = [&](int k) { return parts[k] ? w.scalar(*parts[k]) : w.updBuilder().number(0); };
        const Operand vector = whole ? w.vector(*whole) : w.updBuilder().vector(part(0), part(1), part(2));
        return w.scale(context.getForceUnit(isMoment), w.fromAxesOf(s.rm, vector));
    });
}

}  // namespace

ElementId getElementId(const VectorForceStatement& s) {
    switch (s.type) {
        case VectorForceType::Vforce: return {ElementKind::Vforce, s.id};
        case VectorForceType::Vtorque: return {ElementKind::Vtorque, s.id};
        case VectorForceType::Gforce: break;
    }
    return {ElementKind::Gforce, s.id};
}

Element makeElement(const VectorForceStatement& s, const ElementContext& context) {
    ForceLaw law;
    law.force = writeVector(s, false, context);
    law.moment = writeVector(s, true, context);
    return makeForce(getElementId(s), s.i, s.jfloat, law, true, context);
}

}  // namespace jprim
