// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/format.h"
#include "mechanism/bodies/bodies.h"
#include "mechanism/mobilizers.h"
#include "mechanism/negative_masses.h"

namespace jprim {

using SimTK::Body;
using SimTK::Real;
using SimTK::Transform;

namespace {

void checkGround(const PartStatement& s, Reporter& reporter) {
    const auto given = [](const auto& values) {
        return std::any_of(values.begin(), values.end(), [](const auto& value) { return bool(value); });
    };
    if (s.mass || s.ip || s.cm != 0 || s.im != 0 || given(s.v) || given(s.w) || given(s.exact))
        reporter.addWarning(
            s.where,
            fmt::format("PART/{} is GROUND: its mass, inertia, velocities and EXACT have no effect", s.id));
}

MechanismPart makeGround(const PartStatement& statement, int place, const BodyContext& context) {
    checkGround(statement, context.reporter);
    MechanismPart part = startPart(fmt::format("PART/{}", statement.id), statement, place, context);
    part.ground = true;
    part.exact = {};
    part.body = context.contents.matter.updGround();
    part.bcs = part.cm = part.vm = part.wm = Marker(part.body, part.givenPose);
    return part;
}

// The part's body, hung on its parent's at the markers of the joint that the mobilizer stands for.
void hang(const PlannedMobilizer& planned, const Body& body, const Transform& X_BP,
          const BodyContext& context, MechanismPart& part) {
    if (planned.parent < 0) {
        part.body =
            addMobilizer(planned, context.contents.matter.updGround(), Transform(), body, Transform());
        return;
    }
    MechanismPart& parent = context.contents.parts[size_t(planned.parent)];
    const int onParent = planned.reversed ? planned.i : planned.j;
    const int onPart = planned.reversed ? planned.j : planned.i;
    part.body =
        addMobilizer(planned, parent.body, parent.bcs.getPose() * context.poses.getPoseOnPart(onParent), body,
                     X_BP * context.poses.getPoseOnPart(onPart));
    part.attachment = {planned.parent, getSimbodyName(planned.type), planned.reversed, {}};
    for (const PlannedElement& element : planned.elements) part.attachment.elements.push_back(element.id);
}

// The Simbody body has its origin at the mass centre and the axes of the BCS: rotation and translation of a
// free body are then uncoupled, and nothing is lost where a dataset gives every part the same far-away
// origin.
MechanismPart makePart(const PlannedMobilizer& planned, const BodyContext& context,
                       std::vector<NegativeMoment>& negativeMoments) {
    const PartStatement& statement = context.dataset.parts[size_t(planned.part)];
    MechanismPart part = startPart(fmt::format("PART/{}", statement.id), statement, planned.part, context);
    const Transform X_PC = context.poses.getPoseOnPart(statement.cm);  // P: the BCS
    const Real reach = context.poses.calcReach(planned.part, X_PC.p());
    if (reach > 0) part.size = reach;
    const Transform X_BP(-X_PC.p());
    const SolvableMass used = chooseMass(statement, planned.part, part.size, context, negativeMoments);
    NegativeMasses negative;
    Body::Rigid body;
    context.reporter.attempt(part.name, statement.where, [&] {
        negative = makeNegativeMasses(used.mass, findMissingInertia(used.inertia));
        body = Body::Rigid(makeMassProperties(used.mass, used.inertia, negative));
    });
    hang(planned, body, X_BP, context, part);
    weldNegativeMasses(part.body, negative);
    part.bcs = Marker(part.body, X_BP);
    part.cm = Marker(part.body, Transform(X_PC.R()));
    return part;
}

}  // namespace

void addParts(const BodyContext& context, std::vector<NegativeMoment>& negativeMoments) {
    const std::vector<PartStatement>& statements = context.dataset.parts;
    std::vector<MechanismPart>& parts = context.contents.parts;
    parts.resize(statements.size());
    for (size_t k = 0; k < statements.size(); ++k)
        if (statements[k].ground) parts[k] = makeGround(statements[k], int(k), context);
    for (const PlannedMobilizer& planned : context.plan.getMobilizers())
        parts[size_t(planned.part)] = makePart(planned, context, negativeMoments);
}

}  // namespace jprim
