// SPDX-License-Identifier: Apache-2.0
#include "simulation/assembly_conditions.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "jprim/marker/angles.h"

namespace jprim {

using SimTK::Real;
using SimTK::Rotation;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vec3;
using SimTK::Vector;

int ExactCoordinates::calcErrors(const State& state, Vector& errors) const {
    const Transform X_GP = m_part.bcs.findPoseInGround(state);
    std::vector<Real> held;
    for (int k = 0; k < 3; ++k)
        if (m_part.exact[k]) held.push_back((X_GP.p()[k] - m_part.givenPose.p()[k]) / m_part.size);
    addTurns(X_GP.R(), held);
    errors = Vector(int(held.size()), held.data());
    return 0;
}

void ExactCoordinates::addTurns(const Rotation& R_GP, std::vector<Real>& held) const {
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

int GivenCoordinates::calcErrors(const State& state, Vector& errors) const {
    std::vector<Real> held;
    for (const InitialCoordinate& given : m_coordinates) {
        if (!given.value) continue;
        const Real error = given.coordinate.calcValue(state) - *given.value;
        held.push_back(given.isAngle ? std::remainder(error, 2 * SimTK::Pi) : error);
    }
    errors = Vector(int(held.size()), held.data());
    return 0;
}

std::pair<Real, std::string> findCoordinateError(const Mechanism& mechanism, const State& state) {
    std::pair<Real, std::string> worst(0, "");
    for (const InitialCoordinate& given : mechanism.getInitialCoordinates()) {
        Vector error;
        GivenCoordinates({given}).calcErrors(state, error);
        if (error.size() > 0 && std::abs(error[0]) > worst.first) worst = {std::abs(error[0]), given.name};
    }
    return worst;
}

std::string nameHeld(const Mechanism& mechanism) {
    std::string names;
    const auto add = [&names](const std::string& name) { names += (names.empty() ? "" : ", ") + name; };
    for (const MechanismPart& part : mechanism.getParts()) {
        const bool isExact = std::find(part.exact.begin(), part.exact.end(), true) != part.exact.end();
        if (isExact) add("the EXACT coordinates of " + part.name);
    }
    for (const InitialCoordinate& given : mechanism.getInitialCoordinates())
        if (given.value) add("the initial value of " + given.name);
    return names;
}

}  // namespace jprim
