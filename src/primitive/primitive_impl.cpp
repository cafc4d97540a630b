// SPDX-License-Identifier: Apache-2.0
#include "primitive/primitive_impl.h"

#include <fmt/format.h>

#include <algorithm>

#include "jprim/base/error.h"

namespace jprim {

using SimTK::Array_;
using SimTK::CacheEntryIndex;
using SimTK::ConstrainedBodyIndex;
using SimTK::ConstrainedQIndex;
using SimTK::MobilizedBody;
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
    for (const auto& [marker, letter] : {std::pair(&I, 'I'), std::pair(&J, 'J')})
        if (!marker->isOnBody())
            throw Error(element, fmt::format("marker {} is not on a body; construct it with a MobilizedBody "
                                             "that has been added to a matter subsystem",
                                             letter));
    const SimbodyMatterSubsystem& matter = I.getBody().getMatterSubsystem();
    if (&matter.getSystem() != &J.getBody().getMatterSubsystem().getSystem())
        throw Error(element, "markers I and J belong to different systems; put both bodies into one");
    if (I.getBody().getMobilizedBodyIndex() == J.getBody().getMobilizedBodyIndex())
        throw Error(element, fmt::format("markers I and J are both on body {}; a primitive acts between two "
                                         "different bodies",
                                         int(I.getBody().getMobilizedBodyIndex())));
    return const_cast<SimbodyMatterSubsystem&>(matter);  // adding a constraint is what the caller asked for
}

}  // namespace

PrimitiveImpl::PrimitiveImpl(const char* adamsType, Kind kind, int numEquations, const Marker& I,
                             const Marker& J, const std::string& name)
    : Implementation(findMatter(I, J, describe(adamsType, name)), numEquations, 0, 0),
      m_name(name),
      m_adamsType(adamsType),
      m_isTranslational(kind == Kind::Translational),
      m_numEquations(numEquations),
      m_bodyI(addConstrainedBody(I.getBody())),
      m_bodyJ(addConstrainedBody(J.getBody())),
      m_defaults{I.getPose(), J.getPose()} {}

std::string PrimitiveImpl::getDescription() const {
    return describe(m_adamsType, m_name);
}

const MobilizedBody& PrimitiveImpl::getBodyI() const {
    return getMatterSubsystem().getMobilizedBody(getMobilizedBodyIndexOfConstrainedBody(m_bodyI));
}

const MobilizedBody& PrimitiveImpl::getBodyJ() const {
    return getMatterSubsystem().getMobilizedBody(getMobilizedBodyIndexOfConstrainedBody(m_bodyJ));
}

//------------------------------------------------------------------------------------------ State
// Simbody reads the rows of every constraint once per multiplier of the whole system, so they are looked up
// with as little ceremony as a State allows: SimTK's checked downcasts and validity tests cost more than the
// dot products that follow. We allocated the values ourselves, and they are valid from their stage on
// because realizePosition() and realizeVelocity() below fill them.
namespace {
template <class T>
T& updEntry(const State& state, SimTK::SubsystemIndex subsystem, CacheEntryIndex index) {
    return static_cast<Value<T>&>(state.updCacheEntry(subsystem, index)).upd();
}
}  // namespace

void PrimitiveImpl::realizeTopology(State& state) const {
    const SimbodyMatterSubsystem& matter = getMatterSubsystem();
    m_subsystem = matter.getMySubsystemIndex();
    m_placements = matter.allocateDiscreteVariable(state, Stage::Position, new Value<Placements>(m_defaults));
    m_positionCache = matter.allocateCacheEntry(state, Stage::Position, new Value<PositionCache>());
    m_bias = matter.allocateCacheEntry(state, Stage::Velocity, new Value<Errors>());
}

void PrimitiveImpl::realizePosition(const State& state) const {
    calcPositionCache(state, updEntry<PositionCache>(state, m_subsystem, m_positionCache));
}

void PrimitiveImpl::realizeVelocity(const State& state) const {
    updEntry<Errors>(state, m_subsystem, m_bias) = calcBodyBias(state);
}

void PrimitiveImpl::setDefaultPlacements(const Placements& placements) {
    invalidateTopologyCache();
    m_defaults = placements;
}

const PrimitiveImpl::Placements& PrimitiveImpl::getPlacements(const State& state) const {
    return static_cast<const Value<Placements>&>(state.getDiscreteVariable(m_subsystem, m_placements)).get();
}

PrimitiveImpl::Placements& PrimitiveImpl::updPlacements(State& state) const {
    return static_cast<Value<Placements>&>(state.updDiscreteVariable(m_subsystem, m_placements)).upd();
}

// Some of Simbody's operators run on a State whose positions are known while its stage is still lower.
const PrimitiveImpl::PositionCache& PrimitiveImpl::getPositionCache(const State& state) const {
    PositionCache& cache = updEntry<PositionCache>(state, m_subsystem, m_positionCache);
    if (state.getSubsystemStage(m_subsystem) < Stage::Position) calcPositionCache(state, cache);
    return cache;
}

const PrimitiveImpl::Errors& PrimitiveImpl::getBias(const State& state) const {
    Errors& bias = updEntry<Errors>(state, m_subsystem, m_bias);
    if (state.getSubsystemStage(m_subsystem) < Stage::Velocity) bias = calcBodyBias(state);
    return bias;
}

//------------------------------------------------------------------------- from markers to bodies
// A load d = [t, f] on I at I's origin, moved to the origin of I's body, and its opposite to that of J's:
//     momentI = t + s_I x f      momentJ = -t - (r + s_J) x f
// so that by virtue of power de/dt = momentI.w_I + momentJ.w_J + f.(v_I - v_J) for the bodies' velocities.
void PrimitiveImpl::calcPositionCache(const State& state, PositionCache& cache) const {
    const Placements& placements = getPlacements(state);
    const Transform& X_ABI = getBodyTransformFromState(state, m_bodyI);
    const Transform& X_ABJ = getBodyTransformFromState(state, m_bodyJ);
    const MarkerPair pair(X_ABI * placements.X_BI, X_ABJ * placements.X_BJ);
    const Vec3 s_I = X_ABI.R() * placements.X_BI.p();
    const Vec3 s_J = X_ABJ.R() * placements.X_BJ.p();

    calcDirections(pair, cache.directions);
    for (int k = 0; k < m_numEquations; ++k) {
        const SpatialVec onI = SimTK::shiftForceBy(pair.calcLoadOnI(cache.directions[k]), -s_I);
        const SpatialVec onJ = SimTK::shiftForceBy(pair.calcLoadOnJ(cache.directions[k]), -s_J);
        cache.rows[k] = {onI[0], onJ[0], onI[1]};
    }
}

// d2e/dt2 where the bodies have their velocities and no acceleration.
PrimitiveImpl::Errors PrimitiveImpl::calcBodyBias(const State& state) const {
    const Placements& placements = getPlacements(state);
    const Transform& X_ABI = getBodyTransformFromState(state, m_bodyI);
    const Transform& X_ABJ = getBodyTransformFromState(state, m_bodyJ);
    const SpatialVec& V_ABI = getBodyVelocityFromState(state, m_bodyI);
    const SpatialVec& V_ABJ = getBodyVelocityFromState(state, m_bodyJ);
    const MarkerPair pair(X_ABI * placements.X_BI, X_ABJ * placements.X_BJ);
    const Vec3 s_I = X_ABI.R() * placements.X_BI.p();
    const Vec3 s_J = X_ABJ.R() * placements.X_BJ.p();

    const SpatialVec V_AI = SimTK::shiftVelocityBy(V_ABI, s_I);
    const SpatialVec V_AJ = SimTK::shiftVelocityBy(V_ABJ, s_J);
    const SpatialVec zero(Vec3(0), Vec3(0));
    const SpatialVec A_AI = SimTK::shiftAccelerationBy(zero, V_ABI[0], s_I);
    const SpatialVec A_AJ = SimTK::shiftAccelerationBy(zero, V_ABJ[0], s_J);
    const SpatialVec A_J = pair.calcAcceleration(V_AI, V_AJ, A_AI, A_AJ);

    Errors bias(0);
    calcBias(pair, pair.calcVelocity(V_AI, V_AJ), bias);
    const Directions& d = getPositionCache(state).directions;
    for (int k = 0; k < m_numEquations; ++k)
        bias[k] += SimTK::dot(d[k][0], A_J[0]) + SimTK::dot(d[k][1], A_J[1]);
    return bias;
}

//------------------------------------------------------------------------- what Simbody asks for
// A torque is the same about every point: a rotational row has no force and opposite moments.
Real PrimitiveImpl::multiply(const Row& row, const SpatialVec& motionI, const SpatialVec& motionJ) const {
    if (!m_isTranslational) return SimTK::dot(row.momentI, motionI[0] - motionJ[0]);
    return SimTK::dot(row.momentI, motionI[0]) + SimTK::dot(row.momentJ, motionJ[0]) +
           SimTK::dot(row.force, motionI[1] - motionJ[1]);
}

void PrimitiveImpl::calcPositionErrors(const State& state,
                                       const Array_<Transform, ConstrainedBodyIndex>& X_AB,
                                       const Array_<Real, ConstrainedQIndex>&, Array_<Real>& perr) const {
    const Placements& placements = getPlacements(state);
    Errors e;
    calcErrors(MarkerPair(X_AB[m_bodyI] * placements.X_BI, X_AB[m_bodyJ] * placements.X_BJ), e);
    for (int k = 0; k < m_numEquations; ++k) perr[k] = e[k];
}

void PrimitiveImpl::calcPositionDotErrors(const State& state,
                                          const Array_<SpatialVec, ConstrainedBodyIndex>& V_AB,
                                          const Array_<Real, ConstrainedQIndex>&, Array_<Real>& pverr) const {
    const PositionCache& cache = getPositionCache(state);
    const SpatialVec& V_I = V_AB[m_bodyI];
    const SpatialVec& V_J = V_AB[m_bodyJ];
    for (int k = 0; k < m_numEquations; ++k) pverr[k] = multiply(cache.rows[k], V_I, V_J);
}

void PrimitiveImpl::calcPositionDotDotErrors(const State& state,
                                             const Array_<SpatialVec, ConstrainedBodyIndex>& A_AB,
                                             const Array_<Real, ConstrainedQIndex>&,
                                             Array_<Real>& paerr) const {
    const PositionCache& cache = getPositionCache(state);
    const Errors& bias = getBias(state);
    const SpatialVec& A_I = A_AB[m_bodyI];
    const SpatialVec& A_J = A_AB[m_bodyJ];
    for (int k = 0; k < m_numEquations; ++k) paerr[k] = multiply(cache.rows[k], A_I, A_J) + bias[k];
}

void PrimitiveImpl::addInPositionConstraintForces(const State& state, const Array_<Real>& multipliers,
                                                  Array_<SpatialVec, ConstrainedBodyIndex>& bodyForcesInA,
                                                  Array_<Real, ConstrainedQIndex>&) const {
    const Real* lambda = multipliers.cbegin();
    const auto isZero = [](Real value) { return value == 0; };
    if (std::all_of(lambda, lambda + m_numEquations, isZero)) return;

    const PositionCache& cache = getPositionCache(state);
    SpatialVec& onI = bodyForcesInA[m_bodyI];
    SpatialVec& onJ = bodyForcesInA[m_bodyJ];
    for (int k = 0; k < m_numEquations; ++k) {
        const Row& row = cache.rows[k];
        onI[0] += lambda[k] * row.momentI;
        onJ[0] += lambda[k] * row.momentJ;
        if (!m_isTranslational) continue;
        onI[1] += lambda[k] * row.force;
        onJ[1] -= lambda[k] * row.force;
    }
}

// Simbody's multipliers are minus the applied load.
SpatialVec PrimitiveImpl::calcLoadOnI(const State& state, const MarkerPair& pair) const {
    Array_<Real> lambda;
    getMultipliers(state, lambda);
    Directions d;
    calcDirections(pair, d);
    SpatialVec load(Vec3(0), Vec3(0));
    for (int k = 0; k < m_numEquations; ++k) load -= lambda[k] * d[k];
    return load;
}

// Both triads, and through I's origin each constrained direction: red for a force, magenta for a torque.
void PrimitiveImpl::calcDecorativeGeometryAndAppend(const State& state, Stage stage,
                                                    Array_<SimTK::DecorativeGeometry>& geometry) const {
    if (stage != Stage::Position) return;
    constexpr Real TriadSize = 0.1, DirectionSize = 0.15;
    const Placements& placements = getPlacements(state);
    const Transform X_GI = getBodyI().getBodyTransform(state) * placements.X_BI;
    const Transform X_GJ = getBodyJ().getBodyTransform(state) * placements.X_BJ;
    for (const auto& [X_GM, colour] : {std::pair(X_GI, SimTK::Orange), std::pair(X_GJ, SimTK::Blue)})
        geometry.push_back(SimTK::DecorativeFrame(TriadSize).setTransform(X_GM).setColor(colour));

    const MarkerPair pair(X_GI, X_GJ);
    Directions d;
    calcDirections(pair, d);
    for (int k = 0; k < m_numEquations; ++k) {
        const SpatialVec load = pair.calcLoadOnI(d[k]);
        const bool isForce = load[1].normSqr() > 0;
        const Vec3 direction = isForce ? load[1] : load[0];
        if (direction.normSqr() == 0) continue;
        const Vec3 half = DirectionSize * direction.normalize();
        geometry.push_back(SimTK::DecorativeLine(X_GI.p() - half, X_GI.p() + half)
                               .setColor(isForce ? SimTK::Red : SimTK::Magenta)
                               .setLineThickness(3));
    }
}

}  // namespace jprim
