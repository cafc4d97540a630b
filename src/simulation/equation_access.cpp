// SPDX-License-Identifier: Apache-2.0
#include "simulation/equation_access.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/equation_loads.h"

namespace jprim {

using SimTK::Real;
using SimTK::State;
using SimTK::Vec3;

EquationAccess::EquationAccess(const Mechanism& mechanism, const ConstraintEquation& equation)
    : m_number(equation.number) {
    for (const Element& element : mechanism.getElements()) {
        const SimTK::Constraint* constraint = element.getConstraint();
        if (!constraint || constraint->getConstraintIndex() != equation.constraint) continue;
        const Joint* joint = element.getJoint();
        if (joint && joint->getPairConstraint())
            m_pair = *joint->getPairConstraint();
        else
            m_general = joint ? *joint->getGeneralConstraint() : *element.getGeneralConstraint();
        return;
    }
    throw std::logic_error(equation.getText() + " is of no element");
}

void EquationAccess::setScale(State& state, Real scale) const {
    m_pair ? m_pair->setEquationScale(state, m_number, scale) : m_general->setEquationScale(state, scale);
}

Real EquationAccess::calcError(const State& state) const {
    return m_pair ? m_pair->calcEquationError(state, m_number) : m_general->calcEquationError(state);
}

namespace {

// Of each speed, as if its body moved alone.
std::vector<Real> calcInertias(const SimTK::SimbodyMatterSubsystem& matter, const State& state) {
    std::vector<Real> inertias(size_t(state.getNU()));
    for (SimTK::MobilizedBodyIndex b(1); b < matter.getNumBodies(); ++b) {
        const SimTK::MobilizedBody& body = matter.getMobilizedBody(b);
        for (SimTK::MobilizerUIndex k(0); k < body.getNumU(state); ++k) {
            const SimTK::SpatialVec H = body.getHCol(state, k);
            inertias[size_t(body.getFirstUIndex(state) + k)] =
                ~H * (body.getBodySpatialInertiaInGround(state) * H);
        }
    }
    return inertias;
}

// What a load does to bodies and mobilities as if they hung on nothing: the acceleration along it.
Real calcFreeResponse(const SimTK::SimbodyMatterSubsystem& matter, const State& state,
                      const std::vector<Real>& inertias, const EquationLoads& loads) {
    Real response = 0;
    for (const auto& [b, load] : loads.onBodies) {
        if (b == SimTK::GroundIndex) continue;
        const SimTK::MobilizedBody& body = matter.getMobilizedBody(b);
        const SimTK::MassProperties& mass = body.getBodyMassProperties(state);
        const SimTK::Rotation& R_GB = body.getBodyRotation(state);
        const SimTK::SpatialVec F = SimTK::shiftForceBy(load, R_GB * mass.getMassCenter());
        if (mass.getMass() > 0) response += F[1].normSqr() / mass.getMass();
        const Vec3 moment = ~R_GB * F[0];
        const Real turning = ~moment * (mass.calcCentralInertia().toMat33() * moment);
        if (turning > 0) response += SimTK::square(moment.normSqr()) / turning;
    }
    for (const auto& [speed, f] : loads.onSpeeds)
        if (inertias[size_t(speed)] > 0) response += f * f / inertias[size_t(speed)];
    return response;
}

// Simbody weighs an error by the weight of its equation before it holds it against a tolerance.
void weighErrors(const Mechanism& mechanism, State& state) {
    mechanism.getSystem().realize(state, SimTK::Stage::Instance);
    for (const ConstraintEquation& equation : mechanism.findEquations(state)) {
        if (equation.isDropped() || equation.level == KinematicLevel::Acceleration) continue;
        state.updUErrWeights()[equation.multiplier] = 1 / equation.scale;
        if (equation.level == KinematicLevel::Position)
            state.updQErrWeights()[equation.multiplier] = 1 / equation.scale;
    }
    mechanism.getSystem().realize(state, SimTK::Stage::Position);
}

// What one unit of each multiplier does along its equation, as if its bodies hung on nothing.
std::vector<Real> calcFreeResponses(const SimTK::SimbodyMatterSubsystem& matter, const State& state,
                                    const std::vector<ConstraintEquation>& equations) {
    std::vector<Real> responses;
    const std::vector<Real> inertias = calcInertias(matter, state);
    for (const EquationLoads& loads : calcEquationLoads(matter, state, equations))
        responses.push_back(calcFreeResponse(matter, state, inertias, loads));
    return responses;
}

// By the root of the responses, if they differ: where they do not, the load that redundant equations share stays that of
// the least norm of forces and torques.
void multiplyScales(const Mechanism& mechanism, State& state,
                    const std::vector<ConstraintEquation>& equations, const std::vector<Real>& responses) {
    constexpr Real Alike = 1e4;  // Simbody loses what is 1e12 times smaller
    Real least = SimTK::Infinity, most = 0;
    for (const Real response : responses) {
        if (response > 0) least = std::min(least, response);
        most = std::max(most, response);
    }
    if (most <= Alike * least) return;
    for (size_t k = 0; k < equations.size(); ++k) {
        if (!(responses[k] > 0) || equations[k].isDropped()) continue;
        const Real factor = std::exp2(std::round(-std::log2(responses[k]) / 2));
        EquationAccess(mechanism, equations[k]).setScale(state, factor * equations[k].scale);
    }
    weighErrors(mechanism, state);
}

}  // namespace

void setEquationScales(const Mechanism& mechanism, State& state) {
    const ElementList& elements = mechanism.getElements();
    if (std::any_of(elements.begin(), elements.end(), [](const Element& e) { return e.inTree; })) return;
    const std::vector<ConstraintEquation> equations = mechanism.findEquations(state);
    multiplyScales(mechanism, state, equations, calcFreeResponses(mechanism.getMatter(), state, equations));
}

// What is left of an equation that a tree leaves nothing to do stays as small as it is.
void setEquationScalesHere(const Mechanism& mechanism, State& state) {
    constexpr Real Nothing = 1e-14;  // the square of a singular value that is in doubt
    const std::vector<ConstraintEquation> equations = mechanism.findEquations(state);
    std::vector<Real> responses = calcFreeResponses(mechanism.getMatter(), state, equations);
    SimTK::Matrix inTree;
    mechanism.getMatter().calcProjectedMInv(state, inTree);
    for (size_t k = 0; k < equations.size(); ++k) {
        const Real response = inTree(equations[k].multiplier, equations[k].multiplier);
        if (response > Nothing * responses[k]) responses[k] = response;
    }
    multiplyScales(mechanism, state, equations, responses);
}

void restoreDroppedEquations(const Mechanism& mechanism, State& state) {
    mechanism.getSystem().realize(state, SimTK::Stage::Instance);
    for (const ConstraintEquation& equation : mechanism.findEquations(state))
        if (equation.isDropped()) EquationAccess(mechanism, equation).setScale(state, 1);
}

void resetEquationScales(const Mechanism& mechanism, State& state) {
    for (const ConstraintEquation& equation : mechanism.findEquations(state))
        if (!equation.isDropped()) EquationAccess(mechanism, equation).setScale(state, 1);
    weighErrors(mechanism, state);
}

}  // namespace jprim
