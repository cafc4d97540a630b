// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SIMULATION_ASSEMBLE_H_
#define JPRIM_SIMULATION_ASSEMBLE_H_

#include <string>
#include <vector>

#include "jprim/build/mechanism.h"

namespace jprim {

/// By how much position constraints are violated, and by which element most. Lengths here and below are in
/// the mechanism's length unit.
struct Violation {
    SimTK::Real length = 0;  ///< largest error of the translational equations
    SimTK::Real angle = 0;   ///< largest error of the rotational equations [rad]
    std::string element;     ///< with the largest error of either kind; empty if there is none
};

/// A part that assembly moved away from its given pose.
struct MovedPart {
    std::string part;          ///< "PART/3"
    SimTK::Real distance = 0;  ///< of the mass centre
    SimTK::Real angle = 0;     ///< [rad]
};

/// A mechanism with its initial conditions: the assembled State and how it came about.
struct AssembledState {
    SimTK::State state;  ///< realized to Stage::Velocity
    Violation before;    ///< at the given positions
    Violation after;
    std::vector<MovedPart> moved;
};

/// Position-level violation at a State. Requires Stage::Position.
Violation calcViolation(const Mechanism& mechanism, const SimTK::State& state);
/// The same of Mechanism::findEquations(), which stay while no constraint is switched.
Violation calcViolation(const std::vector<ConstraintEquation>& equations, const SimTK::State& state);

/// Finds initial conditions as Adams does.
///
/// Positions: the given ones, if they satisfy the constraints to within AssemblyTolerance; otherwise those
/// that Simbody's Assembler finds closest to them, with the coordinates named by EXACT held. Flexible bodies
/// stay undeformed if the constraints can be met that way.
/// Velocities: the given components are kept where the constraints allow, otherwise met as nearly as can be
/// in the sense of least squares; of all such velocities the smallest, so that what was not given and is not
/// driven by what was stays at rest. Angular velocities count by the part's size. Modes start at rest.
///
/// Coordinates given for joints and motions (IC, ICDISP) are met like EXACT ones.
///
/// @throws Error naming the element that stays violated, if the constraints cannot be met
AssembledState assemble(const Mechanism& mechanism);

/// The same from a State in the course of a run, after constraints were switched on or off: positions close
/// to the present ones, and of the velocities that the constraints allow the nearest.
AssembledState reassemble(const Mechanism& mechanism, const SimTK::State& current);

/// Lengths and angles [rad] of constraint errors up to which given positions are taken as assembled.
constexpr double AssemblyTolerance = 1e-9;

}  // namespace jprim

#endif
