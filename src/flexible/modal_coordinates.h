// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_MODAL_COORDINATES_H_
#define JPRIM_SRC_FLEXIBLE_MODAL_COORDINATES_H_

#include <vector>

#include "SimTKsimbody.h"

namespace jprim {

/// Modal coordinates in a State, eta = q / scale, on consecutive carriers.
///
/// A carrier is a mobilized body whose mobilities move nothing: its pose is the identity whatever its
/// coordinates are, and a mobility's "velocity" is an angular velocity Spin times as large, of a body with
/// Spin^2 times less inertia than the modal mass. The kinetic energy is right, and the angular momentum that
/// Simbody adds up is less by the factor Spin. Scale and Spin are powers of 2, so that nothing is rounded.
///
/// The scale is near the square root of the body's mass: eta is then about the deformation itself, and the
/// absolute tolerances of integrators mean the same for it as for other lengths.
class ModalCoordinates {
public:
    ModalCoordinates() = default;
    ModalCoordinates(SimTK::SimbodyMatterSubsystem& matter, int numModes, SimTK::Real bodyMass);

    int getNumModes() const { return m_numModes; }
    SimTK::Real getScale() const { return m_scale; }
    const std::vector<SimTK::MobilizedBodyIndex>& getCarriers() const { return m_carriers; }

    /// The first of numModes consecutive values. Requires Stage::Model.
    const SimTK::Real* getEta(const SimTK::State& state) const;
    const SimTK::Real* getEtaDot(const SimTK::State& state) const;
    const SimTK::Real* getEtaDotDot(const SimTK::State& state) const;  ///< Stage::Acceleration
    SimTK::Real* updEta(SimTK::State& state) const;
    SimTK::Real* updEtaDot(SimTK::State& state) const;
    SimTK::UIndex getFirstUIndex(const SimTK::State& state) const;

private:
    SimTK::MobilizedBody m_first;
    std::vector<SimTK::MobilizedBodyIndex> m_carriers;
    int m_numModes = 0;
    SimTK::Real m_scale = 1;
};

}  // namespace jprim

#endif
