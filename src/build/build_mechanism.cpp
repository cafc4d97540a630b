// SPDX-License-Identifier: Apache-2.0
#include "jprim/build/build_mechanism.h"

#include <fmt/format.h>

#include <algorithm>

#include "build/connections.h"
#include "build/frames.h"
#include "build/part_mass.h"

namespace jprim {

using SimTK::Body;
using SimTK::Mat33;
using SimTK::MobilizedBody;
using SimTK::Real;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;

/// One pass over the dataset in the order in which things need each other: units, gravity, marker poses,
/// parts, markers, joints, requests.
class MechanismBuilder {
public:
    MechanismBuilder(const Dataset& dataset, Diagnostics& diagnostics)
        : m_dataset(dataset), m_diagnostics(diagnostics) {}

    std::optional<Mechanism> build() {
        m_mechanism.m_title = m_dataset.title;
        chooseUnits();
        findMarkerPoses();
        addGravity();
        addParts();
        if (m_failed) return std::nullopt;
        addMarkers();
        checkAxes();
        if (m_failed) return std::nullopt;
        addConnections();
        addRequests();
        return std::move(m_mechanism);
    }

private:
    void report(Severity severity, const SourcePosition& where, const std::string& message) {
        m_failed = m_failed || severity == Severity::Error;
        m_diagnostics.push_back({severity, where, message});
    }

    void chooseUnits();
    void findMarkerPoses();
    void addGravity();
    void addParts();
    void addPart(const PartStatement& statement, Real lightestMass);
    Body::Rigid makeBody(const PartStatement& statement, const Transform& X_BC, Real size, Real lightestMass);
    void addMarkers();
    void checkAxes();
    void addConnections();
    void addRequests();
    MechanismRequest makeRequest(const RequestStatement& statement) const;

    const MarkerStatement* findMarker(int id) const {
        const auto found = m_markerStatements.find(id);
        return found == m_markerStatements.end() ? nullptr : found->second;
    }
    Transform getMarkerPose(int id) const { return id == 0 ? Transform() : m_markerPoses.at(id); }
    Real calcSize(const PartStatement& statement, const Vec3& p_BC) const;

    const Dataset& m_dataset;
    Diagnostics& m_diagnostics;
    bool m_failed = false;
    Mechanism m_mechanism;
    std::unordered_map<int, const MarkerStatement*> m_markerStatements;
    std::unordered_map<int, Transform> m_markerPoses;
    std::unordered_map<int, std::vector<int>> m_markersOfPart;
    std::unordered_map<int, int> m_partIndex;
};

//------------------------------------------------------------------------------ units, gravity, frames
// UCF is the force unit in units of mass * length / time^2. Given alone it is the only thing known of the
// units; given beside names it must agree with them.
void MechanismBuilder::chooseUnits() {
    if (!m_dataset.units) return;
    const UnitsStatement& statement = *m_dataset.units;
    UnitSystem& units = m_mechanism.m_units;
    units = statement.toSI;
    if (!statement.ucf) return;
    const bool named = !statement.system.empty() || !statement.names[0].empty();
    const double consistent = units.force / (units.mass * units.getAcceleration());
    if (!named)
        units.force = *statement.ucf;
    else if (std::abs(*statement.ucf / consistent - 1) > 1e-3)
        report(Severity::Warning, statement.where,
               fmt::format(
                   "UCF={} does not fit the named units, whose factor is {:.6g}; the named units are used",
                   *statement.ucf, consistent));
}

void MechanismBuilder::findMarkerPoses() {
    for (const MarkerStatement& marker : m_dataset.markers) {
        std::string problem;
        m_markerPoses[marker.id] = makeFrame({marker.qp, marker.reuler, marker.zp, marker.xp, marker.usexp},
                                             m_mechanism.m_units.length, problem);
        m_markerStatements[marker.id] = &marker;
        m_markersOfPart[marker.part].push_back(marker.id);
        if (!problem.empty())
            report(Severity::Error, marker.where, fmt::format("MARKER/{}: {}", marker.id, problem));
    }
}

void MechanismBuilder::addGravity() {
    if (!m_dataset.gravity) return;
    const Triple& g = m_dataset.gravity->acceleration;
    m_mechanism.m_gravity = m_mechanism.m_units.getAcceleration() * Vec3(g[0], g[1], g[2]);
    SimTK::Force::Gravity(m_mechanism.m_bodies->forces, m_mechanism.m_bodies->matter, m_mechanism.m_gravity);
}

//----------------------------------------------------------------------------------------------- parts
void MechanismBuilder::addParts() {
    Real lightest = SimTK::Infinity;
    for (const PartStatement& part : m_dataset.parts)
        if (part.mass.value_or(0) > 0) lightest = std::min(lightest, *part.mass * m_mechanism.m_units.mass);
    if (lightest == SimTK::Infinity) lightest = 1;
    for (const PartStatement& part : m_dataset.parts) addPart(part, lightest);
}

Real MechanismBuilder::calcSize(const PartStatement& statement, const Vec3& p_BC) const {
    Real size = 0;
    const auto markers = m_markersOfPart.find(statement.id);
    if (markers != m_markersOfPart.end())
        for (const int id : markers->second) size = std::max(size, (m_markerPoses.at(id).p() - p_BC).norm());
    return size > 0 ? size : 1;
}

// Mobilized at its mass centre: rotation and translation of a free body are then uncoupled, and coordinates
// stay small where a dataset gives every part the same far-away origin.
void MechanismBuilder::addPart(const PartStatement& statement, Real lightestMass) {
    const UnitSystem& units = m_mechanism.m_units;
    MechanismPart part;
    part.id = statement.id;
    part.ground = statement.ground;
    part.exact = statement.exact;

    std::string problem;
    part.givenPose =
        makeFrame({statement.qg, statement.reuler, statement.zg, statement.xg, false}, units.length, problem);
    if (!problem.empty())
        report(Severity::Error, statement.where, fmt::format("PART/{}: {}", part.id, problem));

    MobilizedBody& ground = m_mechanism.m_bodies->matter.updGround();
    if (part.ground) {
        part.body = ground;
        part.cm = part.vm = part.wm = Marker(ground, part.givenPose);
    } else {
        const Transform X_BC = getMarkerPose(statement.cm);
        part.size = calcSize(statement, X_BC.p());
        const Transform X_BM(X_BC.p());
        MobilizedBody::Free body(ground, Transform(), makeBody(statement, X_BC, part.size, lightestMass),
                                 X_BM);
        body.setDefaultTransform(part.givenPose * X_BM);
        part.body = body;
        part.cm = Marker(body, X_BC);
    }
    for (int k = 0; k < 3; ++k) {
        if (statement.v[k]) part.v[k] = *statement.v[k] * units.getVelocity();
        if (statement.w[k]) part.w[k] = *statement.w[k] * units.getAngularVelocity();
    }
    m_partIndex[part.id] = int(m_mechanism.m_parts.size());
    m_mechanism.m_parts.push_back(part);
}

Body::Rigid MechanismBuilder::makeBody(const PartStatement& statement, const Transform& X_BC, Real size,
                                       Real lightestMass) {
    const UnitSystem& units = m_mechanism.m_units;
    PartMass part{statement.mass.value_or(0) * units.mass, X_BC,
                  statement.im == 0 ? X_BC : getMarkerPose(statement.im), statement.ip};
    if (part.ip)
        for (double& value : *part.ip) value *= units.getInertia();

    Mat33 inertia = calcCentralInertia(part);
    const std::string problem = findInertiaProblem(inertia, units.getInertia());
    if (!problem.empty()) {
        report(
            Severity::Error, statement.where,
            fmt::format("PART/{}: no body can have this IP: {}; check IP, IM and CM", statement.id, problem));
        return Body::Rigid();
    }
    // A massless part becomes a light one of ordinary shape; one with mass but a vanishing moment, a thin
    // one.
    const bool massless = part.mass == 0;
    if (massless) {
        part.mass = MasslessFraction * lightestMass;
        report(Severity::Warning, statement.where,
               fmt::format("PART/{} has no mass; {:.3g} kg is used so that the equations can be solved",
                           statement.id, part.mass));
    }
    bool wasRaised = false;
    const Real smallest = (massless ? 1 : MasslessFraction) * part.mass * size * size;
    inertia = raisePrincipalMoments(inertia, smallest, wasRaised);
    if (wasRaised && !massless)
        report(
            Severity::Warning, statement.where,
            fmt::format("PART/{} has no inertia about some axis; {:.3g} kg m^2 is used so that the equations "
                        "can be solved",
                        statement.id, smallest));
    const SimTK::Inertia central(inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2),
                                 inertia(1, 2));
    return Body::Rigid(
        SimTK::MassProperties(part.mass, X_BC.p(), central.shiftFromMassCenter(X_BC.p(), part.mass)));
}

//------------------------------------------------------------------------------- markers and joints
void MechanismBuilder::addMarkers() {
    MobilizedBody& ground = m_mechanism.m_bodies->matter.updGround();
    m_mechanism.m_markers[0] = Marker(ground);
    for (const MarkerStatement& statement : m_dataset.markers) {
        const MechanismPart& part = m_mechanism.m_parts[m_partIndex.at(statement.part)];
        // Ground's BCS may be displaced; its Simbody body may not.
        const Transform X_BM =
            part.ground ? part.givenPose * m_markerPoses[statement.id] : m_markerPoses[statement.id];
        m_mechanism.m_markers[statement.id] = Marker(part.body, X_BM);
    }
    for (size_t k = 0; k < m_dataset.parts.size(); ++k) {
        const PartStatement& statement = m_dataset.parts[k];
        MechanismPart& part = m_mechanism.m_parts[k];
        if (part.ground) continue;
        part.vm = m_mechanism.m_markers[statement.vm];
        part.wm = statement.wm == 0 ? part.cm : m_mechanism.m_markers[statement.wm];
    }
}

void MechanismBuilder::checkAxes() {
    const auto getGivenOrientation = [this](int id) {
        const MechanismPart& part = m_mechanism.m_parts[m_partIndex.at(findMarker(id)->part)];
        return part.givenPose.R() * m_markerPoses.at(id).R();
    };
    const auto check = [&](const auto& statements, const char* keyword) {
        for (const auto& s : statements) {
            const std::string flip =
                findFlip(s.type, getGivenOrientation(s.i), getGivenOrientation(s.j), s.i, s.j);
            if (!flip.empty())
                report(Severity::Error, s.where,
                       fmt::format("{}/{} {}: {}", keyword, s.id, getAdamsName(s.type), flip));
        }
    };
    check(m_dataset.jprims, "JPRIM");
    check(m_dataset.joints, "JOINT");
}

void MechanismBuilder::addConnections() {
    const auto add = [this](const std::string& name, int i, int j, const Joint& joint) {
        m_mechanism.m_connectionIndex[name] = int(m_mechanism.m_connections.size());
        m_mechanism.m_connections.push_back({name, i, j, joint});
    };
    for (const JprimStatement& s : m_dataset.jprims) {
        const std::string name = fmt::format("JPRIM/{}", s.id);
        add(name, s.i, s.j,
            makeConnection(s.type, m_mechanism.getMarker(s.i), m_mechanism.getMarker(s.j), name));
    }
    for (const JointStatement& s : m_dataset.joints) {
        const std::string name = fmt::format("JOINT/{}", s.id);
        add(name, s.i, s.j,
            makeConnection(s.type, m_mechanism.getMarker(s.i), m_mechanism.getMarker(s.j), name));
    }
}

//-------------------------------------------------------------------------------------------- requests
void MechanismBuilder::addRequests() {
    for (const RequestStatement& statement : m_dataset.requests)
        if (statement.type != RequestType::Expressions)
            m_mechanism.m_requests.push_back(makeRequest(statement));
}

MechanismRequest MechanismBuilder::makeRequest(const RequestStatement& statement) const {
    MechanismRequest request;
    request.id = statement.id;
    request.type = statement.type;
    request.I = m_mechanism.getMarker(statement.i);
    request.J = m_mechanism.getMarker(statement.j);
    request.rm = m_mechanism.getMarker(statement.rm);
    if (request.type != RequestType::Force) return request;
    for (size_t k = 0; k < m_mechanism.m_connections.size(); ++k) {
        const Connection& c = m_mechanism.m_connections[k];
        if (c.i == statement.i && c.j == statement.j) request.connections.emplace_back(int(k), true);
        if (c.j == statement.i && c.i == statement.j) request.connections.emplace_back(int(k), false);
    }
    return request;
}

std::optional<Mechanism> buildMechanism(const Dataset& dataset, Diagnostics& diagnostics) {
    return MechanismBuilder(dataset, diagnostics).build();
}

}  // namespace jprim
