// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_FORCE_MARKER_FORCE_H_
#define JPRIM_FORCE_MARKER_FORCE_H_

#include <optional>
#include <string>

#include "jprim/marker/expression.h"
#include "jprim/marker/typed_handle.h"

namespace jprim {

class MarkerForceImpl;

/// What a MarkerForce puts on marker I. Vectors in Ground's axes, in the system's units; what is left out is
/// zero.
struct ForceLaw {
    std::optional<Expression> force;   ///< at I's origin
    std::optional<Expression> moment;  ///< about I's origin
    /// The potential energy of that in the load which has one: a scalar of positions. Simbody adds it to the system's.
    std::optional<Expression> potential;
};

/// A load given by expressions between two markers on any bodies, rigid or flexible: what Adams' SFORCE,
/// VFORCE, VTORQUE, GFORCE, SPRINGDAMPER and BUSHING are made of. The opposite load acts on J's body at the
/// place where I's origin is; at J's origin it is [-M_I - r x F_I, -F_I] with r from J to I. Without J there
/// is no reaction. An ordinary SimTK::Force; the handle holds no data and may be copied freely.
class MarkerForce : public TypedForce<MarkerForce> {
public:
    /// An empty handle; good only to be assigned to.
    MarkerForce() = default;

    static constexpr const char* ClassName = "MarkerForce";
    static bool isInstanceOf(const SimTK::Force& force);

    /// @throws Error, naming the force, if a law's force or moment is not a vector or its potential not a
    ///         scalar of positions, if the law depends on accelerations or reactions, or if a marker, of the law too,
    ///         is on no body or in another system than the forces
    MarkerForce(SimTK::GeneralForceSubsystem& forces, const Marker& I, const std::optional<Marker>& J,
                const ForceLaw& law, const std::string& name = "");

    const std::string& getName() const;
    /// What messages call this element: its name, or "force".
    std::string getDescription() const;

    /// The load [moment, force] on I at I's origin and on J at J's, in Ground; zero if the force is disabled.
    /// Requires Stage::Velocity.
    SimTK::SpatialVec calcLoadOnI(const SimTK::State& state) const;
    SimTK::SpatialVec calcLoadOnJ(const SimTK::State& state) const;

    /// The time derivative of the potential energy, 0 without one or if the force is disabled. Requires
    /// Stage::Velocity.
    SimTK::Real calcPotentialRate(const SimTK::State& state) const;

    /// @name Turns
    /// How far the angles AX, AY and AZ in the law's force, moment and potential have turned, one after the other, as
    /// GeneralConstraint has them. They are remembered, also while the force is disabled: a State to which nothing
    /// but q and u is copied has to be given them too.
    ///@{
    SimTK::Vector getTurns(const SimTK::State& state) const;
    void setTurns(SimTK::State& state, const SimTK::Vector& turns) const;
    void resetTurns(SimTK::State& state) const;
    ///@}

private:
    explicit MarkerForce(SimTK::GeneralForceSubsystem& forces, MarkerForceImpl* implementation);
    const MarkerForceImpl& getImpl() const;
};

}  // namespace jprim

#endif
