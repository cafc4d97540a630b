// SPDX-License-Identifier: Apache-2.0
#include "jprim/mechanism/element.h"

#include "jprim/base/error.h"

namespace jprim {

using SimTK::State;

const SimTK::Constraint* Element::getConstraint() const {
    if (const Joint* joint = getJoint()) return &joint->getConstraint();
    return getGeneralConstraint();
}

bool Element::isDisabled(const State& state) const {
    if (const SimTK::Constraint* constraint = getConstraint()) return constraint->isDisabled(state);
    const MarkerForce* force = getForce();
    return force && force->isDisabled(state);
}

void Element::requireSwitchable() const {
    if (handle.index() == 0)
        throw Error(getName(),
                    "is a mobilizer of the tree and cannot be switched; use the formulation by constraints");
}

void Element::disable(State& state) const {
    requireSwitchable();
    if (const SimTK::Constraint* constraint = getConstraint()) constraint->disable(state);
    if (const MarkerForce* force = getForce()) force->disable(state);
}

void Element::enable(State& state) const {
    requireSwitchable();
    if (const SimTK::Constraint* constraint = getConstraint()) constraint->enable(state);
    if (const MarkerForce* force = getForce()) force->enable(state);
}

void ElementList::add(Element element) {
    m_places[element.id] = m_elements.size();
    m_elements.push_back(std::move(element));
}

const Element* ElementList::find(const ElementId& id) const {
    const auto found = m_places.find(id);
    return found == m_places.end() ? nullptr : &m_elements[found->second];
}

std::vector<LoadFunction> ElementList::findLoads(int onMarker, int otherMarker) const {
    std::vector<LoadFunction> loads;
    for (const Element& element : m_elements) {
        if (element.onI && element.i == onMarker && element.j == otherMarker) loads.push_back(element.onI);
        if (element.onJ && element.j == onMarker && element.i == otherMarker) loads.push_back(element.onJ);
    }
    return loads;
}

}  // namespace jprim
