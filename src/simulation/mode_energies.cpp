// SPDX-License-Identifier: Apache-2.0
#include "simulation/mode_energies.h"

#include <algorithm>
#include <cmath>

#include "linear_algebra/conversion.h"

namespace jprim {

using SimTK::MobilizedBodyIndex;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;

namespace {

constexpr Real Difference = 1e-5;  // of loads, on motions of size 1

void divideBySum(std::vector<EnergyShares>& shares, double EnergyShares::*energy) {
    double sum = 0;
    for (const EnergyShares& share : shares) sum += std::abs(share.*energy);
    for (EnergyShares& share : shares) share.*energy = sum > 0 ? share.*energy / sum : 0;
}

}  // namespace

ModeEnergies::ModeEnergies(const Mechanism& mechanism, const State& state)
    : m_mechanism(mechanism),
      m_matter(mechanism.getMatter()),
      m_state(state),
      m_partOfBody(size_t(mechanism.getMatter().getNumBodies()), -1) {
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        const int place = int(m_names.size());
        m_names.push_back(part.name);
        m_partOfBody[size_t(part.body.getMobilizedBodyIndex())] = place;
        if (!part.flexible) continue;
        for (const MobilizedBodyIndex carrier : part.flexible->getCarriers())
            m_partOfBody[size_t(carrier)] = place;
    }
    // What is welded to a part, to give it its inertia, is the part.
    for (MobilizedBodyIndex b(1); b < m_matter.getNumBodies(); ++b) {
        const auto parent = m_matter.getMobilizedBody(b).getParentMobilizedBody().getMobilizedBodyIndex();
        if (m_partOfBody[size_t(b)] < 0) m_partOfBody[size_t(b)] = m_partOfBody[size_t(parent)];
    }
    for (const Element& element : mechanism.getElements()) {
        const MarkerForce* force = element.getForce();
        if (!force || element.isDisabled(state)) continue;
        m_forces.emplace_back(m_names.size(), *force);
        m_names.push_back(element.getName());
    }
}

std::vector<EnergyShares> ModeEnergies::calcShares(const Eigen::VectorXcd& z,
                                                   const Eigen::VectorXcd& u) const {
    std::vector<EnergyShares> shares;
    for (const std::string& name : m_names) shares.push_back({name});
    addEnergies(toSimTK(z.real()), toSimTK(u.real()), shares);
    addEnergies(toSimTK(z.imag()), toSimTK(u.imag()), shares);
    for (const auto energy : {&EnergyShares::kinetic, &EnergyShares::strain, &EnergyShares::dissipated})
        divideBySum(shares, energy);
    return shares;
}

void ModeEnergies::addEnergies(const Vector& z, const Vector& u, std::vector<EnergyShares>& sums) const {
    addKinetic(u, sums);
    addFlexible(z, u, sums);
    addForces(z, u, sums);
}

void ModeEnergies::addKinetic(const Vector& u, std::vector<EnergyShares>& sums) const {
    Motion V;
    m_matter.multiplyBySystemJacobian(m_state, u, V);
    for (MobilizedBodyIndex b(1); b < m_matter.getNumBodies(); ++b) {
        if (m_partOfBody[size_t(b)] < 0) continue;
        const SimTK::SpatialInertia M = m_matter.getMobilizedBody(b).getBodySpatialInertiaInGround(m_state);
        sums[size_t(m_partOfBody[size_t(b)])].kinetic += ~V[b] * (M * V[b]) / 2;
    }
}

// Both are exact: squares of modal coordinates and of their rates, and Sum w^2 (q0 + dq)^2/2 has the mean of both sides.
void ModeEnergies::addFlexible(const Vector& z, const Vector& u, std::vector<EnergyShares>& sums) const {
    const State ahead = displace(z, 1), behind = displace(z, -1);
    const State faster = hasten(u, 1), slower = hasten(u, -1);
    for (const MechanismPart& part : m_mechanism.getParts()) {
        if (!part.flexible) continue;
        EnergyShares& sum = sums[size_t(m_partOfBody[size_t(part.body.getMobilizedBodyIndex())])];
        const auto calcSquare = [&](const State& a, const State& b,
                                    Real (FlexibleBody::*calc)(const State&) const) {
            return ((*part.flexible.*calc)(a) + (*part.flexible.*calc)(b)) / 2 -
                   (*part.flexible.*calc)(m_state);
        };
        sum.strain += calcSquare(ahead, behind, &FlexibleBody::calcElasticEnergy);
        sum.dissipated += calcSquare(faster, slower, &FlexibleBody::calcDissipation);
    }
}

void ModeEnergies::addForces(const Vector& z, const Vector& u, std::vector<EnergyShares>& sums) const {
    if (m_forces.empty()) return;
    const Real size = z.normInf(), speed = u.normInf();
    const SimTK::MultibodySystem& system = m_mechanism.getSystem();
    if (size > 0) {
        const State ahead = displace(z, Difference / size), behind = displace(z, -Difference / size);
        for (const State* state : {&ahead, &behind}) system.realize(*state, Stage::Velocity);
        for (const auto& [place, force] : m_forces)
            sums[place].strain -= calcWork(force, ahead, behind, z) * size / (4 * Difference);
    }
    if (speed > 0) {
        const State ahead = hasten(u, Difference / speed), behind = hasten(u, -Difference / speed);
        for (const State* state : {&ahead, &behind}) system.realize(*state, Stage::Velocity);
        for (const auto& [place, force] : m_forces)
            sums[place].dissipated -= calcWork(force, ahead, behind, u) * speed / (2 * Difference);
    }
}

State ModeEnergies::displace(const Vector& z, Real factor) const {
    State state = m_state;
    Vector change;
    m_matter.multiplyByN(m_state, false, factor * z, change);
    state.updQ() += change;
    return state;
}

State ModeEnergies::hasten(const Vector& u, Real factor) const {
    State state = m_state;
    state.updU() += factor * u;
    return state;
}

// Of the difference of its loads, on a motion at the State itself.
double ModeEnergies::calcWork(const MarkerForce& force, const State& ahead, const State& behind,
                              const Vector& motion) const {
    Motion loads, earlier, V;
    SimTK::Vector_<Vec3> onParticles;
    Vector onMobilities, earlierOnMobilities;
    force.calcForceContribution(ahead, loads, onParticles, onMobilities);
    force.calcForceContribution(behind, earlier, onParticles, earlierOnMobilities);
    m_matter.multiplyBySystemJacobian(m_state, motion, V);
    double work = ~(onMobilities - earlierOnMobilities) * motion;
    for (int b = 1; b < V.size(); ++b) work += ~(loads[b] - earlier[b]) * V[b];
    return work;
}

}  // namespace jprim
