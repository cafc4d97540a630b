// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SIMULATION_LINEAR_MODES_H_
#define JPRIM_SIMULATION_LINEAR_MODES_H_

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "jprim/simulation/linearize.h"

namespace jprim {

/// How a part moves in a mode: complex amplitudes, in Ground's axes. The motion is their product with exp(lambda t), real
/// part.
struct PartShape {
    std::string part;                                 ///< "PART/3"
    std::array<std::complex<double>, 3> translation;  ///< of the mass centre [dataset's unit of length]
    std::array<std::complex<double>, 3> rotation;     ///< [rad]
};

/// What a part or element has of a mode's energies, averaged over a period, of the sum of their absolute values; 0 where
/// there is none.
struct EnergyShares {
    std::string element;  ///< "PART/3", "SPRINGDAMPER/1"
    double kinetic = 0;   ///< of the motions beside that of the State
    double strain = 0;    ///< work against the changes of a force with positions; negative if it drives apart
    double dissipated = 0;  ///< power against its changes with velocities; negative if it feeds the mode
};

/// A mode of a mechanism. Scaled so that its largest displacement is 1: of the components of translations of mass
/// centres, and of rotations times MechanismPart::size, the largest, which also has phase 0.
struct LinearMode : Eigenmode {
    std::vector<PartShape> shape;      ///< of all parts but ground, in their order
    std::vector<EnergyShares> shares;  ///< parts, then forces
    std::string largestPart;           ///< with the largest displacement; empty if nothing moves
};

/// The modes of a mechanism about a State.
struct LinearModes {
    double time = 0;  ///< [dataset's unit]
    int numStates = 0;
    int numZero = 0;           ///< eigenvalues that are 0
    double relativeError = 0;  ///< the largest of A's errors, of what is largest in its column
    /// Where the State is no equilibrium and no steady motion: the part with the largest acceleration, by which speeds
    /// change, of its mass centre or times its size [dataset's unit of length/unit of time^2]. Empty and 0 if that is
    /// less than a millionth of gravity and of what a vibration of the part's size would have.
    std::string acceleratedPart;
    double acceleration = 0;
    bool isMoving = false;  ///< the State has speeds
    std::vector<LinearMode> modes;
};

/// Linearises a mechanism about a State (linearize()) and finds its modes: what Adams' LINEAR/EIGENSOL does.
/// @param state  realized to Stage::Position at least
/// @throws Error as linearize() does
LinearModes calcLinearModes(const Mechanism& mechanism, const SimTK::State& state);

}  // namespace jprim

#endif
