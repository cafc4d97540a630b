// SPDX-License-Identifier: Apache-2.0
#include "analysis/nearby_positions.h"

#include <algorithm>

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

}  // namespace

NearbyPosition findNearbyPosition(const SimbodyMatterSubsystem& matter, const ScaledEquations& scaled,
                                  const State& state, const Decomposition& here) {
    constexpr unsigned NumTries = 3;
    const MatrixXd A = scaled.calcJacobian(state);
    const ScaledEquations holonomic(matter, selectHolonomic(scaled.getEquations()), state);
    NearbyPosition best{A, {}};
    bool found = false;
    for (unsigned seed = 1; seed <= NumTries; ++seed) {
        const VectorXd away = Step * here.calcRandomNullVector(seed).cwiseProduct(scaled.getColumnScale());
        const ErrorMinimum back = minimizeErrors(holonomic, scaled.move(state, away));
        if (!back.isMet()) continue;
        const VectorXd motion = (away + back.displacement).cwiseQuotient(scaled.getColumnScale());
        const std::vector<int> immobile = findImmobileBlocks(here, motion);
        if (found && immobile.size() >= best.immobileBlocks.size()) continue;
        found = true;
        best = {scaled.calcJacobian(back.state), immobile};
        if (immobile.empty()) break;
    }
    for (const int b : best.immobileBlocks) {
        const std::vector<int>& rows = here.getBlocks()[size_t(b)].rows;
        best.A(rows, Eigen::all) = A(rows, Eigen::all);
    }
    return best;
}

}  // namespace jprim
