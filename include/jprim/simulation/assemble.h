// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SIMULATION_ASSEMBLE_H_
#define JPRIM_SIMULATION_ASSEMBLE_H_

#include <set>
#include <string>
#include <vector>

#include "jprim/base/error.h"
#include "jprim/mechanism/mechanism.h"

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

/// A coordinate given for the start that an assembled position does not have.
struct MissedCoordinate {
    std::string element;     ///< "PART/3", "JOINT/2"
    std::string coordinate;  ///< "EXACT PSI", "initial value"
    SimTK::Real amount = 0;  ///< by which it is missed [length unit or rad]
    Dimension dimension = Dimension::Angle;
};

/// "0.524 rad", or a length in units of the dataset: "3 length units".
[[nodiscard]] std::string formatAmount(const MissedCoordinate& missed, const UnitSystem& units);

/// A mechanism with its initial conditions: the assembled State and how it came about.
struct AssembledState {
    SimTK::State state;  ///< realized to Stage::Velocity
    Violation before;    ///< at the given positions
    Violation after;
    std::vector<MovedPart> moved;
    std::vector<MissedCoordinate> yielded;  ///< EXACT coordinates that could not be held
    /// Redundant equations that contradict others by what was rounded in the dataset's numbers, see analyzeConstraints().
    /// They are dropped in the State; `after` has their errors.
    std::vector<ConstraintEquation> leftOut;
};

/// Positions that cannot be assembled. The message names what is missed most.
class AssemblyError : public Error {
public:
    AssemblyError(const std::string& element, const std::string& message,
                  std::vector<MissedCoordinate> missed, const SimTK::State& nearest)
        : Error(element, message), m_missed(std::move(missed)), m_nearest(nearest) {}

    /// The given coordinates that are in the way, the worst first; empty if the constraints alone cannot be met.
    const std::vector<MissedCoordinate>& getMissed() const { return m_missed; }
    /// The best position found, of the mechanism in Formulation::Constraints.
    const SimTK::State& getNearest() const { return m_nearest; }

private:
    std::vector<MissedCoordinate> m_missed;
    SimTK::State m_nearest;
};

/// Position-level violation at a State. Requires Stage::Position.
[[nodiscard]] Violation calcViolation(const Mechanism& mechanism, const SimTK::State& state);
/// The same of Mechanism::findEquations(), which stay while no constraint is switched.
[[nodiscard]] Violation calcViolation(const std::vector<ConstraintEquation>& equations,
                                      const SimTK::State& state);

/// Finds initial conditions as Adams does.
///
/// Positions: the given ones, if they satisfy the constraints to within AssemblyTolerance; otherwise those closest to
/// them, a local minimum of the sum over parts of |p - p0|^2/size^2 + 4 sin^2(theta/2), with p the mass centre and theta
/// the turn from the given pose. Constraints may be redundant. Flexible bodies stay undeformed if the constraints can be
/// met that way. Both formulations find the same positions: a tree's are sought with all parts free.
///
/// Coordinates given for joints and motions (IC, ICDISP) must be met, angles on the nearest turn. Coordinates named by
/// EXACT are held; those that contradict a MOTION or a value given for a joint or motion yield to it, as do those that
/// miss the constraints by 10^-3 of the part's size or rad and less, as numbers with few digits do. All that yield come
/// as near as they can, and AssembledState::yielded says by how much they are missed.
///
/// Velocities: the given components are kept where the constraints allow, otherwise met as nearly as can be
/// in the sense of least squares; of all such velocities the smallest, so that what was not given and is not
/// driven by what was stays at rest. Angular velocities count by the part's size. Modes start at rest.
///
/// @throws AssemblyError naming what cannot be met: the constraint that stays violated, or the given coordinate
/// @throws Error if no velocities satisfy the constraints
AssembledState assemble(const Mechanism& mechanism);

/// The same with some elements switched off: neither they nor values given for them count.
AssembledState assemble(const Mechanism& mechanism, const std::set<ElementId>& switchedOff);

/// The same from a State in the course of a run, after constraints were switched on or off: positions close
/// to the present ones, and of the velocities that the constraints allow the nearest.
AssembledState reassemble(const Mechanism& mechanism, const SimTK::State& current);

/// Lengths and angles [rad] of constraint errors up to which given positions are taken as assembled.
constexpr double AssemblyTolerance = 1e-9;

}  // namespace jprim

#endif
