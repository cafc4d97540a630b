// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_CONSTRAINT_JACOBIAN_H_
#define JPRIM_SRC_SIMULATION_CONSTRAINT_JACOBIAN_H_

#include <Eigen/Core>

#include "jprim/mechanism/mechanism.h"

namespace jprim {

/// The equations that speeds must satisfy, of positions and of velocities, at a State: G u = b. Entries that are
/// rounding errors are 0 (see ScaledEquations). Requires Stage::Position.
class SpeedEquations {
public:
    SpeedEquations(const Mechanism& mechanism, const SimTK::State& state);

    const Eigen::MatrixXd& getG() const { return m_G; }
    /// From errors in the State's scale of equations to those of G; from multipliers of G to those of the State.
    Eigen::VectorXd unscale(const Eigen::VectorXd& values) const {
        return m_inverseScales.cwiseProduct(values);
    }

private:
    Eigen::MatrixXd m_G;
    Eigen::VectorXd m_inverseScales;  // 0 of dropped equations
};

}  // namespace jprim

#endif
