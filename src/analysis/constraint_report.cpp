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

struct Admissible {
    State state;
    double uncertainty = 0;  // up to which equations are taken to depend on each other
};

// By what is left of equations where they are met best.
double calcUncertainty(double left) {
    constexpr double Rounding = 1e-11, Doubtful = 1000, Most = 1e-3;
    return std::clamp(Doubtful * left, Rounding, Most);
}

// The State itself, or where its constraints are met best if that is near: to rounding, or what was rounded in a model.
Admissible findAdmissible(const SimbodyMatterSubsystem& matter, const State& given,
                          const std::vector<ConstraintEquation>& equations) {
    constexpr double Met = 1e-13, Near = 1e-3, Rounded = 1e-4;
    constexpr int MostSteps = 40;
    const ScaledEquations holonomic(matter, selectHolonomic(equations), given);
    const double largest = calcLargest(holonomic.calcErrors(given));
    if (largest <= Met) return {given, calcUncertainty(largest)};
    if (largest > Near) return {given, 0};
    const ErrorMinimum minimum = minimizeErrors(holonomic, given, MostSteps);
    const double left = calcLargest(minimum.errors);
    if (left > Rounded) return {given, 0};
    return {minimum.state, calcUncertainty(left)};
}

// Holonomic equations that are in use, and as good as zero in all columns.
bool hasOnlyEmptyHolonomic(const std::vector<ConstraintEquation>& equations, const MatrixXd& A,
                           double uncertainty) {
    constexpr double Doubtful = 1e-7;  // as a singular value that stands alone
    bool hasHolonomic = false;
    for (int i = 0; i < A.rows(); ++i) {
        if (equations[size_t(i)].level != KinematicLevel::Position) continue;
        if (A.row(i).norm() > std::max(Doubtful, uncertainty)) return false;
        hasHolonomic = true;
    }
    return hasHolonomic;
}

ConstraintCount makeCount(const std::vector<ConstraintEquation>& equations, const MatrixXd& A,
                          const RankDecision& decision, double uncertainty) {
    return {int(A.cols()),         int(A.rows()),           decision.rank,
            decision.smallestKept, decision.largestDropped, hasOnlyEmptyHolonomic(equations, A, uncertainty)};
}

// Independent equations nearby that depend on each other here: the others are left out.
std::vector<RedundantEquation> findLostHere(const MatrixXd& here,
                                            const std::vector<RedundantEquation>& everywhere,
                                            double uncertainty) {
    std::vector<int> rows;
    for (int i = 0; i < here.rows(); ++i)
        if (std::none_of(everywhere.begin(), everywhere.end(),
                         [i](const RedundantEquation& r) { return r.equation == i; }))
            rows.push_back(i);
    const Decomposition independent(here(rows, Eigen::all), Vectors::Both, uncertainty);
    std::vector<RedundantEquation> lost;
    for (const DependentRow& dependent : findDependentRows(independent.calcLeftNullSpace(), uncertainty)) {
        lost.push_back({rows[size_t(dependent.row)], {}, true});
        for (const int i : dependent.on) lost.back().dependsOn.push_back(rows[size_t(i)]);
    }
    return lost;
}

// What is dependent at the nearby position. Where a freedom V leads nowhere there is none: then self-stresses x,
// ~x A = 0, that resist it at second order, ~x dA V != 0, are due to the position, and those that do not are
// redundancy proper.
std::vector<RedundantEquation> findDependentNearby(const NearbyPosition& nearby, double uncertainty) {
    MatrixXd X = Decomposition(nearby.A, Vectors::Both, uncertainty).calcLeftNullSpace();
    if (nearby.obstruction.cols() > 0)
        X *= Decomposition(X.transpose() * nearby.obstruction, Vectors::Both).calcLeftNullSpace();
    std::vector<RedundantEquation> redundant;
    for (const DependentRow& dependent : findDependentRows(X, uncertainty))
        redundant.push_back({dependent.row, dependent.on, false});
    return redundant;
}

}  // namespace

ConstraintCount countFreedoms(const SimbodyMatterSubsystem& matter, const State& given) {
    const std::vector<ConstraintEquation> equations = findEquations(matter, given);
    const auto [state, uncertainty] = findAdmissible(matter, given, equations);
    const MatrixXd A = ScaledEquations(matter, equations, state).calcJacobian(state);
    return makeCount(equations, A, Decomposition(A, Vectors::None, uncertainty).getDecision(), uncertainty);
}

ConstraintReport analyzeConstraints(const SimbodyMatterSubsystem& matter, const State& given,
                                    const ElementNames& names) {
    ConstraintReport report;
    report.equations = findEquations(matter, given, names);
    const auto [state, uncertainty] = findAdmissible(matter, given, report.equations);
    const ScaledEquations scaled(matter, report.equations, state);
    const MatrixXd A = scaled.calcJacobian(state);
    const Decomposition here(A, Vectors::Both, uncertainty);
    static_cast<ConstraintCount&>(report) = makeCount(report.equations, A, here.getDecision(), uncertainty);
    report.freedomsNearby = report.getDegreesOfFreedom();
    if (report.getNumRedundant() == 0) return report;

    const NearbyPosition nearby = findNearbyPosition(matter, scaled, state, here, uncertainty);
    report.redundant = findDependentNearby(nearby, uncertainty);
    report.freedomsNearby = report.getGrueblerCount() + int(report.redundant.size());
    if (report.isSingularPosition()) {
        const std::vector<RedundantEquation> lost = findLostHere(A, report.redundant, uncertainty);
        report.redundant.insert(report.redundant.end(), lost.begin(), lost.end());
    }
    return report;
}

}  // namespace jprim
