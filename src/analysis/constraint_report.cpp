// SPDX-License-Identifier: Apache-2.0
#include "jprim/analysis/constraint_report.h"

#include <algorithm>

#include "analysis/error_minimum.h"
#include "analysis/nearby_positions.h"
#include "analysis/scaled_equations.h"
#include "linear_algebra/rank.h"

namespace jprim {

using Eigen::MatrixXd;
using SimTK::SimbodyMatterSubsystem;
using SimTK::State;

namespace {

using Vectors = Decomposition::Vectors;

// The State itself, or where its constraints are met to rounding if that is near.
State findAdmissible(const SimbodyMatterSubsystem& matter, const State& given,
                     const std::vector<ConstraintEquation>& equations) {
    constexpr double Met = 1e-13, Near = 1e-3;
    constexpr int MostSteps = 40;
    const ScaledEquations holonomic(matter, selectHolonomic(equations), given);
    const Eigen::VectorXd errors = holonomic.calcErrors(given);
    const double largest = errors.size() > 0 ? errors.lpNorm<Eigen::Infinity>() : 0;
    if (largest <= Met || largest > Near) return given;
    const ErrorMinimum minimum = minimizeErrors(holonomic, given, MostSteps);
    return minimum.isMet() ? minimum.state : given;
}

// Holonomic equations that are in use, and as good as zero in all columns.
bool hasOnlyEmptyHolonomic(const std::vector<ConstraintEquation>& equations, const MatrixXd& A) {
    constexpr double Doubtful = 1e-7;  // as a singular value that stands alone
    bool hasHolonomic = false;
    for (int i = 0; i < A.rows(); ++i) {
        if (equations[size_t(i)].level != EquationLevel::Holonomic) continue;
        if (A.row(i).norm() > Doubtful) return false;
        hasHolonomic = true;
    }
    return hasHolonomic;
}

ConstraintCount makeCount(const std::vector<ConstraintEquation>& equations, const MatrixXd& A,
                          const RankDecision& decision) {
    return {int(A.cols()),         int(A.rows()),           decision.rank,
            decision.smallestKept, decision.largestDropped, hasOnlyEmptyHolonomic(equations, A)};
}

// Independent equations nearby that depend on each other here: the others are left out.
std::vector<RedundantEquation> findLostHere(const MatrixXd& here,
                                            const std::vector<RedundantEquation>& everywhere) {
    std::vector<int> rows;
    for (int i = 0; i < here.rows(); ++i)
        if (std::none_of(everywhere.begin(), everywhere.end(),
                         [i](const RedundantEquation& r) { return r.equation == i; }))
            rows.push_back(i);
    const Decomposition independent(here(rows, Eigen::all), Vectors::Both);
    std::vector<RedundantEquation> lost;
    for (const DependentRow& dependent : findDependentRows(independent.calcLeftNullSpace())) {
        lost.push_back({rows[size_t(dependent.row)], {}, true});
        for (const int i : dependent.on) lost.back().dependsOn.push_back(rows[size_t(i)]);
    }
    return lost;
}

// What is dependent at the nearby position. Where a freedom V leads nowhere there is none: then self-stresses x,
// ~x A = 0, that resist it at second order, ~x dA V != 0, are due to the position, and those that do not are
// redundancy proper.
std::vector<RedundantEquation> findDependentNearby(const NearbyPosition& nearby) {
    MatrixXd X = Decomposition(nearby.A, Vectors::Both).calcLeftNullSpace();
    if (nearby.obstruction.cols() > 0)
        X *= Decomposition(X.transpose() * nearby.obstruction, Vectors::Both).calcLeftNullSpace();
    std::vector<RedundantEquation> redundant;
    for (const DependentRow& dependent : findDependentRows(X))
        redundant.push_back({dependent.row, dependent.on, false});
    return redundant;
}

}  // namespace

ConstraintCount countFreedoms(const SimbodyMatterSubsystem& matter, const State& given) {
    const std::vector<ConstraintEquation> equations = findEquations(matter, given);
    const State state = findAdmissible(matter, given, equations);
    const MatrixXd A = ScaledEquations(matter, equations, state).calcJacobian(state);
    return makeCount(equations, A, Decomposition(A, Vectors::None).getDecision());
}

ConstraintReport analyzeConstraints(const SimbodyMatterSubsystem& matter, const State& given,
                                    const ElementNames& names) {
    ConstraintReport report;
    report.equations = findEquations(matter, given, names);
    const State state = findAdmissible(matter, given, report.equations);
    const ScaledEquations scaled(matter, report.equations, state);
    const MatrixXd A = scaled.calcJacobian(state);
    const Decomposition here(A, Vectors::Both);
    static_cast<ConstraintCount&>(report) = makeCount(report.equations, A, here.getDecision());
    report.freedomsNearby = report.getDegreesOfFreedom();
    if (report.getNumRedundant() == 0) return report;

    const NearbyPosition nearby = findNearbyPosition(matter, scaled, state, here);
    report.redundant = findDependentNearby(nearby);
    report.freedomsNearby = report.getGrueblerCount() + int(report.redundant.size());
    if (report.isSingularPosition()) {
        const std::vector<RedundantEquation> lost = findLostHere(A, report.redundant);
        report.redundant.insert(report.redundant.end(), lost.begin(), lost.end());
    }
    return report;
}

}  // namespace jprim
