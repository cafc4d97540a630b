// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/elements.h"
#include "mechanism/elements/force.h"

namespace jprim {

Element makeElement(const SforceStatement& s, const ElementContext& context) {
    const Expression load = context.write(FunctionUse::Force, [&](FunctionWriter& w) {
        const Operand size = w.scale(context.getForceUnit(s.rotational), w.scalar(s.function));
        const bool alongZ = s.rotational || s.actionOnly;
        const Operand direction = alongZ ? w.updFrames().axis(s.j, 2) : w.updFrames().direction(s.i, s.j);
        return w.updBuilder().multiply(size, direction);
    });
    ForceLaw law;
    (s.rotational ? law.moment : law.force) = load;
    return makeForce({ElementKind::Sforce, s.id}, s.i, s.actionOnly ? 0 : s.j, law, true, context);
}

}  // namespace jprim
