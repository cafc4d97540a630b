// SPDX-License-Identifier: Apache-2.0
#include "primitive/pair_constraint_impl.h"

#include <algorithm>

#include "base/format.h"
#include "marker/cache_entry.h"
#include "marker/read_multiplier.h"
#include "marker/require_on_body.h"

namespace jprim {

using SimTK::Array_;
using SimTK::CacheEntryIndex;
using SimTK::ConstrainedBodyIndex;
using SimTK::ConstrainedQIndex;
using SimTK::Real;
using SimTK::SimbodyMatterSubsystem;
using SimTK::SpatialVec;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Value;
using SimTK::Vec3;

namespace {

std::string describe(const char* adamsType, const std::string& name) {
    return name.empty() ? adamsType : fmt::format("{} {}", name, adamsType);
}

// Simbody would notice these mistakes only when the topology is realized, without saying whose they are.
SimbodyMatterSubsystem& findMatter(const Marker& I, const Marker& J, const std::string& element) {
    requireTwoBodies(I, J, element);
    // Adding a constraint is what the caller asked for.
    return const_cast<SimbodyMatterSubsystem&>(I.getBody().getMatterSubsystem());
}

int countEquations(const PairConstraintImpl::Parts& parts) {
    int count = 0;
    for (const PairEquations* part : parts) count += part->getNumEquations();
    return count;
}

}  // namespace

PairConstraintImpl::PairConstraintImpl(const char* adamsType, const Parts& parts, const Marker& I,
                                       const Marker& J, const std::string& name)
    : Implementation(findMatter(I, J, describe(adamsType, name)), countEquations(parts), 0, 0),
      m_name(name),
      m_adamsType(adamsType),
      m_parts(parts),
      m_defaultI(I),
      m_defaultJ(J),
      m_I(addMarker(I)),
      m_J(addMarker(J)) {
    for (const PairEquations* part : parts)
        for (int k = 0; k < part->getNumEquations(); ++k)
            m_equations.push_back({part->describe(k), part->isTranslational()});
}

ConstrainedMarker PairConstraintImpl::addMarker(const Marker& marker) {
    const ConstrainedMarker added{addConstrainedBody(marker.getBody()), marker.getNode(), m_numCoordinates};
    m_numCoordinates += added.getNumCoordinates();
    if (!added.node) return added;
    for (const SimTK::MobilizedBodyIndex carrier : added.node->getCoordinates().getCarriers())
        addConstrainedMobilizer(getMatterSubsystem().getMobilizedBody(carrier));
    return added;
}

std::string PairConstraintImpl::getDescription() const {
    return describe(m_adamsType, m_name);
}

//------------------------------------------------------------------------------------------ State
// Our entries are valid from their stage on because realizePosition() and realizeVelocity() below fill them.
void PairConstraintImpl::realizeTopology(State& state) const {
    const SimbodyMatterSubsystem& matter = getMatterSubsystem();
    m_subsystem = matter.getMySubsystemIndex();
    m_placements = matter.allocateDiscreteVariable(state, Stage::Position,
                                                   new Value<Placements>(getDefaultPlacements()));
    PositionCache cache;
    cache.modalRows.resize(size_t(getNumEquations() * m_numCoordinates));
    m_positionCache = matter.allocateCacheEntry(state, Stage::Position, new Value<PositionCache>(cache));
    m_bias = matter.allocateCacheEntry(state, Stage::Velocity, new Value<Errors>());
}

void PairConstraintImpl::realizePosition(const State& state) const {
    calcPositionCache(state, updEntry<PositionCache>(state, m_subsystem, m_positionCache));
}

void PairConstraintImpl::realizeVelocity(const State& state) const {
    updEntry<Errors>(state, m_subsystem, m_bias) = calcBodyBias(state);
}

void PairConstraintImpl::setDefaultPlacements(const Placements& placements) {
    invalidateTopologyCache();
    m_defaultI = getMarkerI(placements.I);
    m_defaultJ = getMarkerJ(placements.J);
}

const PairConstraintImpl::Placements& PairConstraintImpl::getPlacements(const State& state) const {
    return static_cast<const Value<Placements>&>(state.getDiscreteVariable(m_subsystem, m_placements)).get();
}

PairConstraintImpl::Placements& PairConstraintImpl::updPlacements(State& state) const {
    return static_cast<Value<Placements>&>(state.updDiscreteVariable(m_subsystem, m_placements)).upd();
}

// Some of Simbody's operators run on a State whose positions are known while its stage is still lower.
const PairConstraintImpl::PositionCache& PairConstraintImpl::getPositionCache(const State& state) const {
    PositionCache& cache = updEntry<PositionCache>(state, m_subsystem, m_positionCache);
    if (state.getSubsystemStage(m_subsystem) < Stage::Position) calcPositionCache(state, cache);
    return cache;
}

const PairConstraintImpl::Errors& PairConstraintImpl::getBias(const State& state) const {
    Errors& bias = updEntry<Errors>(state, m_subsystem, m_bias);
    if (state.getSubsystemStage(m_subsystem) < Stage::Velocity) bias = calcBodyBias(state);
    return bias;
}

//---------------------------------------------------------------------------------- the equations
namespace {

// Has each part write where the one before it ended.
template <class Output, class Calc>
void calcInTurn(const PairConstraintImpl::Parts& parts, Output* next, const Calc& calc) {
    for (const PairEquations* part : parts) {
        calc(*part, next);
        next += part->getNumEquations();
    }
}

}  // namespace

void PairConstraintImpl::calcErrors(const MarkerPair& pair, Errors& e) const {
    calcInTurn(m_parts, e.data(),
               [&](const PairEquations& part, Real* ofPart) { part.calcErrors(pair, ofPart); });
}

void PairConstraintImpl::calcDirections(const MarkerPair& pair, Directions& d) const {
    calcInTurn(m_parts, d.data(),
               [&](const PairEquations& part, SpatialVec* ofPart) { part.calcDirections(pair, ofPart); });
}

//------------------------------------------------------------------------- from markers to bodies
// A load d = [t, f] on I at I's origin, moved to the origin of I's body, and its opposite to that of J's:
//     momentI = t + s_I x f      momentJ = -t - (r + s_J) x f
// so that by virtue of power de/dt = momentI.w_I + momentJ.w_J + f.(v_I - v_J) for the bodies' velocities,
// plus for flexible markers what the two loads do to each coordinate times its rate.
void PairConstraintImpl::calcPositionCache(const State& state, PositionCache& cache) const {
    const Placements& placements = getPlacements(state);
    const Transform& X_ABI = getBodyTransformFromState(state, m_I.body);
    const Transform& X_ABJ = getBodyTransformFromState(state, m_J.body);
    const Transform X_AI = m_I.calcPose(X_ABI, placements.I, m_I.getEta(state));
    const Transform X_AJ = m_J.calcPose(X_ABJ, placements.J, m_J.getEta(state));
    const MarkerPair pair(X_AI, X_AJ);

    calcDirections(pair, cache.directions);
    for (size_t k = 0; k < m_equations.size(); ++k) cache.directions[k] *= placements.scales[k];
    std::fill(cache.modalRows.begin(), cache.modalRows.end(), 0);
    Real* modal = cache.modalRows.data();
    for (int k = 0; k < getNumEquations(); ++k) {
        const SpatialVec F_I = pair.calcLoadOnI(cache.directions[size_t(k)]);
        const SpatialVec F_J = pair.calcLoadOnJ(cache.directions[size_t(k)]);
        const SpatialVec onI = SimTK::shiftForceBy(F_I, X_ABI.p() - X_AI.p());
        const SpatialVec onJ = SimTK::shiftForceBy(F_J, X_ABJ.p() - X_AJ.p());
        cache.rows[size_t(k)] = {onI[0], onJ[0], onI[1]};
        m_I.addModalLoads(state, X_ABI, placements.I, F_I, modal);
        m_J.addModalLoads(state, X_ABJ, placements.J, F_J, modal + m_I.getNumCoordinates());
        modal += m_numCoordinates;
    }
}

// d2e/dt2 where the bodies and coordinates have their velocities and no acceleration.
PairConstraintImpl::Errors PairConstraintImpl::calcBodyBias(const State& state) const {
    const Placements& placements = getPlacements(state);
    const Transform& X_ABI = getBodyTransformFromState(state, m_I.body);
    const Transform& X_ABJ = getBodyTransformFromState(state, m_J.body);
    const SpatialVec& V_ABI = getBodyVelocityFromState(state, m_I.body);
    const SpatialVec& V_ABJ = getBodyVelocityFromState(state, m_J.body);
    const MarkerPair pair = findPair(state);

    const SpatialVec V_AI = m_I.calcVelocity(state, X_ABI, V_ABI, placements.I);
    const SpatialVec V_AJ = m_J.calcVelocity(state, X_ABJ, V_ABJ, placements.J);
    const SpatialVec A_AI = m_I.calcAccelerationBias(state, X_ABI, V_ABI, placements.I);
    const SpatialVec A_AJ = m_J.calcAccelerationBias(state, X_ABJ, V_ABJ, placements.J);
    const SpatialVec A_J = pair.calcAcceleration(V_AI, V_AJ, A_AI, A_AJ);

    const SpatialVec V_J = pair.calcVelocity(V_AI, V_AJ);
    Errors bias{};
    calcInTurn(m_parts, bias.data(),
               [&](const PairEquations& part, Real* ofPart) { part.calcBias(pair, V_J, ofPart); });
    const Directions& d = getPositionCache(state).directions;
    for (size_t k = 0; k < m_equations.size(); ++k)
        bias[k] = placements.scales[k] * bias[k] + SimTK::dot(d[k][0], A_J[0]) + SimTK::dot(d[k][1], A_J[1]);
    return bias;
}

MarkerPair PairConstraintImpl::findPair(const State& state) const {
    const Placements& placements = getPlacements(state);
    return {m_I.calcPose(getBodyTransformFromState(state, m_I.body), placements.I, m_I.getEta(state)),
            m_J.calcPose(getBodyTransformFromState(state, m_J.body), placements.J, m_J.getEta(state))};
}

//------------------------------------------------------------------------- what Simbody asks for
// A torque is the same about every point: a rotational row has no force and opposite moments.
Real PairConstraintImpl::multiply(const PositionCache& cache, int equation,
                                  const Array_<SpatialVec, ConstrainedBodyIndex>& motions,
                                  const Array_<Real, ConstrainedQIndex>& coordinates) const {
    const Row& row = cache.rows[size_t(equation)];
    const SpatialVec& motionI = motions[m_I.body];
    const SpatialVec& motionJ = motions[m_J.body];
    Real sum = m_equations[size_t(equation)].isTranslational
                   ? SimTK::dot(row.momentI, motionI[0]) + SimTK::dot(row.momentJ, motionJ[0]) +
                         SimTK::dot(row.force, motionI[1] - motionJ[1])
                   : SimTK::dot(row.momentI, motionI[0] - motionJ[0]);
    const Real* modal = cache.modalRows.data() + equation * m_numCoordinates;
    for (int i = 0; i < m_numCoordinates; ++i) sum += modal[i] * coordinates[ConstrainedQIndex(i)];
    return sum;
}

void PairConstraintImpl::calcPositionErrors(const State& state,
                                            const Array_<Transform, ConstrainedBodyIndex>& X_AB,
                                            const Array_<Real, ConstrainedQIndex>& constrainedQ,
                                            Array_<Real>& perr) const {
    const Placements& placements = getPlacements(state);
    Errors e{};
    calcErrors(MarkerPair(m_I.calcPose(X_AB[m_I.body], placements.I, m_I.findEta(constrainedQ)),
                          m_J.calcPose(X_AB[m_J.body], placements.J, m_J.findEta(constrainedQ))),
               e);
    for (int k = 0; k < getNumEquations(); ++k) perr[k] = placements.scales[size_t(k)] * e[size_t(k)];
}

void PairConstraintImpl::calcPositionDotErrors(const State& state,
                                               const Array_<SpatialVec, ConstrainedBodyIndex>& V_AB,
                                               const Array_<Real, ConstrainedQIndex>& constrainedQDot,
                                               Array_<Real>& pverr) const {
    const PositionCache& cache = getPositionCache(state);
    for (int k = 0; k < getNumEquations(); ++k) pverr[k] = multiply(cache, k, V_AB, constrainedQDot);
}

void PairConstraintImpl::calcPositionDotDotErrors(const State& state,
                                                  const Array_<SpatialVec, ConstrainedBodyIndex>& A_AB,
                                                  const Array_<Real, ConstrainedQIndex>& constrainedQDotDot,
                                                  Array_<Real>& paerr) const {
    const PositionCache& cache = getPositionCache(state);
    const Errors& bias = getBias(state);
    for (int k = 0; k < getNumEquations(); ++k)
        paerr[k] = multiply(cache, k, A_AB, constrainedQDotDot) + bias[size_t(k)];
}

void PairConstraintImpl::addInPositionConstraintForces(
    const State& state, const Array_<Real>& multipliers,
    Array_<SpatialVec, ConstrainedBodyIndex>& bodyForcesInA, Array_<Real, ConstrainedQIndex>& qForces) const {
    const auto isZero = [](Real value) { return value == 0; };
    if (std::all_of(multipliers.begin(), multipliers.end(), isZero)) return;

    const PositionCache& cache = getPositionCache(state);
    SpatialVec& onI = bodyForcesInA[m_I.body];
    SpatialVec& onJ = bodyForcesInA[m_J.body];
    for (int k = 0; k < getNumEquations(); ++k) {
        const Real lambda = readMultiplier(multipliers[unsigned(k)]);
        if (lambda == 0) continue;
        const Row& row = cache.rows[size_t(k)];
        onI[0] += lambda * row.momentI;
        onJ[0] += lambda * row.momentJ;
        const Real* modal = cache.modalRows.data() + k * m_numCoordinates;
        for (int i = 0; i < m_numCoordinates; ++i) qForces[ConstrainedQIndex(i)] += lambda * modal[i];
        if (!m_equations[size_t(k)].isTranslational) continue;
        onI[1] += lambda * row.force;
        onJ[1] -= lambda * row.force;
    }
}

// Simbody's multipliers are minus the applied load.
SpatialVec PairConstraintImpl::calcLoadOnI(const State& state, const MarkerPair& pair) const {
    Array_<Real> lambda;
    getMultipliers(state, lambda);
    Directions d;
    calcDirections(pair, d);
    SpatialVec load(Vec3(0), Vec3(0));
    const Placements& placements = getPlacements(state);
    for (int k = 0; k < getNumEquations(); ++k)
        load -= readMultiplier(lambda[k]) * placements.scales[size_t(k)] * d[size_t(k)];
    return load;
}

}  // namespace jprim
