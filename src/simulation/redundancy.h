// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_REDUNDANCY_H_
#define JPRIM_SRC_SIMULATION_REDUNDANCY_H_

#include <functional>
#include <string>
#include <vector>

#include "jprim/analysis/constraint_report.h"
#include "jprim/build/mechanism.h"

namespace jprim {

/// True if there are equations and no motion changes any of them.
inline bool holdNothing(const ConstraintCount& count) {
    return count.numEquations > 0 && count.rank == 0;
}

/// The redundant equations of a mechanism, switched off as Adams does, and watched: they must go on being
/// satisfied by what the others hold.
class DroppedEquations {
public:
    /// Drops the later ones of equations that depend on each other in the State, realized to Stage::Position,
    /// and nearby; those that depend only there stay. Where none is left the constraints are disabled: Simbody
    /// cannot solve for multipliers that do nothing.
    DroppedEquations(const Mechanism& mechanism, SimTK::State& state);

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
        std::function<SimTK::Real(const SimTK::State&)> calcError;
        std::function<void(SimTK::State&)> restore;
    };
    static Dropped drop(const PairConstraint& constraint, const ConstraintEquation& equation,
                        SimTK::State& state);
    static Dropped drop(const GeneralConstraint& constraint, const ConstraintEquation& equation,
                        SimTK::State& state);
    static Dropped drop(const Mechanism& mechanism, const ConstraintEquation& equation, SimTK::State& state);
    std::string describeViolation(const Dropped& dropped, SimTK::Real error) const;

    SimTK::Real m_lengthUnit;  // of the dataset
    std::vector<Dropped> m_dropped;
    std::vector<SimTK::Constraint> m_disabled;
};

}  // namespace jprim

#endif
