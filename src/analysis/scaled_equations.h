// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_ANALYSIS_SCALED_EQUATIONS_H_
#define JPRIM_SRC_ANALYSIS_SCALED_EQUATIONS_H_

#include <Eigen/Core>
#include <vector>

#include "jprim/analysis/constraint_equations.h"

namespace jprim {

/// Some equations of a system and their Jacobian, free of units: A = R G C with diagonal R and C.
///
/// R divides an equation that feels shifts by what a shift of the mechanism's length L does to it, others by
/// what a turn of 1 rad does. It is the same for the equations of one ATPOINT, so scaled errors have no
/// favourite direction. L is the root mean square of all levers. C divides a column by its length before the powers
/// of the bodies that the speed moves are added up: by 1 in A where nothing cancels, so that a small part counts as a
/// large one does, but where a tree leaves the equations nothing to do, what rounding leaves of a column stays small.
/// Entries that are rounding errors of their powers are 0. Another unit for an equation or a speed changes R or C and
/// not A. Both are those of one State, so that errors R e stay comparable from one position to the next.
///
/// A motion is a vector u of speeds times a unit of time; scaled, y = u / C. An entry of 1 turns or shifts
/// something by about the size of the mechanism.
///
/// States are realized to Stage::Velocity as needed: copying one loses its cache.
class ScaledEquations {
public:
    ScaledEquations(const SimTK::SimbodyMatterSubsystem& matter, std::vector<ConstraintEquation> equations,
                    const SimTK::State& state);

    const std::vector<ConstraintEquation>& getEquations() const { return m_equations; }
    const Eigen::VectorXd& getColumnScale() const { return m_columnScale; }

    /// A at a State.
    Eigen::MatrixXd calcJacobian(const SimTK::State& state) const;
    /// G there, without rounding errors.
    Eigen::MatrixXd calcCleanJacobian(const SimTK::State& state) const;
    /// R e, one for each equation; 0 for those that are not holonomic.
    Eigen::VectorXd calcErrors(const SimTK::State& state) const;
    /// R (G u - b), one for each equation on positions or speeds; 0 for those on accelerations.
    Eigen::VectorXd calcRateErrors(const SimTK::State& state) const;
    /// The positions moved by u.
    SimTK::State move(const SimTK::State& state, const Eigen::VectorXd& u) const;

private:
    void realize(const SimTK::State& state) const;

    const SimTK::SimbodyMatterSubsystem& m_matter;
    std::vector<ConstraintEquation> m_equations;
    Eigen::VectorXd m_rowScale;
    Eigen::VectorXd m_columnScale;
    Eigen::MatrixXd m_noise;  // what rounding may leave of each entry of G
};

/// The holonomic ones.
std::vector<ConstraintEquation> selectHolonomic(const std::vector<ConstraintEquation>& equations);

}  // namespace jprim

#endif
