// SPDX-License-Identifier: Apache-2.0
#include "simulation/violation.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace jprim {

using SimTK::Real;
using SimTK::Rotation;
using SimTK::State;
using SimTK::Transform;
using SimTK::Vector;

Violation calcViolation(const Mechanism& mechanism, const State& state) {
    return calcViolation(mechanism.findEquations(state), state);
}

Violation calcViolation(const std::vector<ConstraintEquation>& equations, const State& state) {
    const Vector& errors = state.getQErr();
    Violation violation;
    for (const ConstraintEquation& equation : equations) {
        if (equation.level != KinematicLevel::Position) break;
        keepWorst(violation, equation, equation.getError(errors));
    }
    return violation;
}

void keepWorst(Violation& worst, const Violation& now) {
    if (!now.element.empty() && std::max(now.length, now.angle) > std::max(worst.length, worst.angle))
        worst.element = now.element;
    worst.length = std::max(worst.length, now.length);
    worst.angle = std::max(worst.angle, now.angle);
}

void keepWorst(Violation& worst, const ConstraintEquation& equation, Real error) {
    Violation violation{0, 0, equation.element};
    (equation.dimension == Dimension::Length ? violation.length : violation.angle) = std::abs(error);
    keepWorst(worst, violation);
}

void addMisfits(const Mechanism& mechanism, const State& given, Violation& violation) {
    for (const MechanismPart& part : mechanism.getParts()) {
        if (part.ground) continue;
        Transform fit = part.body.getMobilizerTransform(given);
        Transform wanted = mechanism.calcGivenMobilizerPose(given, part);
        if (part.attachment.reversed) std::tie(fit, wanted) = std::pair(~fit, ~wanted);  // I in J
        Violation misfit;
        misfit.length = max((wanted.p() - fit.p()).abs());
        misfit.angle = std::abs((~fit.R() * wanted.R()).convertRotationToAngleAxis()[0]);
        if (!part.attachment.elements.empty()) misfit.element = part.attachment.elements[0].getText();
        keepWorst(violation, misfit);
    }
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

}  // namespace jprim
