// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_REDUNDANCY_H_
#define JPRIM_SRC_SIMULATION_REDUNDANCY_H_

#include <string>
#include <vector>

#include "jprim/analysis/constraint_report.h"
#include "jprim/mechanism/mechanism.h"
#include "simulation/equation_access.h"
#include "simulation/violation.h"

namespace jprim {

/// Which of the redundant equations a run does without. Empty: those that no motion changes. Later: of equations that
/// say the same the later. Weakest: as many, such that those that stay are as independent of each other as can be.
enum class DropChoice { Empty, Later, Weakest };

/// Empty or Later: the indices in ConstraintReport::equations of those that no motion changes, or of all that follow from
/// others wherever the mechanism moves.
std::vector<int> selectRedundant(const ConstraintReport& report, DropChoice choice);

/// Redundant equations of a mechanism, switched off as Adams does, and watched: they must go on being satisfied by what
/// the others hold. Those that the State does without already are watched too: they contradict the others by what was
/// rounded in a dataset, see AssembledState::leftOut, and may go on doing so.
class DroppedEquations {
public:
    /// Drops equations that depend on others in the State, realized to Stage::Position, and nearby; those that depend
    /// only there stay. Where none is left the constraints are disabled: Simbody cannot solve for multipliers that do
    /// nothing.
    DroppedEquations(const Mechanism& mechanism, SimTK::State& state, DropChoice choice);

    /// True if what is kept is by far nearer to dependent than when it was chosen. Requires Stage::Position.
    bool isWeak(const SimTK::State& state) const;

    /// In words: "JOINT/4 TRANSLATIONAL: translation of I along Yj".
    std::vector<std::string> getTexts() const;

    /// @throws std::runtime_error naming the equation that is violated by more than `tolerance` [the
    ///         mechanism's length unit, rad, s] and by how much. Requires Stage::Acceleration if there are
    ///         equations of accelerations, and so on.
    void check(const SimTK::State& state, SimTK::Real tolerance) const;

    /// Puts everything back into use in a State of the same mechanism.
    void restore(SimTK::State& state) const;

private:
    struct Dropped {
        ConstraintEquation equation;
        bool isEmpty = false;  // no motion changes it
        EquationAccess access;
    };
    void allowContradictions(const SimTK::State& state);
    SimTK::Real calcStrength(const SimTK::State& state) const;
    std::string describeViolation(const Dropped& dropped, SimTK::Real error) const;

    const Mechanism& m_mechanism;
    SimTK::Real m_strength = 0;  // smallest singular value of what is kept
    Violation m_allowed;         // of those that the State was without
    std::vector<Dropped> m_dropped;
    std::vector<SimTK::Constraint> m_disabled;
};

}  // namespace jprim

#endif
