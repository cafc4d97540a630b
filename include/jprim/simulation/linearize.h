// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SIMULATION_LINEARIZE_H_
#define JPRIM_SIMULATION_LINEARIZE_H_

#include <complex>
#include <vector>

#include "jprim/mechanism/mechanism.h"

/// @file
/// A system linearised about a State on its constraints: small deviations x obey dx/dt = A x. docs/modes.md has the
/// equations.
namespace jprim {

/// What linearize() finds. States are x = [displacements, changes of speeds, changes of z]: the numPositions directions
/// in which the position constraints let the system move, the numSpeeds in which its speeds can change, and the auxiliary
/// state variables z that have an influence on accelerations.
struct LinearModel {
    SimTK::State state;  ///< the origin, on the constraints; realized to Stage::Acceleration
    int numPositions = 0;
    int numSpeeds = 0;
    std::vector<int> z;  ///< places in the State's getZ()

    SimTK::Matrix A;       ///< n x n [1/s]
    SimTK::Matrix errors;  ///< by how much each entry may be wrong: see linearize()

    /// dz = displacements x, nu x n: what turns x into displacements, as speeds u times a second, dq = N dz.
    SimTK::Matrix displacements;
    /// du = speeds x, nu x n.
    SimTK::Matrix speeds;
    /// The accelerations du/dt at the origin and the rates of z: all 0 in an equilibrium or a steady motion.
    SimTK::Vector uDot, zDot;

    int getNumStates() const { return A.nrow(); }
};

/// Linearises any Simbody system on its constraints, at the State's time: positions move along the tangent space of the
/// position constraints and back onto them, speeds meet the constraints on speeds, and accelerations are Simbody's.
/// Constraints may be redundant; what Motions and locks prescribe stays.
///
/// A is a derivative by central differences with an error of fourth order. `errors` bounds it by the change from steps twice
/// as long; where accelerations have a kink or a jump, as at the contact of an IMPACT, it is as large as what the two
/// sides differ by.
///
/// About a State that moves, A is that of the moment: x is measured in frames that the motion takes along with least
/// turning, relative to each mobilizer's own coordinates. Its eigenvalues tell of stability only if the motion is
/// steady in them: if A stays the same.
/// @param state  realized to Stage::Position at least; not changed
/// @param names  what to call the constraints in messages, see nameElements()
/// @throws Error if the State does not satisfy the constraints to 1e-4 (scaled), its position is singular, or Simbody loses
///         an equation, as it does where masses differ too much
LinearModel linearize(const SimTK::MultibodySystem& system, const SimTK::State& state,
                      const ElementNames& names = {});

/// The same for a mechanism, its equations prepared as for a run: those that no motion changes are left out where there are
/// no others.
LinearModel linearize(const Mechanism& mechanism, const SimTK::State& state);

/// An eigenvalue of a LinearModel and its vector, A x = lambda x. Of a complex pair the one with positive imaginary part.
struct Eigenmode {
    std::complex<double> eigenvalue;  ///< [1/s]
    double error = 0;                 ///< by how much it may be wrong, to first order [1/s]
    /// Not told from 0 by its error: `eigenvalue` is exactly 0. There is one such mode for each independent direction,
    /// while the eigenvalue may be there more often: LinearModes::numZero.
    bool isZero = false;
    std::vector<std::complex<double>> x;  ///< of length 1

    /// |lambda|/(2 pi), what an undamped vibration of the same stiffness and mass has [Hz].
    double getFrequency() const;
    /// -Re lambda/|lambda|: 1 and -1 of real eigenvalues, 0 of 0.
    double getDampingRatio() const;
    /// Grows, beyond doubt: the real part is positive by more than the error.
    bool isUnstable() const;
};

/// All modes, by |lambda| ascending.
struct Eigenmodes {
    std::vector<Eigenmode> modes;
    int numZero = 0;  ///< eigenvalues that are 0; a rigid-body motion has two
};
/// An eigenvalue counts as 0 where it is less than a hundred times its error.
Eigenmodes calcEigenmodes(const LinearModel& model);

}  // namespace jprim

#endif
