// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/assemble.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/format.h"
#include "jprim/analysis/constraint_report.h"
#include "simulation/assembly_conditions.h"
#include "simulation/equation_access.h"
#include "simulation/find_positions.h"
#include "simulation/initial_velocities.h"
#include "simulation/projection.h"
#include "simulation/violation.h"

namespace jprim {

using SimTK::Real;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vector;

namespace {

bool isViolated(const Violation& violation) {
    return std::max(violation.length, violation.angle) > AssemblyTolerance;
}

State makeGivenState(const Mechanism& mechanism, const std::set<ElementId>& switchedOff) {
    State state = mechanism.makeGivenState();
    for (const ElementId& id : switchedOff) mechanism.getElement(id).disable(state);
    return state;
}

// In a tree a chain that has to close far away is a bad place to search from. So its positions are sought with all
// parts free, where joints in the tree are equations like others, and then taken over.
FoundPositions findPositionsFreely(const Mechanism& mechanism, const AssemblyAim& aim,
                                   const std::set<ElementId>& switchedOff, State& state) {
    const std::optional<Mechanism> free = mechanism.makeWithFreeParts();
    if (!free) return findPositions(mechanism, aim, state);
    State found = makeGivenState(*free, switchedOff);
    const FoundPositions positions = findPositions(*free, aim, found);
    std::vector<Transform> poses;
    for (size_t k = 0; k < free->getParts().size(); ++k) {
        const MechanismPart& part = free->getParts()[k];
        poses.push_back(part.body.getBodyTransform(found));
        if (part.flexible)
            mechanism.getParts()[k].flexible->setModalCoordinates(state,
                                                                  part.flexible->getModalCoordinates(found));
    }
    mechanism.fitPoses(poses, state);
    mechanism.getSystem().realize(state, Stage::Position);
    if (positions.leftOut.empty() && !isViolated(calcViolation(mechanism, state))) return positions;
    return findPositions(mechanism, aim, state);  // without equations of its own
}

// Equations that agree on positions may contradict each other on velocities, as two MOTIONs of one joint. Names the
// one that is left farthest from being met.
void checkVelocities(const Mechanism& mechanism, State& state) {
    constexpr Real Contradiction = 1e-8;
    mechanism.getSystem().realize(state, Stage::Velocity);
    const Vector& errors = state.getUErr();
    Real worst = Contradiction;
    std::string element;
    for (int k = 0; k < errors.size(); ++k) {
        if (std::abs(errors[k]) <= worst) continue;
        worst = std::abs(errors[k]);
        element = mechanism.findEquations(state).at(size_t(k)).element;
    }
    if (!element.empty())
        throw Error(element,
                    fmt::format("no velocities at the start satisfy it together with the other constraints; "
                                "{:.3g} length units/s or rad/s of it are left",
                                worst));
}

AssemblyAim aimAtPresent(const Mechanism& mechanism, const State& state) {
    AssemblyAim aim{{}, false};
    for (const MechanismPart& part : mechanism.getParts())
        aim.poses.push_back(part.body.getBodyTransform(state));
    return aim;
}

void leaveOut(const Mechanism& mechanism, const FoundPositions& found, AssembledState& result) {
    result.leftOut.insert(result.leftOut.end(), found.leftOut.begin(), found.leftOut.end());
    mechanism.getSystem().realize(result.state, Stage::Position);
}

bool hasNothingToProject(const Mechanism& mechanism, const State& state) {
    return countFreedoms(mechanism.getMatter(), state).hasOnlyEmptyHolonomic;
}

// Onto the equations to rounding. What was rounded in a dataset may contradict itself by less than AssemblyTolerance.
// True if there is something to project.
bool settlePositions(const Mechanism& mechanism, AssembledState& result) {
    if (hasNothingToProject(mechanism, result.state)) return false;
    const SimTK::MultibodySystem& system = mechanism.getSystem();
    const State found = result.state;
    try {
        system.projectQ(result.state, ProjectionTolerance);
        return true;
    } catch (const std::exception&) {
        result.state = found;
        system.realize(result.state, Stage::Position);
    }
    AssemblyAim aim = aimAtPresent(mechanism, result.state);
    aim.tolerance = ProjectionTolerance;
    try {
        leaveOut(mechanism, findPositions(mechanism, aim, result.state), result);
    } catch (const AssemblyError&) {
        result.state = found;
        system.realize(result.state, Stage::Position);
        if (isViolated(calcViolation(mechanism, result.state))) throw;
    }
    return !hasNothingToProject(mechanism, result.state);
}

void finish(const Mechanism& mechanism, bool hasToProject, AssembledState& result) {
    const SimTK::MultibodySystem& system = mechanism.getSystem();
    system.realize(result.state, Stage::Velocity);
    const State found = result.state;
    try {
        if (hasToProject) system.projectU(result.state, ProjectionTolerance);
    } catch (const std::exception&) {
        checkVelocities(mechanism, result.state);
        result.state = found;
    }
    system.realize(result.state, Stage::Velocity);
    result.after = calcViolation(mechanism, result.state);
    for (const ConstraintEquation& equation : result.leftOut)
        keepWorst(result.after, equation, EquationAccess(mechanism, equation).calcError(result.state));
}

}  // namespace

std::string formatAmount(const MissedCoordinate& missed, const UnitSystem& units) {
    return fmt::format("{:.3g} {}", missed.amount / units.getDisplacement(missed.dimension),
                       getUnitName(missed.dimension));
}

AssembledState assemble(const Mechanism& mechanism) {
    return assemble(mechanism, {});
}

AssembledState assemble(const Mechanism& mechanism, const std::set<ElementId>& switchedOff) {
    AssembledState result;
    result.state = makeGivenState(mechanism, switchedOff);
    mechanism.getSystem().realize(result.state, Stage::Position);
    result.before = calcViolation(mechanism, result.state);
    addMisfits(mechanism, result.state, result.before);
    if (isViolated(result.before) || !findMissedInitial(mechanism, result.state, AssemblyTolerance).empty()) {
        AssemblyAim aim;
        for (const MechanismPart& part : mechanism.getParts()) aim.poses.push_back(part.calcGivenBodyPose());
        const FoundPositions found = findPositionsFreely(mechanism, aim, switchedOff, result.state);
        result.yielded = found.yielded;
        leaveOut(mechanism, found, result);
    }
    const bool hasToProject = settlePositions(mechanism, result);
    result.state.updU() = calcInitialVelocities(mechanism, result.state);
    finish(mechanism, hasToProject, result);
    result.moved = findMovedParts(mechanism, result.state);
    return result;
}

AssembledState reassemble(const Mechanism& mechanism, const State& current) {
    AssembledState result;
    result.state = current;
    restoreDroppedEquations(mechanism, result.state);  // what was left out may be needed now
    mechanism.getSystem().realize(result.state, Stage::Position);
    result.before = calcViolation(mechanism, result.state);
    if (isViolated(result.before))
        leaveOut(mechanism, findPositions(mechanism, aimAtPresent(mechanism, result.state), result.state),
                 result);
    const bool hasToProject = settlePositions(mechanism, result);
    finish(mechanism, hasToProject, result);
    return result;
}

}  // namespace jprim
