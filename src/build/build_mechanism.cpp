// SPDX-License-Identifier: Apache-2.0
#include "jprim/build/build_mechanism.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "build/connections.h"
#include "build/frames.h"
#include "build/mechanism_builder.h"
#include "build/not_simulated.h"

namespace jprim {

using SimTK::MobilizedBody;
using SimTK::Vec3;

//------------------------------------------------------------------------------ units, gravity, frames
void MechanismBuilder::chooseUnits() {
    UnitSystem& units = m_mechanism.m_units;
    if (m_dataset.units) {
        units = m_dataset.units->toSI;
        applyUcf(*m_dataset.units);
    }
}

// 1 m, or the power of 1000 of it that suits the largest reach of a part. Tolerances of assembly and
// integration are absolute numbers, and Simbody weighs lengths against angles; both assume that a part's size
// is of order one. kg and s stay; with a length unit of L metres the unit of force is L newtons.
void MechanismBuilder::chooseLengthUnit() {
    double largest = 0;  // [m]: markers are in SI until here
    for (const PartStatement& part : m_dataset.parts)
        if (!part.ground && part.cm != 0) largest = std::max(largest, calcReach(part));
    for (const auto& [id, basis] : m_modes)
        for (const ModalNode& node : basis.nodes)
            largest = std::max(largest, (node.position - basis.rigid.center).norm());
    if (largest == 0 || !std::isfinite(largest)) return;

    const double L = m_mechanism.m_lengthUnit = std::pow(1000., std::round(std::log10(largest) / 3));
    m_mechanism.m_units.length /= L;
    m_mechanism.m_units.force /= L;
    for (auto& [id, pose] : m_markerPoses) pose.updP() /= L;
}

// UCF is the force unit in units of mass * length / time^2. Given alone it is the only thing known of the
// units; given beside names it must agree with them.
void MechanismBuilder::applyUcf(const UnitsStatement& statement) {
    if (!statement.ucf) return;
    UnitSystem& units = m_mechanism.m_units;
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

void MechanismBuilder::indexParts() {
    int index = 0;
    for (const PartStatement& part : m_dataset.parts) m_partIndex[part.id] = index++;
    for (const FlexBodyStatement& body : m_dataset.flexBodies) m_flexBodyIndex[body.id] = index++;
}

void MechanismBuilder::findMarkerPoses() {
    for (const MarkerStatement& marker : m_dataset.markers) {
        std::string problem;
        m_markerPoses[marker.id] =
            makeFrame({findOrigin(marker), marker.reuler, marker.zp, marker.xp, marker.usexp},
                      m_mechanism.m_units.length, problem);
        const int owner =
            marker.flexBody != 0 ? m_flexBodyIndex.at(marker.flexBody) : m_partIndex.at(marker.part);
        m_ownerOfMarker[marker.id] = owner;
        m_markersOfOwner[owner].push_back(marker.id);
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

//------------------------------------------------------------------------------- markers and joints
void MechanismBuilder::addMarkers() {
    m_mechanism.m_markers[0] = Marker(m_mechanism.m_bodies->matter.updGround());
    for (const MarkerStatement& statement : m_dataset.markers)
        m_mechanism.m_markers[statement.id] = makeMarker(statement);
    const auto setAxes = [this](const RigidCoordinates& statement, MechanismPart& part) {
        if (part.ground) return;
        part.vm = m_mechanism.m_markers[statement.vm];
        part.wm = statement.wm == 0 ? part.cm : m_mechanism.m_markers[statement.wm];
    };
    size_t index = 0;
    for (const PartStatement& part : m_dataset.parts) setAxes(part, m_mechanism.m_parts[index++]);
    for (const FlexBodyStatement& body : m_dataset.flexBodies) setAxes(body, m_mechanism.m_parts[index++]);
}

void MechanismBuilder::checkAxes() {
    const auto getGivenOrientation = [this](int id) {
        const MechanismPart& part = m_mechanism.m_parts[m_ownerOfMarker.at(id)];
        return part.givenPose.R() * m_markerPoses.at(id).R();
    };
    const auto check = [&](const auto& statements, const char* keyword) {
        for (const auto& s : statements) {
            const std::string problem =
                findMisalignment(s.type, getGivenOrientation(s.i), getGivenOrientation(s.j), s.i, s.j);
            if (!problem.empty())
                report(Severity::Error, s.where,
                       fmt::format("{}/{} {}: {}", keyword, s.id, getAdamsName(s.type), problem));
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
    if (!checkSimulated(dataset, diagnostics)) return std::nullopt;
    return MechanismBuilder(dataset, diagnostics).build();
}

}  // namespace jprim
