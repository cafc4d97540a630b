// SPDX-License-Identifier: Apache-2.0
// The part of MechanismBuilder that makes forces. Each is written as expressions in the dataset's units, times
// the unit of its result.
#include "base/format.h"
#include "build/mechanism_builder.h"
#include "build/power.h"
#include "build/work_integral.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;

void MechanismBuilder::addForces() {
    for (const SforceStatement& s : m_dataset.sforces) addSforce(s);
    for (const VectorForceStatement& s : m_dataset.vectorForces) addVectorForce(s);
    for (const SpringdamperStatement& s : m_dataset.springdampers) addSpringdamper(s);
    for (const BushingStatement& s : m_dataset.bushings) addBushing(s);
}

// The system holds the power, and the power a reference to the system, which stays where it is if the mechanism moves.
void MechanismBuilder::addWorkIntegral() {
    if (m_mechanism.isConservative()) return;
    Mechanism::Bodies& bodies = *m_mechanism.m_bodies;
    Loads loads{m_mechanism.m_gravity, m_mechanism.m_forces, {}, m_working};
    for (const MechanismPart& part : m_mechanism.m_parts)
        if (part.flexible) loads.flexibleBodies.push_back(*part.flexible);
    auto* work = new WorkIntegral(bodies.forces, [&system = bodies.system, loads](const State& state) {
        return calcPowerWithoutPotential(system, loads, state);
    });
    SimTK::Force::Custom(bodies.forces, work);  // takes it over
    m_mechanism.m_work = work;
}

// A floating marker is where I is, wherever its part has it: nothing levers about it.
void MechanismBuilder::addForce(const std::string& name, int i, int j, const ForceLaw& law) {
    const Marker& I = m_mechanism.getMarker(i);
    std::optional<Marker> J;
    if (j != 0) J = m_mechanism.getMarker(j);
    const MarkerForce force(m_mechanism.m_bodies->forces, I, J, law, name);
    m_mechanism.m_forces.push_back(force);
    LoadFunction onJ;
    if (m_functions.floatingMarkers.count(j) > 0)
        onJ = [force](const State& state) { return -force.calcLoadOnI(state); };
    else if (J)
        onJ = [force](const State& state) { return force.calcLoadOnJ(state); };
    addLoadElement(
        {name, i, j, [force](const State& state) { return force.calcLoadOnI(state); }, onJ, false});
}

void MechanismBuilder::addSforce(const SforceStatement& s) {
    const std::string name = fmt::format("SFORCE/{}", s.id);
    attempt(name, s.where, [&] {
        const Expression load = write(FunctionUse::Force, [&](FunctionWriter& w) {
            const Operand size = w.scale(getForceUnit(s.rotational), w.scalar(s.function));
            const bool alongZ = s.rotational || s.actionOnly;
            const Operand direction = alongZ ? w.updFrames().axis(s.j, 2) : w.updFrames().direction(s.i, s.j);
            return w.updBuilder().multiply(size, direction);
        });
        ForceLaw law;
        (s.rotational ? law.moment : law.force) = load;
        m_mechanism.m_hasPower = true;
        addForce(name, s.i, s.actionOnly ? 0 : s.j, law);
    });
}

void MechanismBuilder::addVectorForce(const VectorForceStatement& s) {
    const std::string name = fmt::format("{}/{}", getAdamsName(s.type), s.id);
    const auto writeVector = [&](int first,
                                 const std::optional<ExpressionText>& whole) -> std::optional<Expression> {
        const auto* parts = &s.components[size_t(first)];
        if (!whole && !parts[0] && !parts[1] && !parts[2]) return std::nullopt;
        return write(FunctionUse::Force, [&](FunctionWriter& w) {
            const auto part = [&](int k) {
                return parts[k] ? w.scalar(*parts[k]) : w.updBuilder().number(0);
            };
            const Operand vector =
                whole ? w.vector(*whole) : w.updBuilder().vector(part(0), part(1), part(2));
            return w.scale(getForceUnit(first == 3), w.fromAxesOf(s.rm, vector));
        });
    };
    attempt(name, s.where, [&] {
        ForceLaw law;
        law.force = writeVector(0, s.fxyz);
        law.moment = writeVector(3, s.txyz);
        m_mechanism.m_hasPower = true;
        addForce(name, s.i, s.jfloat, law);
    });
}

// Of the displacement x and its rate along the line or about the axis:
//     load = -c dx/dt - k (x - x0) + f0,    potential = k (x - x0)^2/2 - f0 x
void MechanismBuilder::addSpringdamper(const SpringdamperStatement& s) {
    const std::string name = fmt::format("SPRINGDAMPER/{}", s.id);
    const auto displacement = [&s](FunctionWriter& w) {
        return s.rotational ? w.updFrames().angleAboutZ(s.i, s.j) : w.updFrames().distance(s.i, s.j);
    };
    const auto stretch = [&](FunctionWriter& w) {
        return w.updBuilder().subtract(displacement(w), w.updBuilder().number(s.freeLength));
    };
    const auto rate = [&s](FunctionWriter& w) {
        MarkerFrames& f = w.updFrames();
        if (s.rotational) return f.along(f.angularVelocity(s.i, s.j), s.j, 2);
        return f.radialVelocity(s.i, s.j, 0);
    };
    attempt(name, s.where, [&] {
        ForceLaw law;
        (s.rotational ? law.moment : law.force) = write(FunctionUse::Force, [&](FunctionWriter& w) {
            ProgramBuilder& b = w.updBuilder();
            Operand load = b.subtract(b.number(s.preload), w.scale(s.stiffness, stretch(w)));
            if (s.damping != 0) load = b.subtract(load, w.scale(s.damping, rate(w)));
            const Operand direction =
                s.rotational ? w.updFrames().axis(s.j, 2) : w.updFrames().direction(s.i, s.j);
            return b.multiply(w.scale(getForceUnit(s.rotational), load), direction);
        });
        law.potential = write(FunctionUse::Force, [&](FunctionWriter& w) {
            ProgramBuilder& b = w.updBuilder();
            const Operand spring = w.scale(s.stiffness / 2, b.multiply(stretch(w), stretch(w)));
            return w.scale(m_mechanism.m_units.getEnergy(),
                           b.subtract(spring, w.scale(s.preload, displacement(w))));
        });
        m_mechanism.m_hasPower = m_mechanism.m_hasPower || s.damping != 0;
        addForce(name, s.i, s.j, law);
    });
}

// Along and about each axis of J, with the projected angles AX, AY, AZ, of which at most one may be large. The
// energy of translations is a potential; that of rotations is one only while the angles are small.
void MechanismBuilder::addBushing(const BushingStatement& s) {
    const std::string name = fmt::format("BUSHING/{}", s.id);
    const auto angle = [&s](FunctionWriter& w, int axis) {
        return w.updFrames().projectedAngle(s.i, s.j, axis);
    };
    const auto position = [&s](FunctionWriter& w, int axis) {
        return w.updFrames().along(w.updFrames().position(s.i, s.j), s.j, axis);
    };
    const auto writeLoad = [&](const Triple& k, const Triple& c, const Triple& preload, const auto& x,
                               bool turns) {
        return write(FunctionUse::Force, [&](FunctionWriter& w) {
            ProgramBuilder& b = w.updBuilder();
            MarkerFrames& f = w.updFrames();
            const auto along = [&](int axis) {
                Operand load = b.number(preload[size_t(axis)]);
                if (k[size_t(axis)] != 0) load = b.subtract(load, w.scale(k[size_t(axis)], x(w, axis)));
                if (c[size_t(axis)] == 0) return load;
                const Operand v = turns ? f.angularVelocity(s.i, s.j) : f.velocity(s.i, s.j, s.j);
                return b.subtract(load, w.scale(c[size_t(axis)], f.along(v, s.j, axis)));
            };
            const Operand load = b.vector(along(0), along(1), along(2));
            return w.scale(getForceUnit(turns), w.fromAxesOf(s.j, load));
        });
    };
    attempt(name, s.where, [&] {
        ForceLaw law;
        law.force = writeLoad(s.k, s.c, s.force, position, false);
        law.moment = writeLoad(s.kt, s.ct, s.torque, angle, true);
        law.potential = write(FunctionUse::Force, [&](FunctionWriter& w) {
            ProgramBuilder& b = w.updBuilder();
            Operand energy = b.number(0);
            const auto add = [&](Real stiffness, Real preload, Operand x) {
                energy = b.add(energy, w.scale(stiffness / 2, b.multiply(x, x)));
                energy = b.subtract(energy, w.scale(preload, x));
            };
            for (int axis = 0; axis < 3; ++axis) {
                const size_t k = size_t(axis);
                add(s.k[k], s.force[k], position(w, axis));
                if (s.kt[k] != 0 || s.torque[k] != 0) add(s.kt[k], s.torque[k], angle(w, axis));
            }
            return w.scale(m_mechanism.m_units.getEnergy(), energy);
        });
        m_mechanism.m_hasPower = m_mechanism.m_hasPower || s.c != Triple{} || s.ct != Triple{} ||
                                 s.kt != Triple{} || s.torque != Triple{};
        addForce(name, s.i, s.j, law);
    });
}

}  // namespace jprim
