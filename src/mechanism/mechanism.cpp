// SPDX-License-Identifier: Apache-2.0
#include "jprim/mechanism/mechanism.h"

#include <algorithm>

#include "base/format.h"
#include "jprim/base/error.h"
#include "jprim/marker/load.h"
#include "mechanism/control/control_variables.h"
#include "mechanism/mechanism_contents.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;
using SimTK::Transform;

bool MechanismContents::isConservative() const {
    for (const Element& element : elements)
        if (element.doesWork) return false;
    for (const MechanismPart& part : parts)
        if (part.flexible)
            for (const Real ratio : part.flexible->getDampingRatios())
                if (ratio > 0) return false;
    return true;
}

const Marker& MechanismContents::getMarker(int id) const {
    const auto found = markers.find(id);
    if (found == markers.end()) throw Error(fmt::format("MARKER/{}", id), "does not exist in this mechanism");
    return found->second;
}

Mechanism::Mechanism(std::unique_ptr<const MechanismContents> contents) : m_contents(std::move(contents)) {}
Mechanism::Mechanism(Mechanism&&) noexcept = default;
Mechanism& Mechanism::operator=(Mechanism&&) noexcept = default;
Mechanism::~Mechanism() = default;

const UnitSystem& Mechanism::getUnits() const {
    return m_contents->units;
}

double Mechanism::getLengthUnit() const {
    return m_contents->lengthUnit;
}

const std::string& Mechanism::getTitle() const {
    return m_contents->title;
}

const SimTK::Vec3& Mechanism::getGravity() const {
    return m_contents->gravity;
}

const SimTK::MultibodySystem& Mechanism::getSystem() const {
    return m_contents->system;
}

const SimTK::SimbodyMatterSubsystem& Mechanism::getMatter() const {
    return m_contents->matter;
}

const std::vector<MechanismPart>& Mechanism::getParts() const {
    return m_contents->parts;
}

const ElementList& Mechanism::getElements() const {
    return m_contents->elements;
}

const Element& Mechanism::getElement(const ElementId& id) const {
    const Element* element = m_contents->elements.find(id);
    if (!element) throw Error(id.getText(), "does not exist in this mechanism");
    return *element;
}

const std::vector<InitialCoordinate>& Mechanism::getInitialCoordinates() const {
    return m_contents->initialCoordinates;
}

const std::vector<MechanismRequest>& Mechanism::getRequests() const {
    return m_contents->requests;
}

const std::vector<MechanismSensor>& Mechanism::getSensors() const {
    return m_contents->sensors;
}

const std::vector<MechanismState>& Mechanism::getStates() const {
    return m_contents->states;
}

Real Mechanism::getSensorValue(const State& state, size_t k) const {
    return m_contents->control->getSensorValue(state, k);
}

void Mechanism::setSensorValue(State& state, size_t k, Real value) const {
    m_contents->control->setSensorValue(state, k, value);
}

const Marker& Mechanism::getMarker(int id) const {
    return m_contents->getMarker(id);
}

bool Mechanism::isConservative() const {
    return m_contents->isConservative();
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
                             parent < 0 ? Transform() : getParts()[size_t(parent)].calcGivenBodyPose(),
                             part.calcGivenBodyPose());
}

void Mechanism::fitPoses(const std::vector<Transform>& poses, State& state) const {
    for (size_t k = 0; k < getParts().size(); ++k) {
        const int parent = getParts()[k].attachment.parent;
        if (getParts()[k].ground) continue;
        getParts()[k].body.setQToFitTransform(
            state, calcMobilizerPose(state, getParts()[k], parent < 0 ? Transform() : poses[size_t(parent)],
                                     poses[k]));
    }
}

State Mechanism::makeGivenState() const {
    State state = getSystem().realizeTopology();
    getSystem().realizeModel(state);
    std::vector<Transform> poses;
    for (const MechanismPart& part : getParts()) poses.push_back(part.calcGivenBodyPose());
    fitPoses(poses, state);
    return state;
}

std::optional<Mechanism> Mechanism::makeWithFreeParts() const {
    if (!m_contents->makeWithFreeParts) return std::nullopt;
    return m_contents->makeWithFreeParts();
}

Real Mechanism::calcKineticEnergy(const State& state) const {
    Real sum = getSystem().calcKineticEnergy(state);
    for (const MechanismPart& part : getParts())
        if (part.flexible) sum += part.flexible->calcCouplingEnergy(state);
    return sum;
}

Real Mechanism::calcEnergyBalance(const State& state) const {
    const Real potential = getSystem().calcPotentialEnergy(state);
    if (!m_contents->work) return calcKineticEnergy(state) + potential;
    return getSystem().calcKineticEnergy(state) + potential - m_contents->work->getWork(state);
}

Real Mechanism::calcReaction(const State& state, const ElementId& id, int jflag, int comp, int rm) const {
    const Element& element = getElement(id);
    const Marker& axes = getMarker(rm);
    const Real value =
        getReactionComponent(expressLoadIn(state, element.onI(state), axes),
                             expressLoadIn(state, element.onJ(state), axes), jflag, comp, id.getText());
    const Real L = getLengthUnit();
    return value * (comp <= 4 ? L : L * L);  // to N or N m
}

Real Mechanism::calcJPRIM(const State& state, int id, int jflag, int comp, int rm) const {
    return calcReaction(state, {ElementKind::Jprim, id}, jflag, comp, rm);
}

Real Mechanism::calcJOINT(const State& state, int id, int jflag, int comp, int rm) const {
    return calcReaction(state, {ElementKind::Joint, id}, jflag, comp, rm);
}

ElementNames Mechanism::getElementNames() const {
    std::vector<Joint> joints;
    for (const Element& element : getElements())
        if (const Joint* joint = element.getJoint()) joints.push_back(*joint);
    ElementNames names = nameElements(joints);
    for (const Element& element : getElements())
        if (const GeneralConstraint* constraint = element.getGeneralConstraint())
            names[constraint->getConstraintIndex()] = {
                element.getName(), {"its equation"}, element.dimension};
    return names;
}

std::vector<ConstraintEquation> Mechanism::findEquations(const State& state) const {
    ElementNames names = getElementNames();
    for (const Element& element : getElements())
        if (const Joint* joint = element.getJoint())
            names[joint->getConstraintIndex()].element = element.getName();
    std::vector<ConstraintEquation> equations = jprim::findEquations(getMatter(), state, names);
    std::sort(equations.begin(), equations.end(),
              [](const auto& a, const auto& b) { return a.multiplier < b.multiplier; });
    return equations;
}

}  // namespace jprim
