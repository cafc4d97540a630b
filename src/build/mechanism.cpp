// SPDX-License-Identifier: Apache-2.0
#include "jprim/build/mechanism.h"

#include <fmt/format.h>

#include "jprim/base/error.h"
#include "jprim/marker/load.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;

Mechanism::Mechanism() : m_bodies(std::make_unique<Bodies>()) {}

bool Mechanism::isConservative() const {
    for (const MechanismPart& part : m_parts)
        if (part.flexible)
            for (const Real ratio : part.flexible->getDampingRatios())
                if (ratio > 0) return false;
    return true;
}

Real Mechanism::calcKineticEnergy(const State& state) const {
    Real sum = getSystem().calcKineticEnergy(state);
    for (const MechanismPart& part : m_parts)
        if (part.flexible) sum += part.flexible->calcCouplingEnergy(state);
    return sum;
}

const Marker& Mechanism::getMarker(int id) const {
    const auto found = m_markers.find(id);
    if (found == m_markers.end())
        throw Error(fmt::format("MARKER/{}", id), "does not exist in this mechanism");
    return found->second;
}

Real Mechanism::calcReaction(const State& state, const std::string& name, int jflag, int comp, int rm) const {
    const auto found = m_connectionIndex.find(name);
    if (found == m_connectionIndex.end()) throw Error(name, "does not exist in this mechanism");
    const Real value = m_connections[found->second].joint.JOINT(state, jflag, comp, getMarker(rm));
    return value * (comp <= 4 ? m_lengthUnit : m_lengthUnit * m_lengthUnit);  // to N or N m
}

Real Mechanism::calcJPRIM(const State& state, int id, int jflag, int comp, int rm) const {
    return calcReaction(state, fmt::format("JPRIM/{}", id), jflag, comp, rm);
}

Real Mechanism::calcJOINT(const State& state, int id, int jflag, int comp, int rm) const {
    return calcReaction(state, fmt::format("JOINT/{}", id), jflag, comp, rm);
}

// Simbody numbers the equations of its constraints in the order they were added.
std::vector<Mechanism::Equation> Mechanism::findEquations(const State& state) const {
    std::vector<Equation> equations;
    for (const Connection& connection : m_connections)
        for (const Primitive& primitive : connection.joint.getPrimitives()) {
            if (primitive.isDisabled(state)) continue;
            int mp = 0, mv = 0, ma = 0;
            primitive.getNumConstraintEquationsInUse(state, mp, mv, ma);
            for (int k = 0; k < mp; ++k) equations.push_back({connection.name, primitive.isTranslational()});
        }
    return equations;
}

}  // namespace jprim
