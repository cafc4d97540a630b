// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_POSITION_SEARCH_H_
#define JPRIM_SRC_SIMULATION_POSITION_SEARCH_H_

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "jprim/analysis/constraint_equations.h"
#include "jprim/simulation/assemble.h"
#include "simulation/closeness.h"
#include "simulation/position_condition.h"

namespace jprim {

/// What positions must satisfy and what they should be close to.
struct PositionProblem {
    /// An equation that is given this emphasis beside others of 1 is met all but exactly where not all can be.
    static constexpr double Dominant = 1e4;

    const SimTK::SimbodyMatterSubsystem& matter;
    Closeness closeness;
    std::vector<ConstraintEquation> equations;  ///< holonomic
    std::vector<std::shared_ptr<const PositionCondition>> conditions;
    double emphasisOfEquations = 1;
    std::vector<double> emphasisOfConditions;  ///< empty if all are 1
    std::vector<SimTK::MobilizedBodyIndex> locked;
    double tolerance =
        AssemblyTolerance;  ///< up to which equations and conditions are met [length unit, rad]
};

/// Finds positions for a PositionProblem. It does not care how many equations there are, nor whether they depend on
/// each other.
///
/// Equations count by how far they are off: an error is divided by what its equation's load does by the metric of
/// closeness, as if all bodies were free. So lengths and angles, small and large parts weigh alike, and equations
/// that a tree leaves nothing but rounding errors of stay that small.
class PositionSearch {
public:
    /// @param start  the State whose positions set the scales; realized as needed
    PositionSearch(PositionProblem problem, const SimTK::State& start);

    /// Goes to where the sum of squares of all errors is least, nearby. A symmetric start may lead to where it is
    /// only stationary; then a nudge is tried.
    /// @returns true if all are met
    bool meetEquations(SimTK::State& state) const;
    /// From a State that meets all goes on, meeting them, to where the goals' sum is least.
    void approachGoals(SimTK::State& state) const;
    bool isMet(const SimTK::State& state) const;
    /// The largest error, scaled: about sizes of a part, or rad.
    double calcWorst(const SimTK::State& state) const;

private:
    struct Linearization;
    using Vector = Eigen::VectorXd;

    Vector calcErrors(const SimTK::State& state) const;
    std::vector<EquationLoads> calcRows(const SimTK::State& state) const;
    Eigen::SparseMatrix<double> calcJacobian(const SimTK::State& state, const BodyJacobian& bodies) const;
    void chooseScales(const SimTK::State& start);
    void linearize(const SimTK::State& state, Linearization& linearization) const;
    void realize(const SimTK::State& state) const;
    SimTK::State move(const SimTK::State& state, const Vector& u) const;
    bool descend(SimTK::State& state, Vector& errors, double& damping) const;
    void descendFully(SimTK::State& state, int mostSteps, double damping) const;
    void restore(const Linearization& linearization, SimTK::State& state) const;
    bool advance(const Linearization& linearization, const Vector& u, double decrease,
                 SimTK::State& state) const;

    PositionProblem m_problem;
    std::vector<bool> m_isLocked;  // by speed
    std::vector<double> m_scales;  // by equation, then by condition
};

}  // namespace jprim

#endif
