// SPDX-License-Identifier: Apache-2.0
#include "simulation/reaction_watch.h"

#include <algorithm>
#include <stdexcept>

#include "base/format.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;

namespace {

// A moment counts as the force that it is at the distance `size`.
Real calcSize(const SpatialVec& load, Real size) {
    return std::max(load[1].norm(), load[0].norm() / size);
}

// The largest of weight, inertia force, applied and elastic load.
Real calcLargestLoad(const Mechanism& mechanism, const MechanismPart& part, const State& state) {
    const SimTK::MobilizedBody& body = part.body;
    const Real mass = body.getBodyMass(state),
               turning = body.getBodyMassProperties(state).getInertia().trace();
    const SpatialVec &V = body.getBodyVelocity(state), &A = body.getBodyAcceleration(state);
    const SpatialVec inertia(turning * (A[0].norm() + V[0].normSqr()) * SimTK::Vec3(1, 0, 0), mass * A[1]);
    const SpatialVec& applied =
        mechanism.getSystem().getRigidBodyForces(state, SimTK::Stage::Dynamics)[body.getMobilizedBodyIndex()];
    const Real elastic = part.flexible ? 2 * part.flexible->calcElasticEnergy(state) / part.size : 0;
    return std::max({mass * mechanism.getGravity().norm(), calcSize(inertia, part.size),
                     calcSize(applied, part.size), elastic});
}

// The force of an acceleration that is none: what rounding leaves in a mechanism at rest without loads is below it.
Real calcUnnoticedForce(const Mechanism& mechanism, const State& state) {
    constexpr Real Unnoticed = 1e-9;  // length units/s^2
    return Unnoticed * mechanism.getMatter().calcSystemMass(state);
}

}  // namespace

void ReactionWatch::check(const State& state) {
    Real size = 0;
    m_largestLoad = std::max(m_largestLoad, calcUnnoticedForce(m_mechanism, state));
    for (const MechanismPart& part : m_mechanism.getParts()) {
        if (part.ground) continue;
        size = std::max(size, part.size);
        m_largestLoad = std::max(m_largestLoad, calcLargestLoad(m_mechanism, part, state));
    }
    for (const Element& element : m_mechanism.getElements()) {
        if (element.isForce() || !element.onI) continue;
        const SpatialVec reaction = element.onI(state);
        if (calcSize(reaction, size) <= LargestLever * m_largestLoad) continue;
        throw std::runtime_error(fmt::format(
            "the reaction at {} is {:.2g} times as large as any load, weight or inertia force of a part; nothing "
            "explains it",
            element.getName(), calcSize(reaction, size) / m_largestLoad));
    }
}

}  // namespace jprim
