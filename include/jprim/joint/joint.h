// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_JOINT_JOINT_H_
#define JPRIM_JOINT_JOINT_H_

#include <string>
#include <vector>

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

    /// A bundle of one, with the primitive's type and name: lets a JPRIM stand where a JOINT does.
    explicit Joint(const Primitive& primitive);

    /// Adams' word for the type: "REVOLUTE".
    const char* getAdamsType() const { return m_adamsType; }
    const std::string& getName() const { return m_name; }

    /// The name and the type, or the type alone: what messages call this joint.
    std::string getDescription() const;

    /// The primitives, the translational one first.
    const std::vector<Primitive>& getPrimitives() const { return m_primitives; }

    /// Switch all primitives off or on in this State. Requires Stage::Model.
    void disable(SimTK::State& state) const;
    void enable(SimTK::State& state) const;
    /// True if all primitives are off.
    bool isDisabled(const SimTK::State& state) const;

    /// @name Total reaction
    /// Sum over the primitives, [moment, force] acting on the marker's body, in Ground's axes or those of a
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
    Joint(const char* adamsType, const std::string& name, std::vector<Primitive> primitives);

    const char* m_adamsType;
    std::string m_name;
    std::vector<Primitive> m_primitives;
};

}  // namespace jprim

#endif
