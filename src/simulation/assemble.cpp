// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/assemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "jprim/base/error.h"
#include "simulation/assembly_conditions.h"
#include "simulation/initial_velocities.h"
#include "simulation/redundancy.h"
#include "simulation/violation.h"

namespace jprim {

using SimTK::Assembler;
using SimTK::AssemblyCondition;
using SimTK::Markers;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::Stage;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;
using SimTK::Vector;

namespace {

// Simbody's projection after assembly; well below AssemblyTolerance.
constexpr Real ProjectionTolerance = 1e-11;

enum class Exactness { Required, Wanted };
enum class Bodies { Rigid, Flexible };

/// What an assembly aims at: poses of the parts, in their order, and whether what the dataset holds is held.
struct Aim {
    std::vector<Transform> poses;  // X_GB
    bool holdGiven = true;
};

// Required, EXACT and given coordinates are conditions like constraints. Some of these may repeat what
// constraints already demand, as in a plane mechanism, and Simbody's optimizer takes no more equations than
// unknowns: then they are Wanted far more than closeness, and checked afterwards.
void holdGivenCoordinates(const Mechanism& mechanism, Exactness exactness, Assembler& assembler) {
    constexpr Real MuchMore = 1e8;
    const auto adopt = [&](AssemblyCondition* condition) {
        if (exactness == Exactness::Required)
            assembler.adoptAssemblyError(condition);
        else
            assembler.adoptAssemblyGoal(condition, MuchMore);
    };
    for (const MechanismPart& part : mechanism.getParts()) {
        const auto held = std::count(part.exact.begin(), part.exact.end(), true);
        const bool hangsOnGround = part.body.isGround() || part.body.getParentMobilizedBody().isGround();
        if (held == 6 && hangsOnGround)
            assembler.lockMobilizer(part.body.getMobilizedBodyIndex());
        else if (held > 0)
            adopt(new ExactCoordinates(part));
    }
    const std::vector<InitialCoordinate>& given = mechanism.getInitialCoordinates();
    const auto hasValue = [](const InitialCoordinate& c) { return bool(c.value); };
    if (std::any_of(given.begin(), given.end(), hasValue)) adopt(new GivenCoordinates(given));
}

bool keepsGivenCoordinates(const Mechanism& mechanism, const State& state) {
    constexpr Real Kept = 1e-6;  // sizes of the part, length units, radians
    Vector errors;
    for (const MechanismPart& part : mechanism.getParts()) {
        ExactCoordinates(part).calcErrors(state, errors);
        if (errors.size() > 0 && errors.normInf() > Kept) return false;
    }
    return findCoordinateError(mechanism, state).first <= Kept;
}

// Three points of each part, its size apart, are to stay near their places at the pose aimed at.
void stayCloseTo(const Mechanism& mechanism, const std::vector<Transform>& poses, const State& state,
                 Assembler& assembler) {
    auto* markers = new Markers();
    assembler.adoptAssemblyGoal(markers);
    SimTK::Array_<Vec3> targets;
    for (size_t k = 0; k < poses.size(); ++k) {
        const MechanismPart& part = mechanism.getParts()[k];
        if (part.ground) continue;
        for (const Vec3& point : {Vec3(0), Vec3(part.size, 0, 0), Vec3(0, part.size, 0)}) {
            markers->addMarker(part.body.getMobilizedBodyIndex(), point, 1 / (part.size * part.size));
            targets.push_back(poses[k] * point);
        }
    }
    assembler.initialize(state);
    markers->moveAllObservations(targets);
}

void lockModes(const Mechanism& mechanism, Assembler& assembler) {
    for (const MechanismPart& part : mechanism.getParts())
        if (part.flexible)
            for (const SimTK::MobilizedBodyIndex carrier : part.flexible->getCarriers())
                assembler.lockMobilizer(carrier);
}

bool hasFlexibleBodies(const Mechanism& mechanism) {
    const auto& parts = mechanism.getParts();
    return std::any_of(parts.begin(), parts.end(), [](const MechanismPart& p) { return bool(p.flexible); });
}

// True if it succeeded; the state is as near as it came.
bool tryToAssemble(const Mechanism& mechanism, const Aim& aim, Bodies bodies, Exactness exactness,
                   State& state) {
    Assembler assembler(mechanism.getSystem());
    assembler.setErrorTolerance(AssemblyTolerance);
    if (bodies == Bodies::Rigid) lockModes(mechanism, assembler);
    if (aim.holdGiven) holdGivenCoordinates(mechanism, exactness, assembler);
    stayCloseTo(mechanism, aim.poses, state, assembler);
    bool succeeded = true;
    try {
        assembler.assemble();
    } catch (const Error&) {
        throw;  // an element says what is wrong with it
    } catch (const std::exception&) {
        succeeded = false;
    }
    assembler.updateFromInternalState(state);
    mechanism.getSystem().realize(state, Stage::Position);
    return succeeded && (!aim.holdGiven || keepsGivenCoordinates(mechanism, state));
}

bool tryToAssemble(const Mechanism& mechanism, const Aim& aim, Bodies bodies, State& state) {
    const State given = state;
    if (tryToAssemble(mechanism, aim, bodies, Exactness::Required, state)) return true;
    if (!aim.holdGiven || nameHeld(mechanism).empty()) return false;
    state = given;
    return tryToAssemble(mechanism, aim, bodies, Exactness::Wanted, state);
}

bool isViolated(const Violation& violation) {
    return std::max(violation.length, violation.angle) > AssemblyTolerance;
}

void assemblePositions(const Mechanism& mechanism, const Aim& aim, State& state) {
    const State given = state;
    if (tryToAssemble(mechanism, aim, Bodies::Rigid, state)) return;
    if (hasFlexibleBodies(mechanism)) {
        state = given;
        if (tryToAssemble(mechanism, aim, Bodies::Flexible, state)) return;
    }
    const Violation left = calcViolation(mechanism, state);
    const auto [missed, name] = findCoordinateError(mechanism, state);
    if (aim.holdGiven && !isViolated(left) && missed > AssemblyTolerance)
        throw Error(
            name, fmt::format("its initial value contradicts the constraints or other given coordinates; the "
                              "nearest that can be assembled misses it by {:.3g} length units or rad",
                              missed));
    const std::string held = aim.holdGiven ? nameHeld(mechanism) : "";
    throw Error(
        left.element.empty() ? "assembly" : left.element,
        fmt::format("the parts cannot be assembled from their given positions; an error of {:.3g} length "
                    "units of the dataset and {:.3g} rad is left{}",
                    left.length / mechanism.getUnits().length, left.angle,
                    held.empty() ? "" : fmt::format(", while {} are held", held)));
}

// Simbody's optimizer counts an equation that no motion changes as one unknown less. Where there are no others they
// step aside, if they are satisfied before and after. Returns false if that is not so.
bool assembleWithoutEmpty(const Mechanism& mechanism, const Aim& aim, State& state) {
    const auto holdNothing = [](const ConstraintCount& count) {
        return count.numEquations > 0 && count.rank == 0;
    };
    if (isViolated(calcViolation(mechanism, state)) ||
        !holdNothing(countFreedoms(mechanism.getMatter(), state)))
        return false;
    const DroppedEquations dropped(mechanism, state, DropChoice::Later);
    assemblePositions(mechanism, aim, state);
    dropped.restore(state);
    mechanism.getSystem().realize(state, Stage::Position);
    return !isViolated(calcViolation(mechanism, state));
}

void assemblePositions(const Mechanism& mechanism, const Aim& aim, AssembledState& result) {
    const bool misplaced =
        aim.holdGiven && findCoordinateError(mechanism, result.state).first > AssemblyTolerance;
    if (!isViolated(result.before) && !misplaced) return;
    if (assembleWithoutEmpty(mechanism, aim, result.state)) return;
    assemblePositions(mechanism, aim, result.state);
    mechanism.getSystem().realize(result.state, Stage::Position);
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
    try {
        system.project(result.state, ProjectionTolerance);
    } catch (const std::exception&) {
        checkVelocities(mechanism, result.state);
        throw;
    }
    system.realize(result.state, Stage::Velocity);
    result.after = calcViolation(mechanism, result.state);
}

}  // namespace

AssembledState assemble(const Mechanism& mechanism) {
    AssembledState result;
    result.state = mechanism.makeGivenState();
    mechanism.getSystem().realize(result.state, Stage::Position);
    result.before = calcViolation(mechanism, result.state);
    addMisfits(mechanism, result.state, result.before);
    Aim aim;
    for (const MechanismPart& part : mechanism.getParts()) aim.poses.push_back(part.calcGivenBodyPose());
    assemblePositions(mechanism, aim, result);
    result.state.updU() = calcInitialVelocities(mechanism, result.state);
    finish(mechanism, result);
    result.moved = findMovedParts(mechanism, result.state);
    return result;
}

AssembledState reassemble(const Mechanism& mechanism, const State& current) {
    AssembledState result;
    result.state = current;
    Aim aim;
    aim.holdGiven = false;
    mechanism.getSystem().realize(result.state, Stage::Position);
    result.before = calcViolation(mechanism, result.state);
    for (const MechanismPart& part : mechanism.getParts())
        aim.poses.push_back(part.body.getBodyTransform(result.state));
    assemblePositions(mechanism, aim, result);
    finish(mechanism, result);
    return result;
}

}  // namespace jprim
