// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_CLOSENESS_H_
#define JPRIM_SRC_SIMULATION_CLOSENESS_H_

#include <Eigen/SparseCore>
#include <map>
#include <utility>

#include "analysis/body_jacobian.h"
#include "jprim/simulation/assemble_system.h"

namespace jprim {

/// The sum phi of goals and its derivatives by speeds. With residuals r, phi = |r|^2/2 to second order in them, and
/// r' = J u.
class Closeness {
public:
    Closeness(const SimTK::SimbodyMatterSubsystem& matter, std::vector<PoseGoal> poses,
              std::vector<MarkerGoal> markers = {})
        : m_matter(matter), m_poses(std::move(poses)), m_markers(std::move(markers)) {
        for (const PoseGoal& goal : m_poses) m_goalOfBody[goal.body] = {goal.weight, goal.size};
    }

    SimTK::Real calcValue(const SimTK::State& state) const;
    /// The gradient of phi by speeds is ~J r. Requires Stage::Position.
    Eigen::VectorXd calcResiduals(const SimTK::State& state) const;
    Eigen::SparseMatrix<double> calcJacobian(const SimTK::State& state, const BodyJacobian& bodies) const;

    /// The largest turn [rad] of a body with a goal that goes with the speeds.
    SimTK::Real calcLargestTurn(const SimTK::State& state, const Eigen::VectorXd& u) const;

    /// How far a load's equation is moved by what costs |r| = 1: the size of an equation, whatever tree the bodies
    /// hang in. Bodies without a goal do not count.
    SimTK::Real calcSize(const EquationLoads& loads) const;

private:
    const SimTK::SimbodyMatterSubsystem& m_matter;
    std::vector<PoseGoal> m_poses;
    std::vector<MarkerGoal> m_markers;
    std::map<SimTK::MobilizedBodyIndex, std::pair<SimTK::Real, SimTK::Real>> m_goalOfBody;  // weight and size
};

}  // namespace jprim

#endif
