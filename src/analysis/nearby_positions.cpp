// SPDX-License-Identifier: Apache-2.0
#include "analysis/nearby_positions.h"

#include <vector>

#include "analysis/error_minimum.h"

namespace jprim {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using SimTK::SimbodyMatterSubsystem;
using SimTK::State;

namespace {

// Far enough for the rank to recover visibly, near enough to come back on the constraints nearby. About
// radians, or sizes of the mechanism.
constexpr double Step = 0.02;
// What is left of the step where the constraints lead back to where it began.
constexpr double Returned = 0.01 * Step;

// Blocks that have freedoms and ended where they were, in scaled motions.
std::vector<int> findImmobileBlocks(const Decomposition& here, const VectorXd& motion) {
    std::vector<int> immobile;
    for (int b = 0; b < int(here.getBlocks().size()); ++b) {
        if (here.getNullity(b) == 0) continue;
        const VectorXd part = motion(here.getBlocks()[size_t(b)].columns);
        if (part.lpNorm<Eigen::Infinity>() < Returned) immobile.push_back(b);
    }
    return immobile;
}

// dA V by a central difference along a general one of the motions V.
MatrixXd calcObstruction(const ScaledEquations& scaled, const State& state, const MatrixXd& V) {
    constexpr double Small = 1e-4, Noise = 1e-5;  // the difference is exact to Small^2
    if (V.cols() == 0) return MatrixXd(scaled.getEquations().size(), 0);
    const VectorXd u = Small * V.rowwise().sum().cwiseProduct(scaled.getColumnScale());
    const MatrixXd ahead = scaled.calcJacobian(scaled.move(state, u));
    const MatrixXd behind = scaled.calcJacobian(scaled.move(state, -u));
    const MatrixXd dA_V = (ahead - behind) * V / (2 * Small);
    return (dA_V.array().abs() > Noise).select(dA_V, 0);
}

}  // namespace

NearbyPosition findNearbyPosition(const SimbodyMatterSubsystem& matter, const ScaledEquations& scaled,
                                  const State& state, const Decomposition& here, double uncertainty) {
    constexpr unsigned NumTries = 3;
    constexpr int MostSteps = 40;
    const MatrixXd A = scaled.calcJacobian(state);
    const ScaledEquations holonomic(matter, selectHolonomic(scaled.getEquations()), state);
    MatrixXd best = A;
    std::vector<int> immobile;
    bool found = false;
    for (unsigned seed = 1; seed <= NumTries; ++seed) {
        const VectorXd away = Step * here.calcRandomNullVector(seed).cwiseProduct(scaled.getColumnScale());
        const ErrorMinimum back = minimizeErrors(holonomic, scaled.move(state, away), MostSteps);
        if (!back.isMet(uncertainty)) continue;
        const VectorXd motion = (away + back.displacement).cwiseQuotient(scaled.getColumnScale());
        const std::vector<int> nowImmobile = findImmobileBlocks(here, motion);
        if (found && nowImmobile.size() >= immobile.size()) continue;
        found = true;
        immobile = nowImmobile;
        best = scaled.calcJacobian(back.state);
        if (immobile.empty()) break;
    }
    for (const int b : immobile) {
        const Block& block = here.getBlocks()[size_t(b)];
        best(block.rows, Eigen::all) = A(block.rows, Eigen::all);
        best(Eigen::all, block.columns) = A(Eigen::all, block.columns);
    }
    return {best, calcObstruction(scaled, state, here.calcRightNullSpace(immobile))};
}

}  // namespace jprim
