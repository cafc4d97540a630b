// SPDX-License-Identifier: Apache-2.0
#include "mechanism/elements/elements.h"
#include "mechanism/elements/force.h"

namespace jprim {

using SimTK::Real;

namespace {

Operand writeAngle(const BushingStatement& s, FunctionWriter& w, int axis) {
    return w.updFrames().projectedAngle(s.i, s.j, axis);
}

Operand writePosition(const BushingStatement& s, FunctionWriter& w, int axis) {
    return w.updFrames().along(w.updFrames().position(s.i, s.j), s.j, axis);
}

Expression writeLoad(const BushingStatement& s, bool isMoment, const ElementContext& context) {
    const Triple &k = isMoment ? s.kt : s.k, &c = isMoment ? s.ct : s.c,
                 &preload = isMoment ? s.torque : s.force;
    return context.write(FunctionUse::Force, [&](FunctionWriter& w) {
        ProgramBuilder& b = w.updBuilder();
        MarkerFrames& f = w.updFrames();
        const auto along = [&](int axis) {
            const auto n = size_t(axis);
            Operand load = b.number(preload[n]);
            if (k[n] != 0)
                load = b.subtract(
                    load, w.scale(k[n], isMoment ? writeAngle(s, w, axis) : writePosition(s, w, axis)));
            if (c[n] == 0) return load;
            const Operand v = isMoment ? f.angularVelocity(s.i, s.j) : f.velocity(s.i, s.j, s.j);
            return b.subtract(load, w.scale(c[n], f.along(v, s.j, axis)));
        };
        const Operand load = b.vector(along(0), along(1), along(2));
        return w.scale(context.getForceUnit(isMoment), w.fromAxesOf(s.j, load));
    });
}

Expression writePotential(const BushingStatement& s, const ElementContext& context) {
    return context.write(FunctionUse::Force, [&](FunctionWriter& w) {
        ProgramBuilder& b = w.updBuilder();
        Operand energy = b.number(0);
        const auto add = [&](Real stiffness, Real preload, Operand x) {
            energy = b.add(energy, w.scale(stiffness / 2, b.multiply(x, x)));
            energy = b.subtract(energy, w.scale(preload, x));
        };
        for (int axis = 0; axis < 3; ++axis) {
            const auto n = size_t(axis);
            add(s.k[n], s.force[n], writePosition(s, w, axis));
            if (s.kt[n] != 0 || s.torque[n] != 0) add(s.kt[n], s.torque[n], writeAngle(s, w, axis));
        }
        return w.scale(context.getUnits().getEnergy(), energy);
    });
}

}  // namespace

// Along and about each axis of J, with the projected angles AX, AY, AZ, of which at most one may be large. The
// energy of translations is a potential; that of rotations is one only while the angles are small.
Element makeElement(const BushingStatement& s, const ElementContext& context) {
    ForceLaw law;
    law.force = writeLoad(s, false, context);
    law.moment = writeLoad(s, true, context);
    law.potential = writePotential(s, context);
    const bool doesWork = s.c != Triple{} || s.ct != Triple{} || s.kt != Triple{} || s.torque != Triple{};
    return makeForce({ElementKind::Bushing, s.id}, s.i, s.j, law, doesWork, context);
}

}  // namespace jprim
