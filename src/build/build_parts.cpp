// SPDX-License-Identifier: Apache-2.0
// The part of MechanismBuilder that makes bodies.
#include <algorithm>

#include "base/format.h"
#include "build/frames.h"
#include "build/mechanism_builder.h"
#include "build/mobilizers.h"
#include "build/negative_masses.h"
#include "jprim/build/build_mechanism.h"

namespace jprim {

using SimTK::Body;
using SimTK::MobilizedBody;
using SimTK::Real;
using SimTK::Transform;
using SimTK::Vec3;

void MechanismBuilder::addParts() {
    Real lightest = SimTK::Infinity;
    const auto weigh = [&](const std::optional<double>& mass) {
        if (mass.value_or(0) > 0) lightest = std::min(lightest, *mass * m_mechanism.m_units.mass);
    };
    for (const PartStatement& part : m_dataset.parts) weigh(part.mass);
    for (const PointMassStatement& mass : m_dataset.pointMasses) weigh(mass.mass);
    if (lightest == SimTK::Infinity) lightest = 1;
    m_lightestMass = lightest;
    m_mechanism.m_parts.resize(m_dataset.parts.size());
    addGround();
    for (const PlannedMobilizer& planned : m_plan.mobilizers) addPart(planned);
}

void MechanismBuilder::addGround() {
    for (size_t k = 0; k < m_dataset.parts.size(); ++k) {
        const PartStatement& statement = m_dataset.parts[k];
        if (!statement.ground) continue;
        MechanismPart& part = m_mechanism.m_parts[k];
        part.name = fmt::format("PART/{}", statement.id);
        part.ground = true;
        setRigidCoordinates(statement, statement.where, part);
        checkGround(statement);
        part.body = m_mechanism.m_bodies->matter.updGround();
        part.bcs = part.cm = part.vm = part.wm = Marker(part.body, part.givenPose);
    }
}

// Largest distance of a part's marker from its mass centre.
Real MechanismBuilder::calcReach(int owner, const Vec3& center) const {
    Real reach = 0;
    const auto markers = m_markersOfOwner.find(owner);
    if (markers != m_markersOfOwner.end())
        for (const int id : markers->second)
            reach = std::max(reach, (m_markerPoses.at(id).p() - center).norm());
    return reach;
}

// The Simbody body has its origin at the mass centre and the axes of the BCS: rotation and translation of a
// free body are then uncoupled, and nothing is lost where a dataset gives every part the same far-away
// origin.
void MechanismBuilder::addPart(const PlannedMobilizer& planned) {
    const PartStatement& statement = m_dataset.parts[size_t(planned.part)];
    MechanismPart& part = m_mechanism.m_parts[size_t(planned.part)];
    part.name = fmt::format("PART/{}", statement.id);
    setRigidCoordinates(statement, statement.where, part);

    const Transform X_PC = getMarkerPose(statement.cm);  // P: the BCS
    const Real reach = calcReach(planned.part, X_PC.p());
    if (reach > 0) part.size = reach;
    const Transform X_BP(-X_PC.p());
    const SolvableMass used = chooseMass(statement, X_PC, part.size);
    NegativeMasses negative;
    Body::Rigid body;
    attempt(part.name, statement.where, [&] {
        negative = makeNegativeMasses(used.mass, findMissingInertia(used.inertia));
        body = Body::Rigid(makeMassProperties(used.mass, used.inertia, negative));
    });
    addBody(planned, body, X_BP, part);
    weldNegativeMasses(part.body, negative);
    part.bcs = Marker(part.body, X_BP);
    part.cm = Marker(part.body, Transform(X_PC.R()));
}

// The part's body, hung on its parent's at the markers of the joint that the mobilizer stands for.
void MechanismBuilder::addBody(const PlannedMobilizer& planned, const Body& body, const Transform& X_BP,
                               MechanismPart& part) {
    if (planned.parent < 0) {
        part.body =
            addMobilizer(planned, m_mechanism.m_bodies->matter.updGround(), Transform(), body, Transform());
        return;
    }
    MechanismPart& parent = m_mechanism.m_parts[size_t(planned.parent)];
    const int onParent = planned.reversed ? planned.i : planned.j;
    const int onPart = planned.reversed ? planned.j : planned.i;
    part.body = addMobilizer(planned, parent.body, parent.bcs.getPose() * getMarkerPose(onParent), body,
                             X_BP * getMarkerPose(onPart));
    part.attachment = {planned.parent, getSimbodyName(planned.type), planned.reversed, {}};
    for (const PlannedElement& element : planned.elements) {
        part.attachment.elements.push_back(element.name);
        m_inTree[element.name] = {&planned, &element};
    }
}

void MechanismBuilder::addPointMasses() {
    for (const PointMassStatement& mass : m_dataset.pointMasses) addPointMass(mass);
}

// A body that keeps the axes of its BCS; its coordinates are along them.
void MechanismBuilder::addPointMass(const PointMassStatement& statement) {
    MechanismPart part;
    part.name = fmt::format("POINT_MASS/{}", statement.id);
    part.turns = false;
    setRigidCoordinates(statement, statement.where, part);
    const Transform X_PC = getMarkerPose(statement.cm);
    const Real reach = calcReach(m_pointMassIndex.at(statement.id), X_PC.p());
    if (reach > 0) part.size = reach;

    Real mass = statement.mass.value_or(0) * m_mechanism.m_units.mass;
    const std::string problem = mass < 0 ? fmt::format("MASS={} is negative", *statement.mass)
                                         : findMassProblem(mass, SimTK::Mat33(0));
    if (!problem.empty()) {
        report(Severity::Error, statement.where, fmt::format("{}: {}", part.name, problem));
        mass = 1;
    }
    if (mass == 0) {
        mass = MasslessFraction * m_lightestMass;
        report(Severity::Warning, statement.where,
               fmt::format("{} has no mass; MASS={:.3g} is used so that the equations can be solved",
                           part.name, mass / m_mechanism.m_units.mass));
    }
    const SimTK::MassProperties point(mass, Vec3(0), SimTK::Inertia(0));
    MobilizedBody::Translation body(m_mechanism.m_bodies->matter.updGround(), Transform(part.givenPose.R()),
                                    Body::Rigid(point), Transform());
    part.body = body;
    part.bcs = Marker(body, Transform(-X_PC.p()));
    part.cm = Marker(body, Transform(X_PC.R()));
    part.attachment.mobilizer = "Translation";
    m_mechanism.m_parts.push_back(part);
}

void MechanismBuilder::setRigidCoordinates(const RigidCoordinates& statement, const SourcePosition& where,
                                           MechanismPart& part) {
    const UnitSystem& units = m_mechanism.m_units;
    std::string problem;
    part.givenPose =
        makeFrame({statement.qg, statement.reuler, statement.zg, statement.xg, false}, units.length, problem);
    if (!problem.empty()) reportFrame(part.name, where, problem);
    if (!part.ground) part.exact = statement.exact;
    for (int k = 0; k < 3; ++k) {
        if (statement.v[k]) part.v[k] = *statement.v[k] * units.getVelocity();
        if (statement.w[k]) part.w[k] = *statement.w[k] * units.getAngularVelocity();
    }
}

void MechanismBuilder::checkGround(const PartStatement& s) {
    const auto given = [](const auto& values) {
        return std::any_of(values.begin(), values.end(), [](const auto& value) { return bool(value); });
    };
    if (s.mass || s.ip || s.cm != 0 || s.im != 0 || given(s.v) || given(s.w) || given(s.exact))
        report(
            Severity::Warning, s.where,
            fmt::format("PART/{} is GROUND: its mass, inertia, velocities and EXACT have no effect", s.id));
}

}  // namespace jprim
