// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_DERIVATIVE_H_
#define JPRIM_SRC_SIMULATION_DERIVATIVE_H_

#include <Eigen/Core>
#include <functional>

namespace jprim {

/// df/ds at s = 0, and by how much each component may be wrong.
struct Derivative {
    Eigen::VectorXd value;
    Eigen::VectorXd error;
};

/// By central differences D(h), D(2h), D(4h), extrapolated once: (4 D(h) - D(2h))/3, whose error falls with h^4. The error
/// stated is the change from the value with steps twice as long, and half of what slopes to both sides differ by. Steps
/// begin at a thousandth of the unit of s, and are made shorter, down to 1e-7, while that makes the error smaller.
/// @param f   throws where it has no value
/// @param f0  its value at 0
Derivative differentiate(const std::function<Eigen::VectorXd(double)>& f, const Eigen::VectorXd& f0);

}  // namespace jprim

#endif
