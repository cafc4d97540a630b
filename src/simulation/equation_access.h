// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_EQUATION_ACCESS_H_
#define JPRIM_SRC_SIMULATION_EQUATION_ACCESS_H_

#include <optional>

#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// One equation of a mechanism by the handle of its element.
class EquationAccess {
public:
    EquationAccess(const Mechanism& mechanism, const ConstraintEquation& equation);

    /// See PairConstraint::setEquationScale().
    void setScale(SimTK::State& state, SimTK::Real scale) const;
    /// In the equation's own unit, also while it is dropped or disabled.
    SimTK::Real calcError(const SimTK::State& state) const;

private:
    std::optional<PairConstraint> m_pair;
    std::optional<GeneralConstraint> m_general;
    int m_number;
};

/// Where parts differ much, scales the equations in use such that each puts on its bodies, if they were free, a load for
/// accelerations of one size: by the root of the mass that it moves. The diagonal of G M^-1 ~G is then about 1, and
/// Simbody, which tells dependent equations by the size of all, does not lose those of heavy parts among those of light
/// ones. By powers of 2, which cost no digit; tolerances keep their meaning. Not in a tree, where G says more of an
/// equation than the bodies that it acts on. Requires Stage::Position and leaves it there.
void setEquationScales(const Mechanism& mechanism, SimTK::State& state);

/// The same by what the tree leaves of the equations, for this position only. Where nothing is free, an equation that
/// hardly anything is left of counts all the same.
void setEquationScalesHere(const Mechanism& mechanism, SimTK::State& state);

/// Takes the scales away again, but not from equations that are dropped.
void resetEquationScales(const Mechanism& mechanism, SimTK::State& state);

/// Puts equations that are dropped back into use.
void restoreDroppedEquations(const Mechanism& mechanism, SimTK::State& state);

}  // namespace jprim

#endif
