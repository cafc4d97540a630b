// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_JOINT_JOINT_H_
#define JPRIM_JOINT_JOINT_H_

#include <string>
#include <vector>

#include "jprim/general/general_constraint.h"
#include "jprim/primitive/primitives.h"

namespace jprim {

/// A recognisable joint: a bundle of primitives between two markers, with one name and one reaction. The
/// markers' meaning is Adams' (statement JOINT); the z axis is the joint's axis unless noted.
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
/// | Hooke | ATPOINT + PERPENDICULAR on turned markers | 2 rotations; x_I and y_J are the bars |
/// | Convel | ATPOINT + x_I . y_J = y_I . x_J | 2 rotations; the shafts z_I and z_J turn together |
/// | Screw | DZ(I,J,J) = pitch AZ(I,J) / 2 pi + offset | 5: it keeps nothing else |
/// | Rackpin | DZ(I,J,J) = diameter/2 angle + offset | 5; I on the pinion, z_J along the rack's travel |
///
/// Screw and Rackpin count whole turns. The angle of a Rackpin is that of I about z_I, from where x_I points
/// along z_J.
///
/// Each factory adds the primitives to the markers' system and throws Error as they do. A Joint is a value:
/// copies refer to the same constraints.
class Joint {
public:
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
    /// @param diameter  pitch diameter of the pinion
    static Joint Rackpin(const Marker& I, const Marker& J, SimTK::Real diameter, SimTK::Real offset = 0,
                         const std::string& name = "");

    /// A bundle of one, with the primitive's type and name: lets a JPRIM stand where a JOINT does.
    explicit Joint(const Primitive& primitive);

    /// Adams' word for the type: "REVOLUTE".
    const char* getAdamsType() const { return m_adamsType; }
    const std::string& getName() const { return m_name; }

    /// The name and the type, or the type alone: what messages call this joint.
    std::string getDescription() const;

    /// The primitives, the translational one first.
    const std::vector<Primitive>& getPrimitives() const { return m_primitives; }
    /// The equation of a Convel, Screw or Rackpin; of other joints none.
    const std::vector<GeneralConstraint>& getEquations() const { return m_equations; }
    /// All of these, as Simbody's constraints.
    std::vector<SimTK::Constraint> getConstraints() const;

    /// What equation k of the p-th primitive holds, in words and the axes of the joint's markers.
    /// @throws Error if there is no such equation
    std::string describeEquation(int p, int k) const;

    /// Switch all constraints off or on in this State. Requires Stage::Model.
    void disable(SimTK::State& state) const;
    void enable(SimTK::State& state) const;
    /// True if all are off.
    bool isDisabled(const SimTK::State& state) const;

    /// @name Total reaction
    /// Sum over the constraints, [moment, force] acting on the marker's body, in Ground's axes or those of a
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
    Joint(const char* adamsType, const std::string& name, std::vector<Primitive> primitives,
          std::vector<GeneralConstraint> equations = {});

    const char* m_adamsType;
    std::string m_name;
    std::vector<Primitive> m_primitives;
    std::vector<GeneralConstraint> m_equations;
};

}  // namespace jprim

#endif
