// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_MECHANISM_ELEMENT_H_
#define JPRIM_MECHANISM_ELEMENT_H_

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jprim/base/units.h"
#include "jprim/dataset/element_id.h"
#include "jprim/force/marker_force.h"
#include "jprim/general/general_constraint.h"
#include "jprim/joint/joint.h"

namespace jprim {

/// A load [moment, force] in Ground, at the origin of the marker it acts on. Requires Stage::Acceleration.
using LoadFunction = std::function<SimTK::SpatialVec(const SimTK::State&)>;

/// What acts between markers: a JPRIM, JOINT, GCON, MOTION, COUPLER or force of a dataset.
struct Element {
    ElementId id;
    std::string type;  ///< of a JPRIM or JOINT: "ATPOINT"
    int i = 0;         ///< marker ids; 0 if there is none
    int j = 0;
    /// What it is in the Simbody system: a JPRIM or JOINT a Joint; a GCON, MOTION or COUPLER a GeneralConstraint; a force
    /// a MarkerForce. Nothing if a mobilizer stands for it, or a loop that the tree keeps in a plane leaves it nothing to
    /// do: PARALLEL_AXES, INPLANE or PLANAR, where a hinge or ball is an INLINE.
    std::variant<std::monostate, Joint, GeneralConstraint, MarkerForce> handle;
    bool inTree = false;                     ///< a mobilizer stands for it
    Dimension dimension = Dimension::Angle;  ///< of a GeneralConstraint's error
    bool doesWork = false;                   ///< it may change the energy, beside its potential
    LoadFunction onI;                        ///< its load on its markers; empty if there is none to tell
    LoadFunction onJ;

    [[nodiscard]] std::string getName() const { return id.getText(); }
    [[nodiscard]] bool isForce() const { return !isConstraint(id.kind); }

    [[nodiscard]] const Joint* getJoint() const { return std::get_if<Joint>(&handle); }
    [[nodiscard]] const GeneralConstraint* getGeneralConstraint() const {
        return std::get_if<GeneralConstraint>(&handle);
    }
    [[nodiscard]] const MarkerForce* getForce() const { return std::get_if<MarkerForce>(&handle); }
    /// Its constraint in the Simbody system, if it has one.
    [[nodiscard]] const SimTK::Constraint* getConstraint() const;

    /// @name Switching
    /// Off, it puts no load on anything. What has nothing in the Simbody system is on for good.
    ///@{
    [[nodiscard]] bool isDisabled(const SimTK::State& state) const;
    /// @throws Error if a mobilizer stands for the element
    void requireSwitchable() const;
    /// @throws Error as requireSwitchable()
    void disable(SimTK::State& state) const;
    void enable(SimTK::State& state) const;
    ///@}
};

/// Elements in the order in which they were added; each is found by its id.
class ElementList {
public:
    void add(Element element);

    [[nodiscard]] const Element* find(const ElementId& id) const;
    [[nodiscard]] std::size_t size() const { return m_elements.size(); }
    [[nodiscard]] const Element& operator[](std::size_t place) const { return m_elements[place]; }
    [[nodiscard]] auto begin() const { return m_elements.begin(); }
    [[nodiscard]] auto end() const { return m_elements.end(); }

    /// The loads on a marker of all elements between it and another; 0 stands for no marker.
    [[nodiscard]] std::vector<LoadFunction> findLoads(int onMarker, int otherMarker) const;

private:
    std::vector<Element> m_elements;
    std::map<ElementId, std::size_t> m_places;
};

}  // namespace jprim

#endif
