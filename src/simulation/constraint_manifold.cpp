// SPDX-License-Identifier: Apache-2.0
// Back to the manifold by Newton's method with the Jacobian of the origin, A0 = R G S:
//
//     y <- y - pinv(A0) R e(y)
//
// All corrections lie in the rows of A0 and so across the tangent space: that part of y stays as it is. An error falls by
// the size of the displacement with each iteration.
#include "simulation/constraint_manifold.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/error_minimum.h"
#include "base/format.h"
#include "jprim/analysis/constraint_report.h"
#include "jprim/base/error.h"
#include "linear_algebra/conversion.h"
#include "linear_algebra/ranked_rows.h"

namespace jprim {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using SimTK::Motion;
using SimTK::Stage;
using SimTK::State;

namespace {

constexpr double Allowed = 1e-9;     // scaled errors that may be left
constexpr double Given = 1e-4;       // of the State that is given
constexpr double Admissible = 1e-6;  // at the origin, where a dataset's numbers contradict each other

// Rows that hold the given coordinates, below those of A.
RankedRows rankWith(const MatrixXd& A, const std::vector<int>& held) {
    MatrixXd rows(A.rows() + Index(held.size()), A.cols());
    rows << A, MatrixXd::Zero(Index(held.size()), A.cols());
    for (size_t k = 0; k < held.size(); ++k) rows(A.rows() + Index(k), held[k]) = 1;
    return RankedRows(rows);
}

// Applies corrections for as long as they make errors smaller.
// @returns the largest error left
template <class CalcErrors, class Correct>
double iterate(CalcErrors calcErrors, Correct correct) {
    constexpr int MostIterations = 30;
    constexpr double Stagnation = 0.5;
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0;; ++k) {
        const VectorXd errors = calcErrors();
        const double largest = calcLargest(errors);
        if (largest == 0 || !(largest < Stagnation * before) || k == MostIterations) return largest;
        before = largest;
        correct(errors);
    }
}

}  // namespace

ConstraintManifold::ConstraintManifold(const SimTK::MultibodySystem& system, const State& state)
    : m_system(system),
      m_matter(system.getMatterSubsystem()),
      m_scaled(m_matter, findEquations(m_matter, state), state),
      m_origin(state) {
    m_system.realize(m_origin, Stage::Velocity);
    const ConstraintReport report = analyzeConstraints(m_matter, m_origin);
    if (report.isSingularPosition())
        throw Error("linearize",
                    fmt::format("the position is singular: {} degrees of freedom here, {} nearby, so "
                                "that there is no tangent space; move the mechanism a little",
                                report.getDegreesOfFreedom(), report.freedomsNearby));
    analyze(m_scaled.calcJacobian(m_origin), findPrescribed(m_matter, m_origin));
    requireErrors(calcLargest(m_scaled.calcErrors(m_origin)), calcLargest(m_scaled.calcRateErrors(m_origin)),
                  Given);
    m_left = restorePositions(m_origin);
    requireErrors(m_left, restoreSpeeds(m_origin), Admissible);
    m_system.realize(m_origin, Stage::Acceleration);
}

double ConstraintManifold::calcSpeed(const State& state) const {
    return calcLargest(toEigen(state.getU()).cwiseQuotient(getScale()));
}

void ConstraintManifold::requireErrors(double errors, double rates, double allowed) const {
    if (errors <= allowed && rates <= allowed * (1 + calcSpeed(m_origin))) return;
    throw Error("linearize",
                fmt::format("the State does not satisfy the constraints: by {:.3g}, its speeds by {:.3g} "
                            "[sizes of the mechanism, rad, s]",
                            errors, rates));
}

ConstraintManifold::Prescribed ConstraintManifold::findPrescribed(const SimTK::SimbodyMatterSubsystem& matter,
                                                                  const State& state) {
    Prescribed prescribed;
    for (SimTK::MobilizedBodyIndex b(1); b < matter.getNumBodies(); ++b) {
        const SimTK::MobilizedBody& body = matter.getMobilizedBody(b);
        Motion::Level level = body.getLockLevel(state);
        if (level == Motion::NoLevel && body.hasMotion()) level = body.getMotion().getLevel(state);
        for (int k = 0; k < body.getNumU(state); ++k) {
            const int u = int(body.getFirstUIndex(state)) + k;
            if (level == Motion::Position) prescribed.positions.push_back(u);
            if (level == Motion::Position || level == Motion::Velocity) prescribed.speeds.push_back(u);
        }
    }
    return prescribed;
}

void ConstraintManifold::analyze(const MatrixXd& A, const Prescribed& prescribed) {
    MatrixXd onPositions = A, onSpeeds = A;
    for (Index i = 0; i < A.rows(); ++i) {
        const KinematicLevel level = m_scaled.getEquations()[size_t(i)].level;
        if (level != KinematicLevel::Position) onPositions.row(i).setZero();
        if (level == KinematicLevel::Acceleration) onSpeeds.row(i).setZero();
    }
    const RankedRows positions = rankWith(onPositions, prescribed.positions);
    const RankedRows speeds = rankWith(onSpeeds, prescribed.speeds);
    m_displacements = positions.calcNullSpace();
    m_speeds = speeds.calcNullSpace();
    m_positionInverse = positions.calcPseudoInverse().leftCols(A.rows());
    m_speedInverse = speeds.calcPseudoInverse().leftCols(A.rows());
}

// dq = N dz
void ConstraintManifold::move(const VectorXd& y, State& state) const {
    const VectorXd z = getScale().cwiseProduct(y);
    SimTK::Vector change;
    m_system.realize(state, Stage::Position);
    m_matter.multiplyByN(state, false, toSimTK(z), change);
    state.updQ() += change;
    m_system.realize(state, Stage::Time);
    m_matter.normalizeQuaternions(state);
}

double ConstraintManifold::restorePositions(State& state) const {
    return iterate([&] { return m_scaled.calcErrors(state); },
                   [&](const VectorXd& errors) { move(-m_positionInverse * errors, state); });
}

double ConstraintManifold::restoreSpeeds(State& state) const {
    return iterate([&] { return m_scaled.calcRateErrors(state); },
                   [&](const VectorXd& errors) {
                       const VectorXd y = -m_speedInverse * errors;
                       state.updU() += toSimTK(getScale().cwiseProduct(y));
                   });
}

State ConstraintManifold::displace(const VectorXd& y) const {
    State state = m_origin;
    move(y, state);
    const double errors = restorePositions(state), rates = restoreSpeeds(state);
    if (!(errors <= Allowed + 2 * m_left && rates <= Allowed * (1 + calcSpeed(state)) + 2 * m_left))
        throw Error(
            "linearize",
            fmt::format("a displacement of {:.3g} leads to where the constraints cannot be met", y.norm()));
    return state;
}

}  // namespace jprim
