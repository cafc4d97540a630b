// SPDX-License-Identifier: Apache-2.0
#include "general/general_constraint_impl.h"

#include <algorithm>
#include <cmath>

#include "general/check_expression.h"
#include "jprim/base/error.h"
#include "marker/cache_entry.h"
#include "marker/read_multiplier.h"

namespace jprim {

using SimTK::Array_;
using SimTK::ConstrainedBodyIndex;
using SimTK::ConstrainedQIndex;
using SimTK::ConstrainedUIndex;
using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Value;
using SimTK::Vec3;

namespace {

const SpatialVec Nothing(Vec3(0), Vec3(0));

// Only coordinates of positions follow a function at another level than their own.
KinematicLevel findEquationLevel(const MarkerExpression& coordinate, KinematicLevel level) {
    return std::max(coordinate.program.getLevel(), level);
}

}  // namespace

GeneralConstraintImpl::GeneralConstraintImpl(const char* adamsType, const Expression& coordinate,
                                             const Expression* function, KinematicLevel level, Real period,
                                             const std::string& name)
    : Implementation(
          findMatter(coordinate.getImplementation(), describeGeneral(adamsType, name)),
          findEquationLevel(coordinate.getImplementation(), level) == KinematicLevel::Position,
          findEquationLevel(coordinate.getImplementation(), level) == KinematicLevel::Velocity,
          findEquationLevel(coordinate.getImplementation(), level) == KinematicLevel::Acceleration),
      m_adamsType(adamsType),
      m_name(name),
      m_coordinate(std::make_shared<MarkerExpression>(coordinate.getImplementation())),
      m_equationLevel(findEquationLevel(*m_coordinate, level)),
      m_period(period) {
    if (function) m_function = std::make_shared<MarkerExpression>(function->getImplementation());
    if (m_period == 0 && isHolonomic()) m_period = m_coordinate->program.findTurnPeriod();
    if (!impliesTurns()) m_angles = AngleMemory(*m_coordinate);
    addMarkers();
}

// Of several angles the equation knows the sum alone.
bool GeneralConstraintImpl::impliesTurns() const {
    return m_period > 0 && isHolonomic() && getNumAngles() == 1;
}

// Ground is always among the bodies: it is then the ancestor, and the expression's vectors are in Ground.
// Modal coordinates are numbered in the order in which their carriers are added; two markers on one flexible
// body share them.
void GeneralConstraintImpl::addMarkers() {
    addConstrainedBody(getMatterSubsystem().getGround());
    for (const Marker& marker : m_coordinate->markers) {
        ConstrainedMarker added{addConstrainedBody(marker.getBody()), marker.getNode(), m_numCoordinates};
        const auto sharesBody = [&](const ConstrainedMarker& other) {
            return other.node && added.node && other.body == added.body;
        };
        const auto other = std::find_if(m_markers.begin(), m_markers.end(), sharesBody);
        if (other != m_markers.end()) {
            added.firstCoordinate = other->firstCoordinate;
        } else if (added.node) {
            m_numCoordinates += added.getNumCoordinates();
            for (const SimTK::MobilizedBodyIndex carrier : added.node->getCoordinates().getCarriers())
                addConstrainedMobilizer(getMatterSubsystem().getMobilizedBody(carrier));
        }
        m_numBodies = std::max(m_numBodies, int(added.body) + 1);
        m_markers.push_back(added);
    }
}

//------------------------------------------------------------------------------------------ State
void GeneralConstraintImpl::realizeTopology(State& state) const {
    const SimTK::SimbodyMatterSubsystem& matter = getMatterSubsystem();
    m_subsystem = matter.getMySubsystemIndex();
    PositionCache cache;
    cache.directions.resize(size_t(m_numBodies));
    cache.modalDirections.resize(size_t(m_numCoordinates));
    cache.motions.resize(m_markers.size());
    cache.coordinate.emplace(m_coordinate->program);
    if (m_function) cache.function.emplace(m_function->program);
    m_positionCache = matter.allocateCacheEntry(state, Stage::Position, new Value<PositionCache>(cache));
    m_bias = matter.allocateCacheEntry(state, Stage::Velocity, new Value<Real>());
    m_stateScale = matter.allocateDiscreteVariable(state, Stage::Position, new Value<Real>(1));
}

GeneralConstraintImpl::PositionCache& GeneralConstraintImpl::updPositionCache(const State& state) const {
    return updEntry<PositionCache>(state, m_subsystem, m_positionCache);
}

void GeneralConstraintImpl::realizePosition(const State& state) const {
    PositionCache& cache = updPositionCache(state);
    calcPositionCache(state, cache);
    if (getStateScale(state) == 0) return;
    const std::string problem = findImpossible(state, cache);
    if (!problem.empty()) throw Error(getDescription(), problem);
}

void GeneralConstraintImpl::realizeVelocity(const State& state) const {
    updEntry<Real>(state, m_subsystem, m_bias) = calcBias(state);
}

// While Simbody realizes a stage it asks for errors before it lets us fill our cache.
const GeneralConstraintImpl::PositionCache& GeneralConstraintImpl::getPositionCache(
    const State& state) const {
    PositionCache& cache = updPositionCache(state);
    if (state.getSubsystemStage(m_subsystem) < Stage::Position) calcPositionCache(state, cache);
    return cache;
}

Real GeneralConstraintImpl::getBias(const State& state) const {
    if (state.getSubsystemStage(m_subsystem) < Stage::Velocity) return calcBias(state);
    return updEntry<Real>(state, m_subsystem, m_bias);
}

//--------------------------------------------------------------------------------- the expression
void GeneralConstraintImpl::placeMarkers(const State& state, PositionCache& cache) const {
    for (size_t k = 0; k < m_markers.size(); ++k) {
        const ConstrainedMarker& m = m_markers[k];
        cache.motions[k].X = m.calcPose(getBodyTransformFromState(state, m.body),
                                        m_coordinate->markers[k].getPose(), m.getEta(state));
        cache.motions[k].V = cache.motions[k].A = Nothing;
    }
}

void GeneralConstraintImpl::calcPositionCache(const State& state, PositionCache& cache) const {
    std::fill(cache.directions.begin(), cache.directions.end(), Nothing);
    std::fill(cache.modalDirections.begin(), cache.modalDirections.end(), 0);
    placeMarkers(state, cache);
    Evaluation& q = *cache.coordinate;
    m_coordinate->setInputs(state.getTime(), cache.motions.data(), q);
    m_angles.recall(state, q);
    cache.value = q.calcValue();
    q.calcGradient();
    const bool ofVelocity = m_coordinate->program.getLevel() == KinematicLevel::Velocity;
    cache.rateAtRest = ofVelocity ? cache.value : m_coordinate->getTimeDerivative(q);

    for (size_t k = 0; k < m_markers.size(); ++k) {
        const ConstrainedMarker& m = m_markers[k];
        const Transform& X_AB = getBodyTransformFromState(state, m.body);
        const SpatialVec onMarker = m_coordinate->getDirection(q, cache.motions.data(), int(k));
        cache.directions[m.body] += SimTK::shiftForceBy(onMarker, X_AB.p() - cache.motions[k].X.p());
        m.addModalLoads(state, X_AB, m_coordinate->markers[k].getPose(), onMarker,
                        cache.modalDirections.data() + m.firstCoordinate);
    }
}

// q'' where bodies and coordinates have their velocities and no acceleration.
Real GeneralConstraintImpl::calcBias(const State& state) const {
    getPositionCache(state);
    PositionCache& cache = updPositionCache(state);
    for (size_t k = 0; k < m_markers.size(); ++k) {
        const ConstrainedMarker& m = m_markers[k];
        const Transform& X_AB = getBodyTransformFromState(state, m.body);
        const SpatialVec& V_AB = getBodyVelocityFromState(state, m.body);
        const Transform& X = m_coordinate->markers[k].getPose();
        cache.motions[k].V = m.calcVelocity(state, X_AB, V_AB, X);
        cache.motions[k].A = m.calcAccelerationBias(state, X_AB, V_AB, X);
    }
    m_coordinate->setInputs(state.getTime(), cache.motions.data(), *cache.coordinate);
    m_angles.recall(state, *cache.coordinate);
    const Taylor<Real> q = cache.coordinate->calcTaylor();
    return m_coordinate->program.getLevel() == KinematicLevel::Velocity ? q.first : q.second;
}

Real GeneralConstraintImpl::reduce(Real error) const {
    return m_period > 0 && isHolonomic() ? std::remainder(error, m_period) : error;
}

Taylor<Real> GeneralConstraintImpl::calcFunction(const State& state) const {
    if (!m_function) return {};
    Evaluation& evaluation = *updPositionCache(state).function;
    m_function->setInputs(state.getTime(), nullptr, evaluation);
    return evaluation.calcTaylor();
}

//------------------------------------------------------------------------- what Simbody asks for
template <class Index>
Real GeneralConstraintImpl::multiply(const State& state, const Motions& motions,
                                     const Coordinates<Index>& coordinates) const {
    const PositionCache& cache = getPositionCache(state);
    Real sum = 0;
    for (int b = 0; b < m_numBodies; ++b) {
        const SpatialVec& motion = motions[ConstrainedBodyIndex(b)];
        sum += SimTK::dot(cache.directions[b][0], motion[0]) + SimTK::dot(cache.directions[b][1], motion[1]);
    }
    for (int i = 0; i < m_numCoordinates; ++i) sum += cache.modalDirections[i] * coordinates[Index(i)];
    return sum;
}

template <class Index>
void GeneralConstraintImpl::addForces(const State& state, const Reals& lambda, Motions& forces_A,
                                      Coordinates<Index>& modalForces) const {
    const Real factor = getScale(state) * readMultiplier(lambda[0]);
    if (factor == 0) return;
    const PositionCache& cache = getPositionCache(state);
    for (int b = 0; b < m_numBodies; ++b) forces_A[ConstrainedBodyIndex(b)] += factor * cache.directions[b];
    for (int i = 0; i < m_numCoordinates; ++i) modalForces[Index(i)] += factor * cache.modalDirections[i];
}

void GeneralConstraintImpl::calcPositionErrors(const State& state, const Poses& X_AB,
                                               const Coordinates<ConstrainedQIndex>& coordinates,
                                               Reals& e) const {
    PositionCache& cache = updPositionCache(state);
    for (size_t k = 0; k < m_markers.size(); ++k) {
        const ConstrainedMarker& m = m_markers[k];
        cache.motions[k].X =
            m.calcPose(X_AB[m.body], m_coordinate->markers[k].getPose(), m.findEta(coordinates));
    }
    m_coordinate->setInputs(state.getTime(), cache.motions.data(), *cache.coordinate);
    m_angles.recall(state, *cache.coordinate);
    e[0] = getScale(state) * reduce(cache.coordinate->calcValue() - calcFunction(state).value);
}

void GeneralConstraintImpl::calcPositionDotErrors(const State& state, const Motions& V_AB,
                                                  const Coordinates<ConstrainedQIndex>& qDot,
                                                  Reals& e) const {
    const Real rateAtRest = getPositionCache(state).rateAtRest;
    e[0] = getScale(state) * (multiply(state, V_AB, qDot) + rateAtRest - calcFunction(state).first);
}

void GeneralConstraintImpl::calcPositionDotDotErrors(const State& state, const Motions& A_AB,
                                                     const Coordinates<ConstrainedQIndex>& qDotDot,
                                                     Reals& e) const {
    e[0] = getScale(state) * (multiply(state, A_AB, qDotDot) + getBias(state) - calcFunction(state).second);
}

void GeneralConstraintImpl::addInPositionConstraintForces(const State& state, const Reals& lambda,
                                                          Motions& forces_A,
                                                          Coordinates<ConstrainedQIndex>& qForces) const {
    addForces(state, lambda, forces_A, qForces);
}

void GeneralConstraintImpl::calcVelocityErrors(const State& state, const Motions& V_AB,
                                               const Coordinates<ConstrainedUIndex>& u, Reals& e) const {
    const Real rateAtRest = getPositionCache(state).rateAtRest;
    e[0] = getScale(state) * (multiply(state, V_AB, u) + rateAtRest - calcFunction(state).value);
}

void GeneralConstraintImpl::calcVelocityDotErrors(const State& state, const Motions& A_AB,
                                                  const Coordinates<ConstrainedUIndex>& uDot,
                                                  Reals& e) const {
    e[0] = getScale(state) * (multiply(state, A_AB, uDot) + getBias(state) - calcFunction(state).first);
}

void GeneralConstraintImpl::addInVelocityConstraintForces(const State& state, const Reals& lambda,
                                                          Motions& forces_A,
                                                          Coordinates<ConstrainedUIndex>& uForces) const {
    addForces(state, lambda, forces_A, uForces);
}

void GeneralConstraintImpl::calcAccelerationErrors(const State& state, const Motions& A_AB,
                                                   const Coordinates<ConstrainedUIndex>& uDot,
                                                   Reals& e) const {
    e[0] = getScale(state) * (multiply(state, A_AB, uDot) + getBias(state) - calcFunction(state).value);
}

void GeneralConstraintImpl::addInAccelerationConstraintForces(const State& state, const Reals& lambda,
                                                              Motions& forces_A,
                                                              Coordinates<ConstrainedUIndex>& uForces) const {
    addForces(state, lambda, forces_A, uForces);
}

}  // namespace jprim
