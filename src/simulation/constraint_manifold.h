// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_CONSTRAINT_MANIFOLD_H_
#define JPRIM_SRC_SIMULATION_CONSTRAINT_MANIFOLD_H_

#include <Eigen/Core>

#include "analysis/scaled_equations.h"

namespace jprim {

/// The positions and speeds that a system's constraints and prescribed motions allow at one time, around a State. Small
/// displacements are speeds times a unit of time, dq = N dz, and measured in scaled coordinates y, z = S y with diagonal S
/// (ScaledEquations). Constraints may depend on each other.
class ConstraintManifold {
public:
    /// Takes the allowed positions and speeds nearest to the State as its origin.
    /// @throws Error if the State does not satisfy the constraints, or its position is singular
    ConstraintManifold(const SimTK::MultibodySystem& system, const SimTK::State& state);

    /// Realized to Stage::Acceleration.
    const SimTK::State& getOrigin() const { return m_origin; }
    /// S.
    const Eigen::VectorXd& getScale() const { return m_scaled.getColumnScale(); }
    /// Orthonormal bases, in y, of the displacements and of the changes of speeds that are allowed.
    const Eigen::MatrixXd& getDisplacements() const { return m_displacements; }
    const Eigen::MatrixXd& getSpeeds() const { return m_speeds; }

    /// The allowed positions nearest to the origin displaced by y, and there the allowed speeds nearest to the origin's.
    /// What y has along getDisplacements() is kept to second order.
    /// @throws Error if there are none within reach
    SimTK::State displace(const Eigen::VectorXd& y) const;

private:
    struct Prescribed {
        std::vector<int> positions, speeds;  // of speeds u
    };
    static Prescribed findPrescribed(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state);
    double calcSpeed(const SimTK::State& state) const;
    void requireErrors(double errors, double rates, double allowed) const;
    void analyze(const Eigen::MatrixXd& A, const Prescribed& prescribed);
    void move(const Eigen::VectorXd& y, SimTK::State& state) const;
    double restorePositions(SimTK::State& state) const;
    double restoreSpeeds(SimTK::State& state) const;

    const SimTK::MultibodySystem& m_system;
    const SimTK::SimbodyMatterSubsystem& m_matter;
    ScaledEquations m_scaled;
    SimTK::State m_origin;
    Eigen::MatrixXd m_displacements, m_speeds;
    Eigen::MatrixXd m_positionInverse, m_speedInverse;  // from scaled errors to y
    double m_left = 0;                                  // of errors at the origin
};

}  // namespace jprim

#endif
