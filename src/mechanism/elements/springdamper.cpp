// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/elements.h"
#include "mechanism/elements/force.h"

namespace jprim {
namespace {

Operand writeDisplacement(const SpringdamperStatement& s, FunctionWriter& w) {
    return s.rotational ? w.updFrames().angleAboutZ(s.i, s.j) : w.updFrames().distance(s.i, s.j);
}

Operand writeStretch(const SpringdamperStatement& s, FunctionWriter& w) {
    return w.updBuilder().subtract(writeDisplacement(s, w), w.updBuilder().number(s.freeLength));
}

Operand writeRate(const SpringdamperStatement& s, FunctionWriter& w) {
    MarkerFrames& f = w.updFrames();
    if (s.rotational) return f.along(f.angularVelocity(s.i, s.j), s.j, 2);
    return f.radialVelocity(s.i, s.j, 0);
}

}  // namespace

// Of the displacement x and its rate along the line or about the axis:
//     load = -c dx/dt - k (x - x0) + f0,    potential = k (x - x0)^2/2 - f0 x
Element makeElement(const SpringdamperStatement& s, const ElementContext& context) {
    ForceLaw law;
    (s.rotational ? law.moment : law.force) = context.write(FunctionUse::Force, [&](FunctionWriter& w) {
        ProgramBuilder& b = w.updBuilder();
        Operand load = b.subtract(b.number(s.preload), w.scale(s.stiffness, writeStretch(s, w)));
        if (s.damping != 0) load = b.subtract(load, w.scale(s.damping, writeRate(s, w)));
        const Operand direction =
            s.rotational ? w.updFrames().axis(s.j, 2) : w.updFrames().direction(s.i, s.j);
        return b.multiply(w.scale(context.getForceUnit(s.rotational), load), direction);
    });
    law.potential = context.write(FunctionUse::Force, [&](FunctionWriter& w) {
        ProgramBuilder& b = w.updBuilder();
        const Operand spring = w.scale(s.stiffness / 2, b.multiply(writeStretch(s, w), writeStretch(s, w)));
        return w.scale(context.getUnits().getEnergy(),
                       b.subtract(spring, w.scale(s.preload, writeDisplacement(s, w))));
    });
    return makeForce({ElementKind::Springdamper, s.id}, s.i, s.j, law, s.damping != 0, context);
}

}  // namespace jprim
