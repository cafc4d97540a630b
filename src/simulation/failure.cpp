// SPDX-License-Identifier: Apache-2.0
#include "simulation/failure.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "jprim/analysis/conflicts.h"
#include "jprim/analysis/constraint_report.h"
#include "jprim/base/error.h"
#include "simulation/stall_watch.h"
#include "simulation/undefined_force.h"

namespace jprim {

using SimTK::Real;
using SimTK::Stage;
using SimTK::State;

namespace {

// Of Simbody's messages.
constexpr const char *TooShort = "Unable to advance time past",
                     *NotProjected = "Failed to achieve required accuracy";

// CPodes', whose reasons are many.
constexpr const char* NoStep = "Integrator step failed";

constexpr const char* NotFinite = "accelerations are not finite";

Real findLargest(const SimTK::Vector& v) {
    return v.size() > 0 ? v.normInf() : 0;
}

// The largest acceleration that the applied loads would give the mobilizers without constraints.
Real calcUnconstrainedAcceleration(const Mechanism& mechanism, const State& state) {
    const SimTK::MultibodySystem& system = mechanism.getSystem();
    SimTK::Vector loads, accelerations;
    mechanism.getMatter().multiplyBySystemJacobianTranspose(
        state, system.getRigidBodyForces(state, Stage::Dynamics), loads);
    loads += system.getMobilityForces(state, Stage::Dynamics);
    mechanism.getMatter().multiplyByMInv(state, loads, accelerations);
    return findLargest(accelerations);
}

}  // namespace

void checkAccelerations(const Mechanism& mechanism, const std::vector<ConstraintEquation>& equations,
                        const State& state, bool isKinematic) {
    // Dependent equations go together as well as positions are met: to the integrator's tolerance, or to rounding.
    const Real lost = isKinematic ? 1e-7 : 1e-4;
    constexpr Real Rounding = 1e-9;
    // What is there to be lost: accelerations, gravity, and the centripetal ones of a steady turn.
    const Real accelerations = findLargest(state.getUDot()) + mechanism.getGravity().norm() +
                               SimTK::square(findLargest(state.getU()));
    if (!std::isfinite(accelerations + state.getUDot().norm())) throw std::runtime_error(NotFinite);
    const auto findViolated = [&](Real tolerance) {
        return std::find_if(equations.begin(), equations.end(), [&](const ConstraintEquation& equation) {
            return std::abs(equation.getError(state.getUDotErr())) > tolerance;
        });
    };
    Real tolerance = lost * accelerations;
    if (findViolated(tolerance) == equations.end()) return;
    tolerance += Rounding * calcUnconstrainedAcceleration(mechanism, state);
    const auto violated = findViolated(tolerance);
    if (violated == equations.end()) return;
    throw std::runtime_error(
        fmt::format("the accelerations violate {}: it conflicts with other constraints, or masses and "
                    "inertias are too different to solve for",
                    violated->element));
}

bool isNearSingular(const Mechanism& mechanism, const State& state) {
    constexpr Real Near = 0.05;
    const ConstraintCount count = countFreedoms(mechanism.getMatter(), state);
    return count.rank > 0 && count.smallestKept < Near;
}

bool isStuck(const std::exception& exception) {
    const std::string text = exception.what();
    return text.find(TooShort) != std::string::npos || text.find(NotProjected) != std::string::npos;
}

namespace {

bool hasNoStep(const std::string& reason) {
    return reason.find(TooShort) != std::string::npos || reason.find(NoStep) != std::string::npos ||
           reason == NoStepIsShortEnough;
}

// Simbody's messages run over several lines, and the commonest of them says nothing of what it means.
std::string rephrase(std::string text) {
    if (text.find(TooShort) != std::string::npos) return NoStepIsShortEnough;
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

// Simbody's integrators take an element's complaint for a step that was too long, try shorter ones, and give up
// for that reason; where they stop the elements are asked again. Empty if none complains.
std::string findComplaint(const Mechanism& mechanism, State state) {
    try {
        mechanism.getSystem().realize(state, Stage::Position);
        for (const Element& element : mechanism.getElements()) {
            const GeneralConstraint* constraint = element.getGeneralConstraint();
            if (!constraint || constraint->isDisabled(state)) continue;
            const std::string problem = constraint->findProblem(state);
            if (!problem.empty()) return element.getName() + ": " + problem;
        }
    } catch (const Error& error) {
        return error.what();
    } catch (const std::exception&) {
        // A State that cannot be realized tells no more.
    }
    return "";
}

// Of what Simbody says where a number is none.
bool isNotFinite(const std::string& reason) {
    return reason.find(NotFinite) != std::string::npos || reason.find("NaN") != std::string::npos ||
           reason.find("ODE function") != std::string::npos;
}

// Where no step is short enough because a function is not defined behind it. Integrators that meet no numbers give up
// some steps before.
std::string findUndefined(const Mechanism& mechanism, const State& state, const std::string& reason) {
    for (const Real moment : {1e-9, 1e-6, 1e-3, 1e-2, 0.1}) {
        if (moment > 1e-3 && !isNotFinite(reason)) break;
        State later = state;
        later.updTime() += moment;
        const std::string complaint = findComplaint(mechanism, later);
        if (!complaint.empty()) return complaint;
        const std::string name = findUndefinedForce(mechanism, state, moment);
        if (!name.empty()) return fmt::format("{}: {}", name, WhatIsUndefined);
    }
    return "";
}

// Where no step is short enough because a force jumps.
std::string findJump(const Mechanism& mechanism, const State& state) {
    for (const Real moment : {1e-9, 1e-6, 1e-3}) {
        const std::string name = findJumpingForce(mechanism, state, moment);
        if (!name.empty()) return fmt::format("{}: {}", name, WhatJumpingDoes);
    }
    return "";
}

// The equation with the largest error, in words, with the error.
std::string describeLargestError(const Mechanism& mechanism, const State& state) {
    std::string text;
    Real largest = 0;
    for (const ConstraintEquation& equation :
         findEquations(mechanism.getMatter(), state, mechanism.getElementNames())) {
        if (equation.level != KinematicLevel::Position) continue;
        const Real error = std::abs(equation.getError(state.getQErr()));
        if (error <= largest) continue;
        largest = error;
        text = fmt::format("; the largest constraint error is {:.3g} {} at {}",
                           error / mechanism.getUnits().getDisplacement(equation.dimension),
                           getUnitName(equation.dimension), equation.getText());
    }
    return text;
}

// Equations that time is about to set against each other. The State that a simulation failed at satisfies them
// still.
std::string describeConflict(const Mechanism& mechanism, const State& state) {
    constexpr Real Moment = 0.01;
    State later = state;
    later.updTime() += Moment * std::max(1., std::abs(state.getTime()));
    mechanism.getSystem().realize(later, Stage::Position);
    const ConflictReport report = findConflicts(mechanism.getMatter(), later, mechanism.getElementNames());
    std::string names;
    for (const Conflict& conflict : report.conflicts)
        for (const int equation : conflict.equations)
            names += (names.empty() ? "" : ", ") + report.equations[size_t(equation)].getText();
    return names.empty() ? "" : "; a moment later these cannot be met together: " + names;
}

// Empty unless equations depend on each other here, or nearly so, that do not nearby.
std::string describeSingularity(const Mechanism& mechanism, const State& state) {
    constexpr Real Close = 1e-2;
    const ConstraintReport report = analyzeConstraints(mechanism.getMatter(), state);
    if (report.isSingularPosition())
        return fmt::format(
            "; this is a singular position with {} degrees of freedom, where nearby there are {}",
            report.getDegreesOfFreedom(), report.freedomsNearby);
    if (report.rank == 0 || report.smallestKept > Close) return "";
    return fmt::format("; this is close to a singular position (smallest singular value {:.1g})",
                       report.smallestKept);
}

}  // namespace

std::string describeFailure(const Mechanism& mechanism, const State& state, const std::exception& exception) {
    const std::string reason = exception.what();
    std::string why = findComplaint(mechanism, state), where;
    if (why.empty() && dynamic_cast<const Error*>(&exception)) why = reason;
    try {
        mechanism.getSystem().realize(state, Stage::Position);
        if (why.empty() && (hasNoStep(reason) || isNotFinite(reason)))
            why = findUndefined(mechanism, state, reason);
        if (why.empty() && hasNoStep(reason)) why = findJump(mechanism, state);
        if (why.empty())
            where = describeSingularity(mechanism, state) + describeLargestError(mechanism, state) +
                    describeConflict(mechanism, state);
    } catch (const std::exception&) {
        // Nothing more can be said about a State that cannot be realized.
    }
    return fmt::format("at time {:.6g}: the simulation cannot go on{}: {}",
                       state.getTime() / mechanism.getUnits().time, where,
                       why.empty() ? rephrase(reason) : why);
}

}  // namespace jprim
