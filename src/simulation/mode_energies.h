// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_MODE_ENERGIES_H_
#define JPRIM_SRC_SIMULATION_MODE_ENERGIES_H_

#include <Eigen/Core>

#include "jprim/simulation/linear_modes.h"

namespace jprim {

/// The energies of small motions about a State, by part and force element.
///
///     kinetic       ~V M V/2 of each body
///     strain        -(change of a load with positions) . displacement/2
///     dissipated    -(change of a load with velocities) . velocity
///
/// Loads act on bodies, at their mass centres, so that what they say does not depend on the coordinates.
class ModeEnergies {
public:
    /// @param state  realized to Stage::Acceleration
    ModeEnergies(const Mechanism& mechanism, const SimTK::State& state);

    /// Of complex displacements z and changes of speeds u, averaged over a period.
    std::vector<EnergyShares> calcShares(const Eigen::VectorXcd& z, const Eigen::VectorXcd& u) const;

private:
    using Motion = SimTK::Vector_<SimTK::SpatialVec>;

    void addEnergies(const SimTK::Vector& z, const SimTK::Vector& u, std::vector<EnergyShares>& sums) const;
    void addKinetic(const SimTK::Vector& u, std::vector<EnergyShares>& sums) const;
    void addFlexible(const SimTK::Vector& z, const SimTK::Vector& u, std::vector<EnergyShares>& sums) const;
    void addForces(const SimTK::Vector& z, const SimTK::Vector& u, std::vector<EnergyShares>& sums) const;
    SimTK::State displace(const SimTK::Vector& z, SimTK::Real factor) const;
    SimTK::State hasten(const SimTK::Vector& u, SimTK::Real factor) const;
    double calcWork(const MarkerForce& force, const SimTK::State& ahead, const SimTK::State& behind,
                    const SimTK::Vector& motion) const;

    const Mechanism& m_mechanism;
    const SimTK::SimbodyMatterSubsystem& m_matter;
    const SimTK::State& m_state;
    std::vector<int> m_partOfBody;                              // place among shares; -1 of Ground
    std::vector<std::pair<std::size_t, MarkerForce>> m_forces;  // with their places
    std::vector<std::string> m_names;
};

}  // namespace jprim

#endif
