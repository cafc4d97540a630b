// SPDX-License-Identifier: Apache-2.0
#include "mechanism/power.h"

namespace jprim {

using SimTK::MobilizedBody;
using SimTK::MobilizedBodyIndex;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;

namespace {

Real calcPotentialRate(const Loads& loads, const State& state) {
    Real rate = 0;
    for (const MarkerForce& force : loads.forces) rate += force.calcPotentialRate(state);
    for (const FlexibleBody& body : loads.flexibleBodies) rate += body.calcElasticEnergyRate(state);
    return rate;
}

}  // namespace

// Weight is taken out body by body, before there is a sum in which it cancels.
Real calcPowerWithoutPotential(const SimTK::MultibodySystem& system, const Loads& loads, const State& state) {
    const SimTK::SimbodyMatterSubsystem& matter = system.getMatterSubsystem();
    const auto& onBodies = system.getRigidBodyForces(state, SimTK::Stage::Dynamics);
    Real power = ~system.getMobilityForces(state, SimTK::Stage::Dynamics) * state.getU();
    for (MobilizedBodyIndex b(1); b < matter.getNumBodies(); ++b) {
        const MobilizedBody& body = matter.getMobilizedBody(b);
        const SimTK::Vec3 weight = body.getBodyMass(state) * loads.gravity;
        const SimTK::Vec3 arm = body.getBodyRotation(state) * body.getBodyMassCenterStation(state);
        power += ~(onBodies[b] - SpatialVec(arm % weight, weight)) * body.getBodyVelocity(state);
    }
    for (const SimTK::Constraint& constraint : loads.constraints)
        if (!constraint.isDisabled(state)) power += constraint.calcPower(state);
    return power + calcPotentialRate(loads, state);
}

}  // namespace jprim
