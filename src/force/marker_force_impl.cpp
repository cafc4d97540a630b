// SPDX-License-Identifier: Apache-2.0
#include "force/marker_force_impl.h"

#include "base/format.h"
#include "jprim/base/error.h"
#include "jprim/marker/marker_pair.h"
#include "marker/require_on_body.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;
using SimTK::Vector;

std::string findForceProblem(KinematicLevel level) {
    return level < KinematicLevel::Acceleration
               ? ""
               : "a force cannot depend on accelerations or reactions, which are known only when all forces are";
}

namespace {

std::optional<TrackedExpression> take(const std::optional<Expression>& expression, bool isVector,
                                      const char* what, const SimTK::System& system,
                                      const std::string& element) {
    if (!expression) return std::nullopt;
    const Program& program = expression->getImplementation().program;
    if (program.isVector() != isVector)
        throw Error(element, fmt::format("its {} must be a {}", what, isVector ? "vector" : "number"));
    const int neededDerivatives = isVector ? 0 : 1;  // the rate of a potential
    for (const std::string& problem :
         {findForceProblem(program.getLevel()),
          expression->getImplementation().findDerivativeProblem(neededDerivatives)})
        if (!problem.empty()) throw Error(element, problem);
    if (!isVector && program.getLevel() != KinematicLevel::Position)
        throw Error(element, fmt::format("its {} depends on velocities; an energy that is stored depends on "
                                         "positions and TIME only",
                                         what));
    requireInSystem(*expression, system, element);
    return TrackedExpression(*expression);
}

std::string describe(const std::string& name) {
    return name.empty() ? "force" : name;
}

}  // namespace

MarkerForceImpl::MarkerForceImpl(SimTK::GeneralForceSubsystem& forces, const Marker& I,
                                 const std::optional<Marker>& J, const ForceLaw& law, const std::string& name)
    : m_name(name), m_I(I), m_J(J) {
    const std::string element = describe(name);
    const SimTK::System& system = findSystem(forces, element);
    m_forces = &forces.getSubsystemGuts();
    requireInSystem(I, "marker I", system, element);
    if (J) requireInSystem(*J, "marker J", system, element);
    m_force = take(law.force, true, "force", system, element);
    m_moment = take(law.moment, true, "moment", system, element);
    m_potential = take(law.potential, false, "potential", system, element);
}

std::string MarkerForceImpl::getDescription() const {
    return describe(m_name);
}

// SimTK::Force::isDisabled() asks by the handle through which the force was added, which may be gone.
bool MarkerForceImpl::isDisabled(const State& state, SimTK::ForceIndex index) const {
    const auto& forces = static_cast<const SimTK::GeneralForceSubsystem&>(findHandle(*m_forces));
    return forces.isForceDisabled(state, index);
}

void MarkerForceImpl::realizeTopology(State& state) const {
    for (auto* expression : {&m_force, &m_moment, &m_potential})
        if (*expression) (*expression)->allocate(findHandle(*m_forces), state);
}

int MarkerForceImpl::getNumAngles() const {
    int sum = 0;
    for (const auto* expression : {&m_force, &m_moment, &m_potential})
        if (*expression) sum += (*expression)->getAngles().getNumAngles();
    return sum;
}

Vector MarkerForceImpl::getTurns(const State& state) const {
    Vector turns(getNumAngles());
    int first = 0;
    for (const auto* expression : {&m_force, &m_moment, &m_potential}) {
        if (!*expression) continue;
        const Vector part = (*expression)->getAngles().getTurns(state);
        turns(first, part.size()) = part;
        first += part.size();
    }
    return turns;
}

void MarkerForceImpl::setTurns(State& state, const Vector& turns) const {
    checkTurns(turns, getNumAngles(), m_name);
    int first = 0;
    for (const auto* expression : {&m_force, &m_moment, &m_potential}) {
        if (!*expression) continue;
        const AngleMemory& angles = (*expression)->getAngles();
        angles.setTurns(state, turns(first, angles.getNumAngles()), m_name);
        first += angles.getNumAngles();
    }
}

SpatialVec MarkerForceImpl::calcLoadOnI(const State& state) const {
    return {m_moment ? m_moment->calcVector(state) : Vec3(0), m_force ? m_force->calcVector(state) : Vec3(0)};
}

namespace {

SpatialVec calcOpposite(const State& state, const SpatialVec& onI, const Marker& I, const Marker& J) {
    const Vec3 r = I.findPoseInGround(state).p() - J.findPoseInGround(state).p();
    return calcOppositeLoad(onI, r);
}

}  // namespace

SpatialVec MarkerForceImpl::calcLoadOnJ(const State& state) const {
    return m_J ? calcOpposite(state, calcLoadOnI(state), m_I, *m_J) : SpatialVec(Vec3(0), Vec3(0));
}

void MarkerForceImpl::calcForce(const State& state, SimTK::Vector_<SpatialVec>& bodyForces,
                                SimTK::Vector_<Vec3>&, SimTK::Vector& mobilityForces) const {
    const SpatialVec onI = calcLoadOnI(state);
    m_I.applyLoad(state, onI, bodyForces, mobilityForces);
    if (m_J) m_J->applyLoad(state, calcOpposite(state, onI, m_I, *m_J), bodyForces, mobilityForces);
}

Real MarkerForceImpl::calcPower(const State& state) const {
    const SpatialVec onI = calcLoadOnI(state);
    Real power = ~onI * m_I.findVelocityInGround(state);
    if (m_J) power += ~calcOpposite(state, onI, m_I, *m_J) * m_J->findVelocityInGround(state);
    return power + calcPotentialRate(state);
}

void MarkerForceImpl::addSwitches(const State& state,
                                  std::vector<TrackedExpression::Switch>& switches) const {
    for (const auto* expression : {&m_force, &m_moment})
        if (*expression) (*expression)->addSwitches(state, false, switches);
}

std::vector<const MarkerExpression*> MarkerForceImpl::getExpressions() const {
    std::vector<const MarkerExpression*> expressions;
    for (const auto* expression : {&m_force, &m_moment})
        if (*expression) expressions.push_back(&(*expression)->get());
    return expressions;
}

Real MarkerForceImpl::calcPotentialRate(const State& state) const {
    return m_potential ? m_potential->calcRate(state) : 0;
}

Real MarkerForceImpl::calcPotentialEnergy(const State& state) const {
    return m_potential ? m_potential->calcValue(state) : 0;
}

}  // namespace jprim
