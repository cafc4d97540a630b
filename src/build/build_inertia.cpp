// SPDX-License-Identifier: Apache-2.0
// The part of MechanismBuilder that decides on the mass and inertia of parts.
#include "base/format.h"
#include "build/kinetic_energy.h"
#include "build/mechanism_builder.h"

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

SolvableMass MechanismBuilder::chooseMass(const PartStatement& statement, const Transform& X_PC, Real size) {
    const UnitSystem& units = m_mechanism.m_units;
    PartMass part{statement.mass.value_or(0) * units.mass, X_PC,
                  statement.im == 0 ? X_PC : getMarkerPose(statement.im), statement.ip};
    if (part.ip)
        for (double& value : *part.ip) value *= units.getInertia();

    const Mat33 given = calcCentralInertia(part);
    SolvableMass used{1, Mat33(1), false, false};
    std::string problem = findMassProblem(part.mass, given);
    if (problem.empty()) {
        used = makeSolvable(part.mass, given, size, m_lightestMass);
        problem = findMassProblem(used.mass, used.inertia);
    }
    if (!problem.empty()) {
        report(Severity::Error, statement.where,
               fmt::format("PART/{}: no body can have this MASS and IP: {}; check MASS, IP, IM and CM",
                           statement.id, problem));
        return {1, Mat33(1), false, false};
    }
    const Vec3 moments = calcPrincipalMoments(used.inertia);
    const std::string oddities = describeOddities(used, used.mass / units.mass, moments / units.getInertia());
    if (hasNegativeMoment(moments))
        m_negativeMoments.push_back({&statement, used.inertia, moments[0], oddities});
    else if (!oddities.empty())
        report(Severity::Warning, statement.where, fmt::format("PART/{} {}", statement.id, oddities));
    return used;
}

// A part may have any moment about axes about which nothing lets it turn; what it must not do is take the kinetic
// energy from a motion.
void MechanismBuilder::checkNegativeMoments() {
    if (m_negativeMoments.empty()) return;
    std::vector<NegativeInertia> inertias;
    for (const NegativeMoment& negative : m_negativeMoments)
        inertias.push_back(
            {m_mechanism.m_parts[size_t(m_partIndex.at(negative.statement->id))].body, negative.inertia});
    const std::vector<bool> harmful = findHarmful(m_mechanism, inertias);
    for (size_t k = 0; k < inertias.size(); ++k) {
        const NegativeMoment& negative = m_negativeMoments[k];
        const std::string moment =
            fmt::format("PART/{} {}has a negative principal moment of inertia about the mass centre ({:.9g})",
                        negative.statement->id, negative.oddities.empty() ? "" : negative.oddities + "; it ",
                        negative.moment / m_mechanism.m_units.getInertia());
        if (harmful[k])
            report(Severity::Error, negative.statement->where,
                   moment +
                       ", and the constraints allow a motion whose kinetic energy it makes negative or zero; "
                       "check MASS, IP, IM and CM");
        else
            report(Severity::Warning, negative.statement->where,
                   moment +
                       ", which no body has; it is used as given, for no motion that the constraints allow "
                       "makes its sign felt");
    }
}

}  // namespace jprim
