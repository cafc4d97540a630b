// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_PRIMITIVE_PAIR_CONSTRAINT_H_
#define JPRIM_PRIMITIVE_PAIR_CONSTRAINT_H_

#include <string>
#include <vector>

#include "jprim/marker/marker.h"
#include "jprim/marker/typed_handle.h"

namespace jprim {

class PairConstraintImpl;
class PairEquations;

/// What a primitive and a joint have in common: equations between two markers, a name and reactions. It is an
/// ordinary SimTK::Constraint; disable(), enable(), getPositionErrorsAsVector() and the rest work as
/// Simbody says. A handle holds no data and may be copied freely.
///
/// Reactions are loads [moment, force] **acting on the marker's body**, expressed in Ground unless a marker
/// is given whose axes to use. They need Stage::Acceleration and are zero while the constraint is disabled.
/// The load on J is equal and opposite to the load on I; at J's origin it carries the lever:
/// M_J = -M_I - r x F_I with r from J's origin to I's. Source: Adams/Solver C++, statement JPRIM.
class PairConstraint : public TypedConstraint<PairConstraint, SimTK::Constraint::Custom> {
public:
    /// An empty handle; good only to be assigned to.
    PairConstraint() = default;

    static constexpr const char* ClassName = "PairConstraint";
    static bool isInstanceOf(const SimTK::Constraint& constraint);

    /// @name Identity
    /// The name appears in every message, e.g. "JPRIM/12". Changing it does not touch the topology.
    ///@{
    const std::string& getName() const;
    PairConstraint& setName(const std::string& name);
    /// Adams' word for the type: "INLINE", "REVOLUTE".
    const char* getAdamsType() const;
    /// The name and the type, or the type alone: what messages call this constraint.
    std::string getDescription() const;
    /// Number of equations, 1 to 6.
    int getNumEquations() const;
    /// What equation k = 0, 1 … holds, in words and the axes of the markers: "translation of I along Xj",
    /// "rotation between Zi and Xj" for the angle between these two axes.
    /// @throws Error if there is no such equation
    std::string describeEquation(int k) const;
    /// True if equation k is a length and its load a force, false if it is an angle and its load a torque.
    /// @throws Error as above
    bool isTranslational(int k) const;
    ///@}

    /// @name Markers
    /// A marker's body or node is fixed at construction. Its pose on that (X: X_BM, or X_NM of a flexible
    /// marker) has a default, which belongs to the topology, and a value in each State, which belongs to
    /// Stage::Position: setting it needs Stage::Topology and no rebuilding. A changed pose may violate the
    /// constraint; assemble again. A pose that is not finite is an Error.
    ///@{
    Marker getDefaultMarkerI() const;
    Marker getDefaultMarkerJ() const;
    PairConstraint& setDefaultMarkerI(const SimTK::Transform& X);
    PairConstraint& setDefaultMarkerJ(const SimTK::Transform& X);
    Marker getMarkerI(const SimTK::State& state) const;
    Marker getMarkerJ(const SimTK::State& state) const;
    void setMarkerI(SimTK::State& state, const SimTK::Transform& X) const;
    void setMarkerJ(SimTK::State& state, const SimTK::Transform& X) const;
    ///@}

    /// @name Single equations
    /// An equation k = 0, 1 … that follows from other constraints can be dropped in a State: it then holds
    /// nothing and carries no load, be it the only one of a system. Dropping and restoring need Stage::Topology
    /// and change Stage::Position. All throw Error if there is no such equation.
    ///@{
    void dropEquation(SimTK::State& state, int k) const;
    void restoreEquation(SimTK::State& state, int k) const;
    bool isEquationDropped(const SimTK::State& state, int k) const;
    /// A factor of the equation's error, rate and acceleration as Simbody gets them (getQErr() and so on), by default
    /// 1; its multiplier is divided by it. Motion and reactions stay as they are, but Simbody tells dependent equations
    /// by the size of all in use: scaled by the root of the mass that an equation moves they are of one size. 0 drops
    /// the equation, and restoring it sets 1. Needs Stage::Topology and changes Stage::Position.
    /// @throws Error also if the scale is negative or not finite
    void setEquationScale(SimTK::State& state, int k, SimTK::Real scale) const;
    SimTK::Real getEquationScale(const SimTK::State& state, int k) const;
    /// The error e_k [length or rad], also of a dropped equation. Requires Stage::Position.
    SimTK::Real calcEquationError(const SimTK::State& state, int k) const;
    ///@}

    /// @name Reactions
    ///@{
    /// On I, at I's origin.
    SimTK::SpatialVec calcReactionOnI(const SimTK::State& state) const;
    SimTK::SpatialVec calcReactionOnI(const SimTK::State& state, const Marker& axes) const;
    /// On J, at J's origin: [-M_I - r x F_I, -F_I].
    SimTK::SpatialVec calcReactionOnJ(const SimTK::State& state) const;
    SimTK::SpatialVec calcReactionOnJ(const SimTK::State& state, const Marker& axes) const;
    /// On J's body, at the point that is now under I's origin: [-M_I, -F_I].
    SimTK::SpatialVec calcReactionOnJAtI(const SimTK::State& state) const;
    SimTK::SpatialVec calcReactionOnJAtI(const SimTK::State& state, const Marker& axes) const;
    ///@}

protected:
    /// Adds the equations of one primitive, or of a translational and a rotational one, as one constraint to the matter
    /// subsystem of the markers.
    /// @throws Error, naming the constraint, if a marker is on no body, if both markers are on one body or if
    ///         their bodies belong to different systems
    PairConstraint(const char* adamsType, const std::vector<const PairEquations*>& equations, const Marker& I,
                   const Marker& J, const std::string& name);

private:
    friend class Joint;
    const PairConstraintImpl& getImpl() const;
    PairConstraintImpl& updImpl();
};

}  // namespace jprim

#endif
