// SPDX-License-Identifier: Apache-2.0
#include "marker/marker_expression.h"

#include <algorithm>

#include "base/format.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;

namespace {

int getAxis(MarkerQuantity quantity) {
    return int(quantity) - int(MarkerQuantity::AxisX);
}

// A vector fixed to a turning frame.
Taylor<Vec3> rotate(const Vec3& x, const MarkerMotion& m) {
    const Vec3 first = m.V[0] % x;
    return {x, first, m.A[0] % x + m.V[0] % first};
}

Taylor<Vec3> calcInput(MarkerQuantity quantity, const MarkerMotion& m, const ExpressionUnits& u) {
    const Real v = u.time / u.length;
    switch (quantity) {
        case MarkerQuantity::Origin: return {m.X.p() / u.length, m.V[1] / u.length, m.A[1] / u.length};
        case MarkerQuantity::Velocity: return {v * m.V[1], v * m.A[1], Vec3(0)};
        case MarkerQuantity::AngularVelocity: return {u.time * m.V[0], u.time * m.A[0], Vec3(0)};
        case MarkerQuantity::Acceleration: return {v * u.time * m.A[1], Vec3(0), Vec3(0)};
        case MarkerQuantity::AngularAcceleration: return {u.time * u.time * m.A[0], Vec3(0), Vec3(0)};
        default: return rotate(Vec3(m.X.R()(getAxis(quantity))), m);
    }
}

MarkerMotion findMotion(const Marker& marker, const State& state, KinematicLevel level) {
    MarkerMotion motion;
    motion.X = marker.findPoseInGround(state);
    if (level >= KinematicLevel::Velocity) motion.V = marker.findVelocityInGround(state);
    if (level >= KinematicLevel::Acceleration) motion.A = marker.findAccelerationInGround(state);
    return motion;
}

}  // namespace

std::string MarkerExpression::findDerivativeProblem(int needed) const {
    const int number = program.getNumDerivatives();
    if (number >= needed) return "";
    return fmt::format(
        "a function in it has derivatives up to order {}, by its getMaxDerivativeOrder(); order {} is needed",
        number, needed);
}

std::vector<MarkerMotion> MarkerExpression::findMotions(const State& state, KinematicLevel level) const {
    std::vector<MarkerMotion> motions;
    for (const Marker& marker : markers) motions.push_back(findMotion(marker, state, level));
    return motions;
}

void MarkerExpression::setTime(Real time, Evaluation& evaluation) const {
    if (program.getTimeInput() >= 0)
        evaluation.setScalarInput(program.getTimeInput(), {time / units.time, 1 / units.time, 0});
}

void MarkerExpression::setMotion(size_t marker, const MarkerMotion& motion, Evaluation& evaluation) const {
    for (size_t k = 0; k < vectorInputs.size(); ++k)
        if (vectorInputs[k].marker == int(marker))
            evaluation.setVectorInput(int(k), calcInput(vectorInputs[k].quantity, motion, units));
}

void MarkerExpression::setInputs(Real time, const MarkerMotion* motions, Evaluation& evaluation) const {
    setTime(time, evaluation);
    for (size_t k = 0; k < vectorInputs.size(); ++k)
        evaluation.setVectorInput(
            int(k), calcInput(vectorInputs[k].quantity, motions[vectorInputs[k].marker], units));
}

void MarkerExpression::setInputs(const State& state, Evaluation& evaluation, KinematicLevel highest) const {
    const KinematicLevel level = std::min(program.getLevel(), highest);
    setTime(state.getTime(), evaluation);
    for (size_t k = 0; k < markers.size(); ++k)
        setMotion(k, findMotion(markers[k], state, level), evaluation);
    if (highest < KinematicLevel::Acceleration) return;
    const bool isAccelerated = state.getSystemStage() >= SimTK::Stage::Acceleration;
    for (size_t k = 0; k < scalarInputs.size(); ++k) {
        const auto& [calc, calcRate] = scalarInputs[k];
        if (calc && program.usesScalarInput(int(k)))
            evaluation.setScalarInput(int(k),
                                      {calc(state), isAccelerated && calcRate ? calcRate(state) : 0, 0});
    }
}

// An axis x turns with w: d(g.x)/dt = g.(w x x) = (x x g).w. Where x is along g nothing changes; rounding errors
// left in the place of nothing would, as the only equation of a hinge, hold it.
SpatialVec MarkerExpression::getDirection(const Evaluation& evaluation, const MarkerMotion* motions,
                                          int marker) const {
    constexpr Real Rounding = 1e-14;
    const bool ofVelocity = program.getLevel() == KinematicLevel::Velocity;
    SpatialVec direction(Vec3(0), Vec3(0));
    for (size_t k = 0; k < vectorInputs.size(); ++k) {
        const auto [owner, quantity] = vectorInputs[k];
        if (owner != marker || !program.usesVectorInput(int(k))) continue;
        const Vec3& g = evaluation.getVectorGradient(int(k));
        if (quantity == MarkerQuantity::Velocity)
            direction[1] += g * (units.time / units.length);
        else if (quantity == MarkerQuantity::AngularVelocity)
            direction[0] += g * units.time;
        else if (ofVelocity)
            continue;
        else if (quantity == MarkerQuantity::Origin)
            direction[1] += g / units.length;
        else {
            const Vec3 turn = Vec3(motions[marker].X.R()(getAxis(quantity))) % g;
            if (turn.norm() > Rounding * g.norm()) direction[0] += turn;
        }
    }
    return direction;
}

Real MarkerExpression::getTimeDerivative(const Evaluation& evaluation) const {
    const int input = program.getTimeInput();
    return input < 0 ? 0 : evaluation.getScalarGradient(input) / units.time;
}

int ExpressionInputs::findMarker(int id) const {
    const auto found = std::find(markerIds.begin(), markerIds.end(), id);
    return found == markerIds.end() ? -1 : int(found - markerIds.begin());
}

}  // namespace jprim
