// SPDX-License-Identifier: Apache-2.0
#include "simulation/assembly_conditions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "jprim/marker/angles.h"
#include "simulation/coordinate_direction.h"

namespace jprim {

using SimTK::Real;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;
using SimTK::Vector;

namespace {

constexpr std::array<const char*, 6> ExactNames = {"X", "Y", "Z", "PSI", "THETA", "PHI"};

bool hasExact(const MechanismPart& part) {
    return std::find(part.exact.begin(), part.exact.end(), true) != part.exact.end();
}

bool isUpright(const MechanismPart& part) {
    constexpr Real Upright = 1e-6;
    return std::sin(calcAngles313(part.givenPose.R())[1]) < Upright;
}

// How far z is tilted from where it was given, along x and y of there; and the turn about it.
struct Tilt {
    explicit Tilt(const Rotation& turn)
        : x(turn[0][2]), y(turn[1][2]), about(std::atan2(turn[1][0] - turn[0][1], turn[0][0] + turn[1][1])) {}
    Real x, y, about;
};

Vec3 calcChange313(const Rotation& R, const Rotation& given) {
    const Vec3 change = calcAngles313(R) - calcAngles313(given);
    const auto wrap = [](Real angle) { return std::remainder(angle, 2 * SimTK::Pi); };
    return Vec3(wrap(change[0]), wrap(change[1]), wrap(change[2]));
}

void sortByAmount(std::vector<MissedCoordinate>& missed) {
    std::stable_sort(missed.begin(), missed.end(),
                     [](const auto& a, const auto& b) { return a.amount > b.amount; });
}

}  // namespace

//------------------------------------------------------------------------------------------------ EXACT
std::vector<Real> ExactCoordinates::calcErrors(const Transform& X_GP) const {
    std::vector<Real> held;
    for (int k = 0; k < 3; ++k)
        if (m_part.exact[size_t(k)]) held.push_back(X_GP.p()[k] - m_part.givenPose.p()[k]);
    const bool psi = m_part.exact[3], theta = m_part.exact[4], phi = m_part.exact[5];
    const Rotation turn = ~m_part.givenPose.R() * X_GP.R();
    if (psi && theta && phi) {
        const SimTK::Quaternion q = turn.convertRotationToQuaternion();
        held.insert(held.end(), {2 * q[1], 2 * q[2], 2 * q[3]});
    } else if (isUpright(m_part)) {
        const Tilt tilt(turn);
        if (psi || phi) held.push_back(tilt.about);
        if (theta) held.insert(held.end(), {tilt.x, tilt.y});
    } else {
        const Vec3 change = calcChange313(X_GP.R(), m_part.givenPose.R());
        for (int k = 0; k < 3; ++k)
            if (m_part.exact[size_t(3 + k)]) held.push_back(change[k]);
    }
    return held;
}

Vector ExactCoordinates::calcErrors(const State& state) const {
    const std::vector<Real> errors = calcErrors(m_part.bcs.findPoseInGround(state));
    return Vector(int(errors.size()), errors.data());
}

// By central differences of the pose: exact to 1e-10, which costs a search no step.
void ExactCoordinates::addDirections(const State& state, int equation, Directions& directions) const {
    constexpr Real Step = 1e-5;
    const Transform X_GP = m_part.bcs.findPoseInGround(state);
    SpatialVec direction;
    for (int k = 0; k < 3; ++k) {
        const auto calcTurned = [&](Real by) {
            const Rotation R(by, SimTK::CoordinateAxis(k));
            return calcErrors(Transform(R * X_GP.R(), X_GP.p()))[size_t(equation)];
        };
        const auto calcShifted = [&](Real by) {
            Vec3 p = X_GP.p();
            p[k] += by * m_part.size;
            return calcErrors(Transform(X_GP.R(), p))[size_t(equation)];
        };
        direction[0][k] = (calcTurned(Step) - calcTurned(-Step)) / (2 * Step);
        direction[1][k] = (calcShifted(Step) - calcShifted(-Step)) / (2 * Step * m_part.size);
    }
    m_part.bcs.applyLoad(state, direction, directions.onBodies, directions.onSpeeds);
}

std::vector<MissedCoordinate> findMissedExact(const Mechanism& mechanism, const State& state,
                                              Real tolerance) {
    std::vector<MissedCoordinate> missed;
    for (const MechanismPart& part : mechanism.getParts()) {
        if (!hasExact(part)) continue;
        const Transform X_GP = part.bcs.findPoseInGround(state);
        const Vec3 shift = X_GP.p() - part.givenPose.p();
        Vec3 turn = calcChange313(X_GP.R(), part.givenPose.R());
        if (isUpright(part)) {
            const Tilt tilt(~part.givenPose.R() * X_GP.R());
            turn = Vec3(part.exact[3] ? tilt.about : 0, std::hypot(tilt.x, tilt.y),
                        part.exact[3] ? 0 : tilt.about);
        }
        for (int k = 0; k < 6; ++k) {
            const Real amount = std::abs(k < 3 ? shift[k] : turn[k - 3]);
            if (part.exact[size_t(k)] && amount > tolerance * (k < 3 ? part.size : 1))
                missed.push_back({part.name, std::string("EXACT ") + ExactNames[size_t(k)], amount,
                                  k < 3 ? Dimension::Length : Dimension::Angle});
        }
    }
    sortByAmount(missed);
    return missed;
}

PositionConditions makeExactConditions(const Mechanism& mechanism) {
    PositionConditions conditions;
    for (const MechanismPart& part : mechanism.getParts())
        if (hasExact(part)) conditions.push_back(std::make_shared<ExactCoordinates>(part));
    return conditions;
}

//---------------------------------------------------------------------------------------- initial values
Vector GivenCoordinate::calcErrors(const State& state) const {
    const Real error = m_given.coordinate.calcValue(state) - *m_given.value;
    return Vector(1, m_given.dimension == Dimension::Angle ? std::remainder(error, 2 * SimTK::Pi) : error);
}

void GivenCoordinate::addDirections(const State& state, int, Directions& directions) const {
    addCoordinateDirections(m_given.coordinate.getImplementation(), state, directions);
}

bool isSwitchedOff(const Mechanism& mechanism, const InitialCoordinate& given, const State& state) {
    return mechanism.getElement(given.element).isDisabled(state);
}

std::vector<MissedCoordinate> findMissedInitial(const Mechanism& mechanism, const State& state,
                                                Real tolerance) {
    std::vector<MissedCoordinate> missed;
    for (const InitialCoordinate& given : mechanism.getInitialCoordinates()) {
        if (!given.value || isSwitchedOff(mechanism, given, state)) continue;
        const Real amount = std::abs(GivenCoordinate(given).calcErrors(state)[0]);
        if (amount > tolerance)
            missed.push_back({given.element.getText(), "initial value", amount, given.dimension});
    }
    sortByAmount(missed);
    return missed;
}

PositionConditions makeInitialConditions(const Mechanism& mechanism, const State& state) {
    PositionConditions conditions;
    for (const InitialCoordinate& given : mechanism.getInitialCoordinates())
        if (given.value && !isSwitchedOff(mechanism, given, state))
            conditions.push_back(std::make_shared<GivenCoordinate>(given));
    return conditions;
}

std::string nameHeld(const Mechanism& mechanism) {
    std::string names;
    const auto add = [&names](const std::string& name) { names += (names.empty() ? "" : ", ") + name; };
    for (const MechanismPart& part : mechanism.getParts())
        if (hasExact(part)) add("the EXACT coordinates of " + part.name);
    for (const InitialCoordinate& given : mechanism.getInitialCoordinates())
        if (given.value) add("the initial value of " + given.element.getText());
    return names;
}

}  // namespace jprim
