// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_FLEXIBLE_FLEXIBLE_BODY_H_
#define JPRIM_FLEXIBLE_FLEXIBLE_BODY_H_

#include <memory>
#include <vector>

#include "SimTKsimbody.h"
#include "jprim/flexible/modal_basis.h"
#include "jprim/simbody_abi.h"

namespace jprim {

class FlexibleNode;

/// How much of the coupling between deformation and rotation a flexible body feels; Adams' words. With the
/// angular velocity w of the body in its own axes, J_k and n_kl as in ModalBasis:
enum class InertiaCoupling {
    /// None: inertia is that of the undeformed body, and rotation does not load the modes.
    Constant,
    /// The terms of first order that depend on velocities: on mode k the force
    /// ~w J_k w / 2 + 2 Sum_l dq_l/dt w.n_kl, on the body the moment
    /// -(Sum_k J_k dq_k/dt w + w x Sum_k J_k q_k w + w x Sum_kl q_k dq_l/dt n_kl).
    Partial
};

struct FlexibleBodyOptions {
    InertiaCoupling coupling = InertiaCoupling::Partial;
    /// Fraction of critical damping of each mode; by calcDefaultDampingRatio() if empty.
    std::vector<SimTK::Real> dampingRatios;
};

/// Adams' default: 1 % of critical below 100 Hz, 10 % below 1 kHz, 100 % from there on.
/// @param frequency  circular, with the second as the unit of time [rad/s]
SimTK::Real calcDefaultDampingRatio(SimTK::Real frequency);

/// A body that deforms little while it moves as far as it likes: a rigid body in the mean axes of the
/// deformation plus modal coordinates, in the State of a Simbody system.
///
///     d2q_k/dt2 + 2 zeta_k w_k dq_k/dt + w_k^2 q_k = load on mode k
///
/// The rigid body has the mesh's frame as its body frame, six freedoms relative to Ground, and the mass, mass
/// centre and inertia of the undeformed structure; it is an ordinary mobilized body. Hang things on it with
/// Markers on its nodes. The basis must be in the system's units, with the second as the unit of time.
///
/// Left out, because it multiplies accelerations by modal coordinates: Sum J_k q_k dw/dt,
/// Sum_l d2q_l/dt2 q_k n_kl and its counterpart on the modes; and changes of the inertia of second order. With
/// Partial coupling and no damping, calcEnergy() + calcCouplingEnergy() changes at the rate
/// ~w (Sum J_k q_k) dw/dt. Stiffening by axial load is in no linear modal body.
///
/// Modal coordinates live on carriers, bodies of Simbody's that move in no space: they have no mass to speak
/// of, feel no gravity and add to no momentum.
///
/// A FlexibleBody is a value: copies refer to the same body. Source: mean-axis formulation after
/// A. A. Shabana, Dynamics of Multibody Systems, 2013, chapter 5.
class FlexibleBody {
public:
    /// No body; good only to be assigned to.
    FlexibleBody() = default;

    /// Adds the body, its carriers and its forces to a system.
    /// @throws Error naming the basis if it has no modes or no inertia, or if the number of damping ratios is
    /// not that of the modes or one is negative
    FlexibleBody(SimTK::SimbodyMatterSubsystem& matter, SimTK::GeneralForceSubsystem& forces,
                 const ModalBasis& basis, const FlexibleBodyOptions& options = {});

    const SimTK::MobilizedBody::Free& getBody() const { return m_body; }
    const ModalBasis& getBasis() const;
    int getNumModes() const;
    const std::vector<SimTK::Real>& getDampingRatios() const;

    /// @name Modal coordinates q and their rates [sqrt(mass) length, per time, per time^2]
    /// Getting requires Stage::Model, of accelerations Stage::Acceleration.
    ///@{
    SimTK::Vector getModalCoordinates(const SimTK::State& state) const;
    SimTK::Vector getModalVelocities(const SimTK::State& state) const;
    SimTK::Vector getModalAccelerations(const SimTK::State& state) const;
    void setModalCoordinates(SimTK::State& state, const SimTK::Vector& q) const;
    void setModalVelocities(SimTK::State& state, const SimTK::Vector& qdot) const;
    /// The mobilized bodies that carry the coordinates, for locking them.
    const std::vector<SimTK::MobilizedBodyIndex>& getCarriers() const;
    ///@}

    /// Strain energy Sum w_k^2 q_k^2 / 2; part of the system's potential energy. Requires Stage::Model.
    SimTK::Real calcElasticEnergy(const SimTK::State& state) const;
    /// Its time derivative Sum w_k^2 q_k dq_k/dt. Requires Stage::Velocity.
    SimTK::Real calcElasticEnergyRate(const SimTK::State& state) const;
    /// ~w (Sum J_k q_k) w / 2: the kinetic energy of Partial coupling that Simbody does not know of; 0 with
    /// Constant. Requires Stage::Velocity.
    SimTK::Real calcCouplingEnergy(const SimTK::State& state) const;
    /// Power that damping takes out. Requires Stage::Model.
    SimTK::Real calcDissipation(const SimTK::State& state) const;

    /// A node as markers see it. @throws Error if the basis has no node with this id
    std::shared_ptr<const FlexibleNode> findNode(int id) const;

private:
    class Data;
    class Forces;

    SimTK::MobilizedBody::Free m_body;
    std::shared_ptr<const Data> m_data;
};

}  // namespace jprim

#endif
