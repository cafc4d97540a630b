// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/assemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

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
///
/// 3-1-3 angles are singular where z stands upright, as in every plane mechanism. There PSI and PHI are both
/// the turn about z, and THETA is held by not tilting z.
class ExactCoordinates : public AssemblyCondition {
public:
    explicit ExactCoordinates(const MechanismPart& part)
        : AssemblyCondition(part.name + " EXACT"), m_part(part) {}

    int calcErrors(const State& state, Vector& errors) const override {
        const Transform X_GP = m_part.bcs.findPoseInGround(state);
        std::vector<Real> held;
        for (int k = 0; k < 3; ++k)
            if (m_part.exact[k]) held.push_back((X_GP.p()[k] - m_part.givenPose.p()[k]) / m_part.size);
        addTurns(X_GP.R(), held);
        errors = Vector(int(held.size()), held.data());
        return 0;
    }

private:
    void addTurns(const Rotation& R_GP, std::vector<Real>& held) const {
        constexpr Real Upright = 1e-6;
        const Vec3 given = calcAngles313(m_part.givenPose.R());
        const auto [psi, theta, phi] = std::tuple(m_part.exact[3], m_part.exact[4], m_part.exact[5]);
        const Rotation turn = ~m_part.givenPose.R() * R_GP;
        if (psi && theta && phi) {
            const SimTK::Quaternion q = turn.convertRotationToQuaternion();
            held.insert(held.end(), {2 * q[1], 2 * q[2], 2 * q[3]});
        } else if (std::sin(given[1]) < Upright) {
            if (psi || phi) held.push_back(std::atan2(turn[1][0] - turn[0][1], turn[0][0] + turn[1][1]));
            if (theta) held.insert(held.end(), {turn[0][2], turn[1][2]});
        } else {
            const Vec3 change = calcAngles313(R_GP) - given;
            for (int k = 0; k < 3; ++k)
                if (m_part.exact[3 + k]) held.push_back(std::remainder(change[k], 2 * SimTK::Pi));
        }
    }

    const MechanismPart& m_part;
};

// The parts with EXACT coordinates, for messages; empty if there is none.
std::string nameExactParts(const Mechanism& mechanism) {
    std::string names;
    for (const MechanismPart& part : mechanism.getParts()) {
        const bool isExact = std::find(part.exact.begin(), part.exact.end(), true) != part.exact.end();
        if (isExact) names += (names.empty() ? "" : ", ") + part.name;
    }
    return names;
}

enum class Exactness { Required, Wanted };
enum class Bodies { Rigid, Flexible };

// Required, EXACT is a condition like a constraint's. Some of these may repeat what constraints already
// demand, as in a plane mechanism, and Simbody's optimizer takes no more equations than unknowns: then EXACT
// is Wanted far more than closeness, and checked afterwards.
void holdExactCoordinates(const Mechanism& mechanism, Exactness exactness, Assembler& assembler) {
    constexpr Real MuchMore = 1e8;
    for (const MechanismPart& part : mechanism.getParts()) {
        const auto held = std::count(part.exact.begin(), part.exact.end(), true);
        if (held == 0) continue;
        if (held == 6)
            assembler.lockMobilizer(part.body.getMobilizedBodyIndex());
        else if (exactness == Exactness::Required)
            assembler.adoptAssemblyError(new ExactCoordinates(part));
        else
            assembler.adoptAssemblyGoal(new ExactCoordinates(part), MuchMore);
    }
}

bool keepsExactCoordinates(const Mechanism& mechanism, const State& state) {
    constexpr Real Kept = 1e-6;  // sizes of the part, radians
    Vector errors;
    for (const MechanismPart& part : mechanism.getParts()) {
        ExactCoordinates(part).calcErrors(state, errors);
        if (errors.size() > 0 && errors.normInf() > Kept) return false;
    }
    return true;
}

// Three points of each part, its size apart, are to stay near where the dataset puts them.
void stayCloseToGivenPoses(const Mechanism& mechanism, const State& state, Assembler& assembler) {
    auto* markers = new Markers();
    assembler.adoptAssemblyGoal(markers);
    SimTK::Array_<Vec3> targets;
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        const Transform X_GB = part.calcGivenBodyPose();
        for (const Vec3& point : {Vec3(0), Vec3(part.size, 0, 0), Vec3(0, part.size, 0)}) {
            markers->addMarker(part.body.getMobilizedBodyIndex(), point, 1 / (part.size * part.size));
            targets.push_back(X_GB * point);
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
bool tryToAssemble(const Mechanism& mechanism, Bodies bodies, Exactness exactness, State& state) {
    Assembler assembler(mechanism.getSystem());
    assembler.setErrorTolerance(AssemblyTolerance);
    if (bodies == Bodies::Rigid) lockModes(mechanism, assembler);
    holdExactCoordinates(mechanism, exactness, assembler);
    stayCloseToGivenPoses(mechanism, state, assembler);
    bool succeeded = true;
    try {
        assembler.assemble();
    } catch (const std::exception&) {
        succeeded = false;
    }
    assembler.updateFromInternalState(state);
    mechanism.getSystem().realize(state, Stage::Position);
    return succeeded && keepsExactCoordinates(mechanism, state);
}

bool tryToAssemble(const Mechanism& mechanism, Bodies bodies, bool hasExact, State& state) {
    const State given = state;
    if (tryToAssemble(mechanism, bodies, Exactness::Required, state)) return true;
    if (!hasExact) return false;
    state = given;
    return tryToAssemble(mechanism, bodies, Exactness::Wanted, state);
}

void assemblePositions(const Mechanism& mechanism, State& state) {
    const State given = state;
    const std::string exact = nameExactParts(mechanism);
    if (tryToAssemble(mechanism, Bodies::Rigid, !exact.empty(), state)) return;
    if (hasFlexibleBodies(mechanism)) {
        state = given;
        if (tryToAssemble(mechanism, Bodies::Flexible, !exact.empty(), state)) return;
    }
    const Violation left = calcViolation(mechanism, state);
    throw Error(
        left.element.empty() ? "assembly" : left.element,
        fmt::format("the parts cannot be assembled from their given positions; an error of {:.3g} length "
                    "units of the dataset and {:.3g} rad is left{}",
                    left.length / mechanism.getUnits().length, left.angle,
                    exact.empty() ? "" : fmt::format(", with coordinates of {} held by EXACT", exact)));
}

std::vector<MovedPart> findMovedParts(const Mechanism& mechanism, const State& state) {
    std::vector<MovedPart> moved;
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        const Transform X_GB = part.body.getBodyTransform(state);
        const Transform given = part.calcGivenBodyPose();
        const Real distance = (X_GB.p() - given.p()).norm();
        const Rotation turn = ~given.R() * X_GB.R();
        const Real angle = std::abs(turn.convertRotationToAngleAxis()[0]);
        if (distance > AssemblyTolerance || angle > AssemblyTolerance)
            moved.push_back({part.name, distance, angle});
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
