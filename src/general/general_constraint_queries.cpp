// SPDX-License-Identifier: Apache-2.0
// What others ask a GeneralConstraint, as opposed to what Simbody does.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/format.h"
#include "general/general_constraint_impl.h"
#include "jprim/base/error.h"
#include "marker/read_multiplier.h"

namespace jprim {

using SimTK::Array_;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Value;
using SimTK::Vec3;
using SimTK::Vector;

//---------------------------------------------------------------------------------- scale and error
Real GeneralConstraintImpl::getStateScale(const State& state) const {
    return static_cast<const Value<Real>&>(state.getDiscreteVariable(m_subsystem, m_stateScale)).get();
}

void GeneralConstraintImpl::setStateScale(State& state, Real scale) const {
    static_cast<Value<Real>&>(state.updDiscreteVariable(m_subsystem, m_stateScale)).upd() = scale;
}

// Simbody knows errors only of equations in use.
Real GeneralConstraintImpl::calcEquationError(const State& state) const {
    const std::vector<MarkerMotion> motions = m_coordinate->findMotions(state, m_equationLevel);
    Evaluation evaluation(m_coordinate->program);
    m_coordinate->setInputs(state.getTime(), motions.data(), evaluation);
    m_angles.recall(state, evaluation);
    const Taylor<Real> q = evaluation.calcTaylor();
    const int ofVelocity = m_coordinate->program.getLevel() == KinematicLevel::Velocity ? 1 : 0;
    const Real derivatives[] = {q.value, q.first, q.second};
    return m_scale * reduce(derivatives[int(m_equationLevel) - ofVelocity] - calcFunction(state).value);
}

//------------------------------------------------------------------------------------------ turns
// The nearest turn is the one that makes the error what is left of its periods.
Vector GeneralConstraintImpl::getTurns(const State& state) const {
    if (!impliesTurns()) return m_angles.getTurns(state);
    Evaluation evaluation(m_coordinate->program);
    m_coordinate->setInputs(state, evaluation, KinematicLevel::Position);
    const Real error = evaluation.calcValue() - calcFunction(state).value;
    const Real perTurn = 2 * SimTK::Pi * m_coordinate->program.getAngleSlope(0);
    return Vector(1,
                  evaluation.getAngle(0) / (2 * SimTK::Pi) + std::round((reduce(error) - error) / perTurn));
}

void GeneralConstraintImpl::setTurns(State& state, const Vector& turns) const {
    checkTurns(turns, getNumAngles(), m_name);
    if (!impliesTurns()) m_angles.setTurns(state, turns, m_name);
}

//--------------------------------------------------------------------------------------- problems
// A distance has no derivative at zero, where it takes three equations to keep it.
std::string GeneralConstraintImpl::findVanished(const PositionCache& cache, Real distance) const {
    for (const auto& [i, j] : m_coordinate->distances) {
        const auto origin = [&](int marker) { return marker < 0 ? Vec3(0) : cache.motions[marker].X.p(); };
        if ((origin(i) - origin(j)).norm() > distance) continue;
        const auto id = [&](int marker) { return marker < 0 ? 0 : m_coordinate->markerIds[marker]; };
        return fmt::format(
            "the distance between markers {} and {} has become zero, where a single equation "
            "cannot keep it; to hold two points together use JPRIM ATPOINT",
            id(i), id(j));
    }
    return "";
}

// Why no assembler or projection can meet the equation, starting here.
std::string GeneralConstraintImpl::findImpossible(const State& state, const PositionCache& cache) const {
    constexpr Real Met = 1e-7, Vanished = 1e-9;
    const Taylor<Real> function = calcFunction(state);
    for (const auto& [value, what] :
         {std::pair(cache.value, "expression"), std::pair(function.value, "function")})
        if (!std::isfinite(value))
            return fmt::format("its {} has no finite value here, but is {}", what, value);

    // The part of the error that does not come from velocities; of an equation of accelerations it is not known.
    const Real atRest =
        isHolonomic() ? reduce(cache.value - function.value) : cache.rateAtRest - function.value;
    const bool isMet = !isHolonomic() || std::abs(atRest) <= Met;
    const std::string vanished = isMet ? findVanished(cache, Vanished) : "";
    if (!vanished.empty()) return vanished;
    if (isMet && cache.coordinate->isGradientChosen())
        return "a length in its expression has become zero (of THETA and INCANG where the angle is zero, of PITCH "
               "at a right angle), where a single equation cannot keep it";

    const auto isZero = [](const SpatialVec& d) { return d[0].normSqr() == 0 && d[1].normSqr() == 0; };
    const bool isFixed = std::all_of(cache.directions.begin(), cache.directions.end(), isZero) &&
                         std::all_of(cache.modalDirections.begin(), cache.modalDirections.end(),
                                     [](Real d) { return d == 0; });
    if (isFixed && m_equationLevel < KinematicLevel::Acceleration && std::abs(atRest) > Met)
        return fmt::format(
            "it is not met, its error is {:.3g}, and no motion from here changes it (its derivatives "
            "are zero or do not exist); start from another position",
            atRest);
    return "";
}

std::string GeneralConstraintImpl::findProblem(const State& state) const {
    return findVanished(getPositionCache(state), 1e-7);
}

//------------------------------------------------------------------------------------------- names
std::string describeGeneral(const char* adamsType, const std::string& name) {
    if (name.empty()) return adamsType;
    const bool isJoint = std::strcmp(adamsType, Gcon) != 0 && std::strcmp(adamsType, DrivenCoordinate) != 0;
    return isJoint ? name + " " + adamsType : name;
}

Dimension GeneralConstraintImpl::getDimension() const {
    for (size_t k = 0; k < m_coordinate->vectorInputs.size(); ++k) {
        const MarkerQuantity quantity = m_coordinate->vectorInputs[k].quantity;
        if (m_coordinate->program.usesVectorInput(int(k)) &&
            (quantity == MarkerQuantity::Origin || quantity == MarkerQuantity::Velocity))
            return Dimension::Length;
    }
    return Dimension::Angle;
}

const Marker& GeneralConstraintImpl::getMarker(int key) const {
    const int marker = m_coordinate->findMarker(key);
    if (marker < 0) throw Error(getDescription(), fmt::format("does not depend on a marker {}", key));
    return m_coordinate->markers[size_t(marker)];
}

//-------------------------------------------------------------------------------------- reactions
// Simbody's multipliers are minus the applied load.
SpatialVec GeneralConstraintImpl::calcLoadOn(const State& state, int markerId) const {
    const int marker = m_coordinate->findMarker(markerId);
    if (marker < 0) return {Vec3(0), Vec3(0)};
    Array_<Real> lambda;
    getMultipliers(state, lambda);
    PositionCache& cache = updPositionCache(state);
    placeMarkers(state, cache);
    Evaluation& q = *cache.coordinate;
    m_coordinate->setInputs(state.getTime(), cache.motions.data(), q);
    m_angles.recall(state, q);
    q.calcValue();
    q.calcGradient();
    return -getScale(state) * readMultiplier(lambda[0]) *
           m_coordinate->getDirection(q, cache.motions.data(), marker);
}

}  // namespace jprim
