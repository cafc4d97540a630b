// SPDX-License-Identifier: Apache-2.0
#include "simulation/redundancy.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/scaled_equations.h"
#include "base/format.h"
#include "linear_algebra/orthogonal.h"
#include "linear_algebra/rank.h"
#include "linear_algebra/singular_values.h"

namespace jprim {

using SimTK::Constraint;
using SimTK::Real;
using SimTK::State;

namespace {

/// What may be dropped, and why.
class Selection {
public:
    Selection(const Mechanism& mechanism, const State& state, const ConstraintReport& report)
        : m_report(report) {
        const auto isOnlyHere = [](const RedundantEquation& redundant) { return redundant.onlyHere; };
        if (std::any_of(report.redundant.begin(), report.redundant.end(), isOnlyHere))
            findRoundingErrors(ScaledEquations(mechanism.getMatter(), report.equations, state), state);
    }

    std::vector<int> find(DropChoice choice) const {
        std::vector<int> selected;
        for (const RedundantEquation& redundant : m_report.redundant)
            if (isEmpty(redundant) || (!redundant.onlyHere && choice == DropChoice::Later))
                selected.push_back(redundant.equation);
        return selected;
    }

private:
    // Numbers that are rounded in a dataset leave something of equations that joints in a tree meet already, but as
    // little a motion away as here; at a dead point there is more of them nearby.
    void findRoundingErrors(const ScaledEquations& scaled, const State& state) {
        constexpr double Doubtful = 1e-7, Away = 0.03;  // a row's length; rad, or of the mechanism's size
        const Eigen::MatrixXd here = scaled.calcJacobian(state);
        const Eigen::VectorXd y =
            Away * Decomposition(here, Decomposition::Vectors::Both).calcRandomNullVector(1);
        const Eigen::MatrixXd there =
            scaled.calcJacobian(scaled.move(state, y.cwiseProduct(scaled.getColumnScale())));
        m_isRounding = here.rowwise().norm().array() < Doubtful && there.rowwise().norm().array() < Doubtful;
    }

    bool isEmpty(const RedundantEquation& redundant) const {
        return redundant.onlyHere ? m_isRounding[redundant.equation] : redundant.dependsOn.empty();
    }

    const ConstraintReport& m_report;
    Eigen::Array<bool, Eigen::Dynamic, 1> m_isRounding;
};

// The last ones of an elimination that always takes next what is most independent of those before.
std::vector<int> selectWeakest(const Mechanism& mechanism, const State& state,
                               const ConstraintReport& report) {
    const Eigen::MatrixXd A =
        ScaledEquations(mechanism.getMatter(), report.equations, state).calcJacobian(state);
    const Eigen::VectorXi order = orderByIndependence(A);
    const auto count = Eigen::Index(Selection(mechanism, state, report).find(DropChoice::Later).size());
    std::vector<int> selected(order.end() - count, order.end());
    std::sort(selected.begin(), selected.end());
    return selected;
}

}  // namespace

DroppedEquations::DroppedEquations(const Mechanism& mechanism, State& state, DropChoice choice)
    : m_mechanism(mechanism) {
    const ConstraintReport report =
        analyzeConstraints(mechanism.getMatter(), state, mechanism.getElementNames());
    const Selection selection(mechanism, state, report);
    const std::vector<int> empty = selection.find(DropChoice::Empty);
    for (const int k :
         choice == DropChoice::Weakest ? selectWeakest(mechanism, state, report) : selection.find(choice)) {
        const ConstraintEquation& equation = report.equations[size_t(k)];
        m_dropped.push_back({equation, std::count(empty.begin(), empty.end(), k) > 0, {mechanism, equation}});
        m_dropped.back().access.setScale(state, 0);
    }
    mechanism.getSystem().realize(state, SimTK::Stage::Position);
    m_strength = calcStrength(state);
    if (m_dropped.size() < report.equations.size()) return;
    for (const Dropped& dropped : m_dropped) {
        const Constraint& constraint = mechanism.getMatter().getConstraint(dropped.equation.constraint);
        constraint.disable(state);
        m_disabled.push_back(constraint);
    }
}

// The smallest singular value of the equations kept.
Real DroppedEquations::calcStrength(const State& state) const {
    std::vector<ConstraintEquation> kept = m_mechanism.findEquations(state);
    const auto isDropped = [](const ConstraintEquation& equation) { return equation.scale == 0; };
    kept.erase(std::remove_if(kept.begin(), kept.end(), isDropped), kept.end());
    if (kept.empty()) return 1;
    const Eigen::MatrixXd A = ScaledEquations(m_mechanism.getMatter(), kept, state).calcJacobian(state);
    return A.rows() > A.cols() ? 0 : calcSingularValues(A)[A.rows() - 1];
}

bool DroppedEquations::isWeak(const State& state) const {
    constexpr Real ByFar = 0.1;
    return !m_dropped.empty() && calcStrength(state) < ByFar * m_strength;
}

std::vector<std::string> DroppedEquations::getTexts() const {
    std::vector<std::string> texts;
    for (const Dropped& dropped : m_dropped) texts.push_back(dropped.equation.getText());
    return texts;
}

std::string DroppedEquations::describeViolation(const Dropped& dropped, Real error) const {
    const char* const PerTime[] = {"", "/s", "/s^2"};
    const bool isLength = dropped.equation.isLength;
    return fmt::format(
        "{}, which was dropped because {}, is violated by {:.3g} {}{}: {}", dropped.equation.getText(),
        dropped.isEmpty ? "no motion changed it" : "it followed from other equations",
        isLength ? std::abs(error) / m_mechanism.getUnits().length : std::abs(error),
        isLength ? "length units" : "rad", PerTime[int(dropped.equation.level)],
        dropped.isEmpty ? "by itself it cannot hold what it says" : "it is in conflict with them now");
}

void DroppedEquations::check(const State& state, Real tolerance) const {
    for (const Dropped& dropped : m_dropped) {
        const Real error = dropped.access.calcError(state);
        if (std::abs(error) > tolerance) throw std::runtime_error(describeViolation(dropped, error));
    }
}

void DroppedEquations::restore(State& state) const {
    for (const Dropped& dropped : m_dropped) dropped.access.setScale(state, 1);
    for (const Constraint& constraint : m_disabled) constraint.enable(state);
}

}  // namespace jprim
