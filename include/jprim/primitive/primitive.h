// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_PRIMITIVE_PRIMITIVE_H_
#define JPRIM_PRIMITIVE_PRIMITIVE_H_

#include <string>

#include "jprim/primitive/pair_constraint.h"

namespace jprim {

/// What the six joint primitives have in common: one to three equations that are all lengths or all angles.
class Primitive : public TypedConstraint<Primitive, PairConstraint> {
public:
    /// An empty handle; good only to be assigned to.
    Primitive() = default;

    static constexpr const char* ClassName = "Primitive";
    static bool isInstanceOf(const SimTK::Constraint& constraint);

    /// As those of PairConstraint.
    Primitive& setName(const std::string& name);
    Primitive& setDefaultMarkerI(const SimTK::Transform& X);
    Primitive& setDefaultMarkerJ(const SimTK::Transform& X);

    using PairConstraint::isTranslational;
    /// True if the equations are lengths and the reaction is a force; false if they are angles and it is a
    /// torque.
    bool isTranslational() const { return PairConstraint::isTranslational(0); }

    /// Adams' function JPRIM(id, jflag, comp, rm).
    /// @param state  realized to Stage::Acceleration
    /// @param jflag  0: the load on I at I's origin; 1: the load on J at J's origin
    /// @param comp   1 … 8 = FM FX FY FZ TM TX TY TZ
    /// @param rm     marker whose axes to use
    /// @throws Error for any other jflag or comp
    SimTK::Real JPRIM(const SimTK::State& state, int jflag, int comp, const Marker& rm) const;
    /// The same in Ground's axes.
    SimTK::Real JPRIM(const SimTK::State& state, int jflag, int comp) const;

protected:
    static bool isOfType(const SimTK::Constraint& constraint, const char* adamsType);

    /// As PairConstraint, of one kind of equations.
    Primitive(const char* adamsType, const PairEquations& equations, const Marker& I, const Marker& J,
              const std::string& name);
};

}  // namespace jprim

#endif
