// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/assemble.h"

#include <fmt/format.h>

#include <algorithm>

#include "jprim/base/error.h"
#include "jprim/marker/angles.h"
#include "simulation/initial_velocities.h"

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

/// PART/EXACT as something the Assembler must satisfy: the named ones of the coordinates X, Y, Z [sizes of
/// the part] and PSI, THETA, PHI [rad] of the part's BCS keep their given values.
class ExactCoordinates : public AssemblyCondition {
public:
    explicit ExactCoordinates(const MechanismPart& part)
        : AssemblyCondition(fmt::format("PART/{} EXACT", part.id)), m_part(part) {}

    int calcErrors(const State& state, Vector& errors) const override {
        const Transform X_GB = m_part.body.getBodyTransform(state);
        const Vec3 shift = (X_GB.p() - m_part.givenPose.p()) / m_part.size;
        const Vec3 turn = calcAngles313(X_GB.R()) - calcAngles313(m_part.givenPose.R());
        std::vector<Real> held;
        for (int k = 0; k < 3; ++k)
            if (m_part.exact[k]) held.push_back(shift[k]);
        for (int k = 0; k < 3; ++k)
            if (m_part.exact[3 + k]) held.push_back(std::remainder(turn[k], 2 * SimTK::Pi));
        errors = Vector(int(held.size()), held.data());
        return 0;
    }

private:
    const MechanismPart& m_part;
};

void holdExactCoordinates(const Mechanism& mechanism, Assembler& assembler) {
    for (const MechanismPart& part : mechanism.getParts()) {
        const auto held = std::count(part.exact.begin(), part.exact.end(), true);
        if (part.ground || held == 0) continue;
        if (held == 6)
            assembler.lockMobilizer(part.body.getMobilizedBodyIndex());
        else
            assembler.adoptAssemblyError(new ExactCoordinates(part));
    }
}

// Three points of each part, its size apart, are to stay near where the dataset puts them.
void stayCloseToGivenPoses(const Mechanism& mechanism, const State& state, Assembler& assembler) {
    auto* markers = new Markers();
    assembler.adoptAssemblyGoal(markers);
    SimTK::Array_<Vec3> targets;
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        const Vec3 center = part.cm.getPose().p();
        for (const Vec3& offset : {Vec3(0), Vec3(part.size, 0, 0), Vec3(0, part.size, 0)}) {
            markers->addMarker(part.body.getMobilizedBodyIndex(), center + offset,
                               1 / (part.size * part.size));
            targets.push_back(part.givenPose * (center + offset));
        }
    }
    assembler.initialize(state);
    markers->moveAllObservations(targets);
}

void assemblePositions(const Mechanism& mechanism, State& state) {
    Assembler assembler(mechanism.getSystem());
    assembler.setErrorTolerance(AssemblyTolerance);
    holdExactCoordinates(mechanism, assembler);
    stayCloseToGivenPoses(mechanism, state, assembler);
    try {
        assembler.assemble();
        assembler.updateFromInternalState(state);
    } catch (const std::exception& exception) {
        assembler.updateFromInternalState(state);
        mechanism.getSystem().realize(state, Stage::Position);
        const Violation left = calcViolation(mechanism, state);
        throw Error(
            left.element.empty() ? "assembly" : left.element,
            fmt::format("the parts cannot be assembled from their given positions; an error of {:.3g} m and "
                        "{:.3g} rad is left",
                        left.length, left.angle));
    }
}

std::vector<MovedPart> findMovedParts(const Mechanism& mechanism, const State& state) {
    std::vector<MovedPart> moved;
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        const Transform X_GB = part.body.getBodyTransform(state);
        const Vec3 center = part.cm.getPose().p();
        const Real distance = (X_GB * center - part.givenPose * center).norm();
        const Rotation turn = ~part.givenPose.R() * X_GB.R();
        const Real angle = std::abs(turn.convertRotationToAngleAxis()[0]);
        if (distance > AssemblyTolerance || angle > AssemblyTolerance)
            moved.push_back({part.id, distance, angle});
    }
    return moved;
}

}  // namespace

Violation calcViolation(const Mechanism& mechanism, const State& state) {
    const std::vector<Mechanism::Equation> equations = mechanism.findEquations(state);
    const Vector& errors = state.getQErr();
    Violation violation;
    for (size_t k = 0; k < equations.size(); ++k) {
        const Real error = std::abs(errors[int(k)]);
        if (error > std::max(violation.length, violation.angle)) violation.element = equations[k].element;
        Real& worst = equations[k].isLength ? violation.length : violation.angle;
        worst = std::max(worst, error);
    }
    return violation;
}

AssembledState assemble(const Mechanism& mechanism) {
    const SimTK::MultibodySystem& system = mechanism.getSystem();
    AssembledState result;
    State& state = result.state;
    state = system.realizeTopology();
    system.realizeModel(state);
    system.realize(state, Stage::Position);
    result.before = calcViolation(mechanism, state);
    if (std::max(result.before.length, result.before.angle) > AssemblyTolerance) {
        assemblePositions(mechanism, state);
        system.realize(state, Stage::Position);
    }
    state.updU() = calcInitialVelocities(mechanism, state);
    system.realize(state, Stage::Velocity);
    system.project(state, ProjectionTolerance);
    system.realize(state, Stage::Velocity);
    result.after = calcViolation(mechanism, state);
    result.moved = findMovedParts(mechanism, state);
    return result;
}

}  // namespace jprim
