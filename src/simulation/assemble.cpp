// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/assemble.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "jprim/analysis/constraint_report.h"
#include "simulation/assembly_conditions.h"
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

// In a tree a chain that has to close far away is a bad place to search from. So its positions are sought with all
// parts free, where joints in the tree are equations like others, and then taken over.
std::vector<MissedCoordinate> findPositionsFreely(const Mechanism& mechanism, const AssemblyAim& aim,
                                                  State& state) {
    const std::optional<Mechanism> free = mechanism.makeWithFreeParts();
    if (!free) return findPositions(mechanism, aim, state);
    State found = free->makeGivenState();
    const std::vector<MissedCoordinate> yielded = findPositions(*free, aim, found);
    std::vector<Transform> poses;
    for (size_t k = 0; k < free->getParts().size(); ++k) {
        const MechanismPart& part = free->getParts()[k];
        poses.push_back(part.body.getBodyTransform(found));
        if (part.flexible)
            mechanism.getParts()[k].flexible->setModalCoordinates(state,
                                                                  part.flexible->getModalCoordinates(found));
    }
    mechanism.fitPoses(poses, state);
    return yielded;
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

void finish(const Mechanism& mechanism, AssembledState& result) {
    const SimTK::MultibodySystem& system = mechanism.getSystem();
    system.realize(result.state, Stage::Velocity);
    const State found = result.state;
    try {
        if (!countFreedoms(mechanism.getMatter(), result.state).hasOnlyEmptyHolonomic)
            system.project(result.state, ProjectionTolerance);
    } catch (const std::exception&) {
        checkVelocities(mechanism, result.state);
        result.state =
            found;  // dependent equations may contradict each other by the last digits of a dataset
        system.realize(result.state, Stage::Velocity);
        if (isViolated(calcViolation(mechanism, result.state))) throw;
    }
    system.realize(result.state, Stage::Velocity);
    result.after = calcViolation(mechanism, result.state);
}

}  // namespace

std::string formatAmount(const MissedCoordinate& missed, const UnitSystem& units) {
    return missed.isLength ? fmt::format("{:.3g} length units", missed.amount / units.length)
                           : fmt::format("{:.3g} rad", missed.amount);
}

AssembledState assemble(const Mechanism& mechanism) {
    AssembledState result;
    result.state = mechanism.makeGivenState();
    mechanism.getSystem().realize(result.state, Stage::Position);
    result.before = calcViolation(mechanism, result.state);
    addMisfits(mechanism, result.state, result.before);
    if (isViolated(result.before) || !findMissedInitial(mechanism, result.state, AssemblyTolerance).empty()) {
        AssemblyAim aim;
        for (const MechanismPart& part : mechanism.getParts()) aim.poses.push_back(part.calcGivenBodyPose());
        result.yielded = findPositionsFreely(mechanism, aim, result.state);
        mechanism.getSystem().realize(result.state, Stage::Position);
    }
    result.state.updU() = calcInitialVelocities(mechanism, result.state);
    finish(mechanism, result);
    result.moved = findMovedParts(mechanism, result.state);
    return result;
}

AssembledState reassemble(const Mechanism& mechanism, const State& current) {
    AssembledState result;
    result.state = current;
    mechanism.getSystem().realize(result.state, Stage::Position);
    result.before = calcViolation(mechanism, result.state);
    if (isViolated(result.before)) {
        AssemblyAim aim{{}, false};
        for (const MechanismPart& part : mechanism.getParts())
            aim.poses.push_back(part.body.getBodyTransform(result.state));
        findPositions(mechanism, aim, result.state);
    }
    finish(mechanism, result);
    return result;
}

}  // namespace jprim
