// SPDX-License-Identifier: Apache-2.0
#include "jprim/build/mechanism.h"

#include <algorithm>

#include "base/format.h"
#include "build/work_integral.h"
#include "jprim/base/error.h"
#include "jprim/marker/load.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;
using SimTK::Transform;

Mechanism::Mechanism() : m_bodies(std::make_unique<Bodies>()) {}

bool Mechanism::isConservative() const {
    if (m_hasPower) return false;
    for (const MechanismPart& part : m_parts)
        if (part.flexible)
            for (const Real ratio : part.flexible->getDampingRatios())
                if (ratio > 0) return false;
    return true;
}

namespace {

// X_FM of a part's mobilizer between bodies at these poses.
Transform calcMobilizerPose(const State& state, const MechanismPart& part, const Transform& X_GP,
                            const Transform& X_GB) {
    return ~(X_GP * part.body.getInboardFrame(state)) * (X_GB * part.body.getOutboardFrame(state));
}

}  // namespace

Transform Mechanism::calcGivenMobilizerPose(const State& state, const MechanismPart& part) const {
    const int parent = part.attachment.parent;
    return calcMobilizerPose(state, part,
                             parent < 0 ? Transform() : m_parts[size_t(parent)].calcGivenBodyPose(),
                             part.calcGivenBodyPose());
}

void Mechanism::fitPoses(const std::vector<Transform>& poses, State& state) const {
    for (size_t k = 0; k < m_parts.size(); ++k) {
        const int parent = m_parts[k].attachment.parent;
        if (m_parts[k].ground) continue;
        m_parts[k].body.setQToFitTransform(
            state,
            calcMobilizerPose(state, m_parts[k], parent < 0 ? Transform() : poses[size_t(parent)], poses[k]));
    }
}

State Mechanism::makeGivenState() const {
    State state = getSystem().realizeTopology();
    getSystem().realizeModel(state);
    std::vector<Transform> poses;
    for (const MechanismPart& part : m_parts) poses.push_back(part.calcGivenBodyPose());
    fitPoses(poses, state);
    return state;
}

std::optional<Mechanism> Mechanism::makeWithFreeParts() const {
    if (!m_makeWithFreeParts) return std::nullopt;
    return m_makeWithFreeParts();
}

Real Mechanism::calcKineticEnergy(const State& state) const {
    Real sum = getSystem().calcKineticEnergy(state);
    for (const MechanismPart& part : m_parts)
        if (part.flexible) sum += part.flexible->calcCouplingEnergy(state);
    return sum;
}

Real Mechanism::calcEnergyBalance(const State& state) const {
    const Real potential = getSystem().calcPotentialEnergy(state);
    if (!m_work) return calcKineticEnergy(state) + potential;
    return getSystem().calcKineticEnergy(state) + potential - m_work->getWork(state);
}

const Marker& Mechanism::getMarker(int id) const {
    const auto found = m_markers.find(id);
    if (found == m_markers.end())
        throw Error(fmt::format("MARKER/{}", id), "does not exist in this mechanism");
    return found->second;
}

Real Mechanism::calcReaction(const State& state, const std::string& name, int jflag, int comp, int rm) const {
    const auto found = m_connectionLoad.find(name);
    if (found == m_connectionLoad.end()) throw Error(name, "does not exist in this mechanism");
    const LoadElement& element = m_loadElements[found->second];
    const Marker& axes = getMarker(rm);
    const Real value =
        getReactionComponent(expressLoadIn(state, element.onI(state), axes),
                             expressLoadIn(state, element.onJ(state), axes), jflag, comp, name);
    return value * (comp <= 4 ? m_lengthUnit : m_lengthUnit * m_lengthUnit);  // to N or N m
}

Real Mechanism::calcJPRIM(const State& state, int id, int jflag, int comp, int rm) const {
    return calcReaction(state, fmt::format("JPRIM/{}", id), jflag, comp, rm);
}

Real Mechanism::calcJOINT(const State& state, int id, int jflag, int comp, int rm) const {
    return calcReaction(state, fmt::format("JOINT/{}", id), jflag, comp, rm);
}

std::vector<std::string> Mechanism::getSwitchableElements() const {
    std::vector<std::string> names;
    for (const Connection& connection : m_connections) names.push_back(connection.name);
    for (const Equation& equation : m_equations) names.push_back(equation.name);
    return names;
}

SimTK::Constraint Mechanism::getConstraint(const std::string& element) const {
    for (const Connection& connection : m_connections)
        if (connection.name == element) {
            if (connection.joint) return connection.joint->getConstraint();
            throw Error(element,
                        "is a mobilizer of the tree and cannot be switched; use the formulation by "
                        "constraints");
        }
    for (const Equation& equation : m_equations)
        if (equation.name == element) return equation.constraint;
    throw Error(element, "does not exist in this mechanism");
}

ElementNames Mechanism::getElementNames() const {
    std::vector<Joint> joints;
    for (const Connection& connection : m_connections)
        if (connection.joint) joints.push_back(*connection.joint);
    ElementNames names = nameElements(joints);
    for (const Equation& equation : m_equations)
        names[equation.constraint.getConstraintIndex()] = {
            equation.name, {"its equation"}, equation.dimension};
    return names;
}

std::vector<ConstraintEquation> Mechanism::findEquations(const State& state) const {
    ElementNames names = getElementNames();
    for (const Connection& connection : m_connections) {
        if (!connection.joint) continue;
        names[connection.joint->getConstraint().getConstraintIndex()].element = connection.name;
    }
    std::vector<ConstraintEquation> equations = jprim::findEquations(getMatter(), state, names);
    std::sort(equations.begin(), equations.end(),
              [](const auto& a, const auto& b) { return a.multiplier < b.multiplier; });
    return equations;
}

}  // namespace jprim
