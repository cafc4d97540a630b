// SPDX-License-Identifier: Apache-2.0
#include "jprim/analysis/conflicts.h"

#include <algorithm>
#include <cmath>

#include "analysis/error_minimum.h"
#include "analysis/scaled_equations.h"
#include "linear_algebra/random_vector.h"
#include "linear_algebra/rank.h"
#include "marker/find_implementation.h"
#include "primitive/pair_constraint_impl.h"

namespace jprim {

using SimTK::Constraint;
using SimTK::ConstraintIndex;
using SimTK::Real;
using SimTK::SimbodyMatterSubsystem;
using SimTK::Stage;
using SimTK::State;

namespace {

// The nearest minimum. A symmetric start, such as links in line, may lead to a stationary point that is none;
// from there a nudge goes further down.
ErrorMinimum findLeastErrors(const ScaledEquations& equations, const State& given) {
    constexpr int MostSteps = 300;
    constexpr double Nudge = 0.01, Lower = 0.999;
    ErrorMinimum minimum = minimizeErrors(equations, given, MostSteps);
    if (minimum.isMet()) return minimum;
    std::mt19937 generator;
    const Eigen::VectorXd u = Nudge * makeRandomVector(given.getNU(), generator);
    const State nudged = equations.move(minimum.state, u.cwiseProduct(equations.getColumnScale()));
    const ErrorMinimum second = minimizeErrors(equations, nudged, MostSteps);
    return second.errors.norm() < Lower * minimum.errors.norm() ? second : minimum;
}

// The equations of a block that the stress runs through.
Conflict findConflict(const Block& block, const ScaledEquations& equations, const ErrorMinimum& minimum) {
    constexpr double Negligible = 1e-4;  // well above what is left of the descent
    const double largest = minimum.errors(block.rows).lpNorm<Eigen::Infinity>();
    Conflict conflict;
    for (const int row : block.rows) {
        if (std::abs(minimum.errors[row]) < Negligible * largest) continue;
        conflict.equations.push_back(row);
        conflict.errors.push_back(equations.getEquations()[size_t(row)].getError(minimum.state.getQErr()));
    }
    return conflict;
}

// What the element is called in one equation's name.
std::string findElement(const std::vector<ConstraintEquation>& equations, ConstraintIndex constraint) {
    return std::find_if(equations.begin(), equations.end(),
                        [constraint](const ConstraintEquation& e) { return e.constraint == constraint; })
        ->element;
}

}  // namespace

ConflictReport findConflicts(const SimbodyMatterSubsystem& matter, const State& given,
                             const ElementNames& names) {
    const ScaledEquations holonomic(matter, selectHolonomic(findEquations(matter, given, names)), given);
    const ErrorMinimum minimum = findLeastErrors(holonomic, given);
    ConflictReport report{holonomic.getEquations(), {}, minimum.state};
    for (const Block& block : findBlocks(holonomic.calcJacobian(minimum.state))) {
        constexpr double Met = 1e-9;
        if (minimum.errors(block.rows).lpNorm<Eigen::Infinity>() > Met)
            report.conflicts.push_back(findConflict(block, holonomic, minimum));
    }
    return report;
}

namespace {

// The angle that a primitive of two or three angles is off, |e| = 2 sin(angle / 2); of others 0.
Real calcAngleOff(const PairEquations& part, const Real* e) {
    const int count = part.getNumEquations();
    if (part.isTranslational() || count < 2) return 0;
    const Real size = Eigen::Map<const Eigen::VectorXd>(e, count).norm();
    return 2 * std::asin(std::min(size / 2, Real(1)));
}

}  // namespace

std::vector<FlippedAxes> findFlippedAxes(const SimbodyMatterSubsystem& matter, const State& state,
                                         const ElementNames& names) {
    const std::vector<ConstraintEquation> equations = findEquations(matter, state, names);
    std::vector<FlippedAxes> flipped;
    for (ConstraintIndex index(0); index < matter.getNumConstraints(); ++index) {
        const Constraint& constraint = matter.getConstraint(index);
        const auto* pair = findImplementation<PairConstraintImpl>(constraint);
        if (!pair || constraint.isDisabled(state)) continue;
        const SimTK::Vector errors = constraint.getPositionErrorsAsVector(state);
        int first = 0;
        for (const PairEquations* part : pair->getParts()) {
            const Real angle = calcAngleOff(*part, &errors[first]);
            first += part->getNumEquations();
            if (angle <= SimTK::Pi / 2) continue;
            const char* axes = part->getNumEquations() == 2 ? "z axes" : "axes";
            flipped.push_back({findElement(equations, index), axes, angle});
        }
    }
    return flipped;
}

}  // namespace jprim
