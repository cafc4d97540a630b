// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_JOINT_JOINT_H_
#define JPRIM_JOINT_JOINT_H_

#include <string>
#include <variant>
#include <vector>

#include "jprim/general/general_constraint.h"
#include "jprim/primitive/primitives.h"

namespace jprim {

/// A recognisable joint: the equations of one or two primitives between two markers as one constraint, with one name
/// and one reaction. The markers' meaning is Adams' (statement JOINT); the z axis is the joint's axis unless noted.
///
/// | joint | made of | freedoms left |
/// | --- | --- | --- |
/// | Spherical | ATPOINT | 3 rotations |
/// | Revolute | ATPOINT + PARALLEL_AXES | rotation about z |
/// | Cylindrical | INLINE + PARALLEL_AXES | rotation about and translation along z |
/// | Translational | INLINE + ORIENTATION | translation along z_J |
/// | Planar | INPLANE + PARALLEL_AXES | rotation about z, translation in J's xy plane |
/// | Fixed | ATPOINT + ORIENTATION | none |
/// | Universal | ATPOINT + PERPENDICULAR | 2 rotations; z_I and z_J are the bars of the cross |
/// | Hooke | ATPOINT + x_I . y_J = 0 | 2 rotations; x_I and y_J are the bars |
/// | Convel | ATPOINT + x_I . y_J = y_I . x_J | 2 rotations; the shafts z_I and z_J turn together |
/// | Screw | DZ(I,J,J) = pitch AZ(I,J) / 2 pi + offset | 5: it keeps nothing else |
/// | Rackpin | DZ(I,J,J) = diameter/2 angle + offset | 5; I on the pinion, z_J along the rack's travel |
///
/// A Screw and a Rackpin go on for whole turns, and their travel says how many: the thread or tooth nearest to where
/// I and J are is taken, in every State for itself, so nothing needs to be remembered. The angle of a Rackpin is that
/// of I about z_I, from where x_I points along z_J.
///
/// Of the load on I at I's origin, the force is what the first primitive would carry and the moment what the second
/// would, in all but a Screw and a Rackpin.
///
/// Each factory adds the constraint to the markers' system and throws Error as primitives do. A Joint is a value:
/// copies refer to the same constraint.
class Joint {
public:
    /// No joint; good only to be assigned to.
    Joint() = default;

    static Joint Spherical(const Marker& I, const Marker& J, const std::string& name = "");
    static Joint Revolute(const Marker& I, const Marker& J, const std::string& name = "");
    static Joint Cylindrical(const Marker& I, const Marker& J, const std::string& name = "");
    static Joint Translational(const Marker& I, const Marker& J, const std::string& name = "");
    static Joint Planar(const Marker& I, const Marker& J, const std::string& name = "");
    static Joint Fixed(const Marker& I, const Marker& J, const std::string& name = "");
    static Joint Universal(const Marker& I, const Marker& J, const std::string& name = "");
    static Joint Hooke(const Marker& I, const Marker& J, const std::string& name = "");

    /// @param opposed  z_I and z_J point away from each other, as down the two shafts; the equation is then
    ///                 x_I . y_J = -y_I . x_J, as the other one vanishes where the shafts are in line
    static Joint Convel(const Marker& I, const Marker& J, bool opposed = false, const std::string& name = "");
    /// @param pitch  length per turn; right-hand if positive
    static Joint Screw(const Marker& I, const Marker& J, SimTK::Real pitch, SimTK::Real offset = 0,
                       const std::string& name = "");
    /// @param diameter  pitch diameter of the pinion; it, a pitch or an offset that is not finite is an Error
    static Joint Rackpin(const Marker& I, const Marker& J, SimTK::Real diameter, SimTK::Real offset = 0,
                         const std::string& name = "");

    /// A joint of one primitive, with its type and name: lets a JPRIM stand where a JOINT does.
    explicit Joint(const Primitive& primitive);

    /// @name From a constraint back to the joint
    /// True of what one of the factories above made; the joint that it is.
    ///@{
    static bool isInstanceOf(const SimTK::Constraint& constraint);
    /// @throws Error if it is another kind of constraint
    static Joint downcast(const SimTK::Constraint& constraint);
    ///@}

    /// Adams' word for the type: "REVOLUTE".
    const char* getAdamsType() const;
    const std::string& getName() const;

    /// The name and the type, or the type alone: what messages call this joint.
    std::string getDescription() const;

    /// The constraint, as Simbody's and as what it is: of the two others one is null.
    const SimTK::Constraint& getConstraint() const;
    const PairConstraint* getPairConstraint() const { return std::get_if<PairConstraint>(&m_constraint); }
    /// Of a Screw or a Rackpin.
    const GeneralConstraint* getGeneralConstraint() const {
        return std::get_if<GeneralConstraint>(&m_constraint);
    }

    operator const SimTK::Constraint&() const { return getConstraint(); }

    /// @name As of its constraint
    ///@{
    SimTK::ConstraintIndex getConstraintIndex() const { return getConstraint().getConstraintIndex(); }
    /// Switch the constraint off or on in this State. Requires Stage::Model.
    void disable(SimTK::State& state) const { getConstraint().disable(state); }
    void enable(SimTK::State& state) const { getConstraint().enable(state); }
    bool isDisabled(const SimTK::State& state) const { return getConstraint().isDisabled(state); }
    bool isDisabledByDefault() const { return getConstraint().isDisabledByDefault(); }
    Joint& setDisabledByDefault(bool isDisabled);

    /// Of the equations in use, at the stage that they are about; multipliers at Stage::Acceleration.
    SimTK::Vector getPositionErrorsAsVector(const SimTK::State& state) const {
        return getConstraint().getPositionErrorsAsVector(state);
    }
    SimTK::Vector getVelocityErrorsAsVector(const SimTK::State& state) const {
        return getConstraint().getVelocityErrorsAsVector(state);
    }
    SimTK::Vector getAccelerationErrorsAsVector(const SimTK::State& state) const {
        return getConstraint().getAccelerationErrorsAsVector(state);
    }
    SimTK::Vector getMultipliersAsVector(const SimTK::State& state) const {
        return getConstraint().getMultipliersAsVector(state);
    }
    ///@}

    /// @name Markers
    /// As those of PairConstraint. A Screw and a Rackpin keep the markers they were made with: setting one is an
    /// Error.
    ///@{
    Marker getDefaultMarkerI() const;
    Marker getDefaultMarkerJ() const;
    Joint& setDefaultMarkerI(const SimTK::Transform& X);
    Joint& setDefaultMarkerJ(const SimTK::Transform& X);
    Marker getMarkerI(const SimTK::State& state) const;
    Marker getMarkerJ(const SimTK::State& state) const;
    void setMarkerI(SimTK::State& state, const SimTK::Transform& X) const;
    void setMarkerJ(SimTK::State& state, const SimTK::Transform& X) const;
    ///@}

    /// The turns of a Screw or a Rackpin that its travel asks for, fractions included: [travel - offset]/pitch or
    /// its like, up to the error of the equation; no numbers of other joints. Requires Stage::Position. As
    /// GeneralConstraint::getTurns(): a State needs no others to be set.
    SimTK::Vector getTurns(const SimTK::State& state) const;

    /// @name Reaction
    /// [moment, force] acting on the marker's body, in Ground's axes or those of a
    /// marker; on I at I's origin, on J at J's origin with the lever -r x F_I. Requires Stage::Acceleration.
    ///@{
    SimTK::SpatialVec calcReactionOnI(const SimTK::State& state) const;
    SimTK::SpatialVec calcReactionOnI(const SimTK::State& state, const Marker& axes) const;
    SimTK::SpatialVec calcReactionOnJ(const SimTK::State& state) const;
    SimTK::SpatialVec calcReactionOnJ(const SimTK::State& state, const Marker& axes) const;
    SimTK::SpatialVec calcReactionOnJAtI(const SimTK::State& state) const;
    SimTK::SpatialVec calcReactionOnJAtI(const SimTK::State& state, const Marker& axes) const;

    /// Adams' function JOINT(id, jflag, comp, rm); arguments as for Primitive::JPRIM().
    SimTK::Real JOINT(const SimTK::State& state, int jflag, int comp) const;
    SimTK::Real JOINT(const SimTK::State& state, int jflag, int comp, const Marker& rm) const;
    ///@}

private:
    using Parts = std::vector<const PairEquations*>;
    Joint(const char* adamsType, const Parts& parts, const Marker& I, const Marker& J,
          const std::string& name);
    explicit Joint(const GeneralConstraint& constraint) : m_constraint(constraint) {}
    const PairConstraint& requireMovableMarkers() const;

    std::variant<PairConstraint, GeneralConstraint> m_constraint;
};

}  // namespace jprim

#endif
