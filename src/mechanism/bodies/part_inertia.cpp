// SPDX-License-Identifier: Apache-2.0
#include "base/format.h"
#include "mechanism/bodies/bodies.h"
#include "mechanism/kinetic_energy.h"

namespace jprim {

using SimTK::Mat33;
using SimTK::Real;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

// What is not as of a body, but for negative moments; masses and moments are in the dataset's units.
std::string describeOddities(const SolvableMass& used, Real mass, const Vec3& moments) {
    std::string text;
    if (used.massReplaced)
        text = fmt::format("has no mass; MASS={:.3g} is used so that the equations can be solved", mass);
    else if (used.inertiaReplaced)
        text = "has no inertia about some axis; a little is used so that the equations can be solved";
    const Real excess = calcTriangleExcess(moments);
    if (hasNegativeMoment(moments) || excess == 0) return text;
    return text + (text.empty() ? "" : "; it ") +
           fmt::format(
               "has a principal moment of inertia about the mass centre ({:.9g}) that is larger than the sum of the other "
               "two ({:.9g}) by {:.6g}, which no body has; it is used as given",
               moments[2], moments[0] + moments[1], excess);
}

}  // namespace

SolvableMass chooseMass(const PartStatement& statement, int part, Real size, const BodyContext& context,
                        std::vector<NegativeMoment>& negativeMoments) {
    const UnitSystem& units = context.contents.units;
    const Transform X_PC = context.poses.getPoseOnPart(statement.cm);
    PartMass stated{statement.mass.value_or(0) * units.mass, X_PC,
                    statement.im == 0 ? X_PC : context.poses.getPoseOnPart(statement.im), statement.ip};
    if (stated.ip)
        for (double& value : *stated.ip) value *= units.getInertia();

    const Mat33 given = calcCentralInertia(stated);
    SolvableMass used{1, Mat33(1), false, false};
    std::string problem = findMassProblem(stated.mass, given);
    if (problem.empty()) {
        used = makeSolvable(stated.mass, given, size, context.lightestMass);
        problem = findMassProblem(used.mass, used.inertia);
    }
    if (!problem.empty()) {
        context.reporter.addError(
            statement.where,
            fmt::format("PART/{}: no body can have this MASS and IP: {}; check MASS, IP, IM and CM",
                        statement.id, problem));
        return {1, Mat33(1), false, false};
    }
    const Vec3 moments = calcPrincipalMoments(used.inertia);
    const std::string oddities = describeOddities(used, used.mass / units.mass, moments / units.getInertia());
    if (hasNegativeMoment(moments))
        negativeMoments.push_back({&statement, part, used.inertia, moments[0], oddities});
    else if (!oddities.empty())
        context.reporter.addWarning(statement.where, fmt::format("PART/{} {}", statement.id, oddities));
    return used;
}

void checkNegativeMoments(const Mechanism& mechanism, const std::vector<NegativeMoment>& negativeMoments,
                          Reporter& reporter) {
    if (negativeMoments.empty()) return;
    std::vector<NegativeInertia> inertias;
    for (const NegativeMoment& negative : negativeMoments)
        inertias.push_back({mechanism.getParts()[size_t(negative.part)].body, negative.inertia});
    const std::vector<bool> harmful = findHarmful(mechanism, inertias);
    for (size_t k = 0; k < inertias.size(); ++k) {
        const NegativeMoment& negative = negativeMoments[k];
        const std::string moment =
            fmt::format("PART/{} {}has a negative principal moment of inertia about the mass centre ({:.9g})",
                        negative.statement->id, negative.oddities.empty() ? "" : negative.oddities + "; it ",
                        negative.moment / mechanism.getUnits().getInertia());
        if (harmful[k])
            reporter.addError(
                negative.statement->where,
                moment +
                    ", and the constraints allow a motion whose kinetic energy it makes negative or zero; "
                    "check MASS, IP, IM and CM");
        else
            reporter.addWarning(
                negative.statement->where,
                moment +
                    ", which no body has; it is used as given, for no motion that the constraints allow "
                    "makes its sign felt");
    }
}

}  // namespace jprim
