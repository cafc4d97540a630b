// SPDX-License-Identifier: Apache-2.0
#include "base/format.h"
#include "jprim/mechanism/build_mechanism.h"
#include "mechanism/bodies/bodies.h"

namespace jprim {

using SimTK::Real;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

Real choosePointMass(const PointMassStatement& statement, const std::string& name,
                     const BodyContext& context) {
    const Real unit = context.contents.units.mass, mass = statement.mass.value_or(0) * unit;
    const std::string problem = mass < 0 ? fmt::format("MASS={} is negative", *statement.mass)
                                         : findMassProblem(mass, SimTK::Mat33(0));
    if (!problem.empty()) {
        context.reporter.addError(statement.where, fmt::format("{}: {}", name, problem));
        return 1;
    }
    if (mass > 0) return mass;
    const Real little = MasslessFraction * context.lightestMass;
    context.reporter.addWarning(
        statement.where,
        fmt::format("{} has no mass; MASS={:.3g} is used so that the equations can be solved", name,
                    little / unit));
    return little;
}

// A body that keeps the axes of its BCS; its coordinates are along them.
MechanismPart makePointMass(const PointMassStatement& statement, int place, const BodyContext& context) {
    MechanismPart part = startPart(fmt::format("POINT_MASS/{}", statement.id), statement, place, context);
    part.turns = false;
    const Transform X_PC = context.poses.getPoseOnPart(statement.cm);
    const Real reach = context.poses.calcReach(place, X_PC.p());
    if (reach > 0) part.size = reach;
    const SimTK::MassProperties point(choosePointMass(statement, part.name, context), Vec3(0),
                                      SimTK::Inertia(0));
    part.body =
        SimTK::MobilizedBody::Translation(context.contents.matter.updGround(), Transform(part.givenPose.R()),
                                          SimTK::Body::Rigid(point), Transform());
    part.bcs = Marker(part.body, Transform(-X_PC.p()));
    part.cm = Marker(part.body, Transform(X_PC.R()));
    part.attachment.mobilizer = "Translation";
    return part;
}

}  // namespace

void addPointMasses(const BodyContext& context) {
    std::vector<MechanismPart>& parts = context.contents.parts;
    for (const PointMassStatement& mass : context.dataset.pointMasses)
        parts.push_back(makePointMass(mass, int(parts.size()), context));
}

}  // namespace jprim
