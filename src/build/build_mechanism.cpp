// SPDX-License-Identifier: Apache-2.0
#include "jprim/build/build_mechanism.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "build/connections.h"
#include "build/frames.h"
#include "build/mechanism_builder.h"
#include "build/mobilizers.h"
#include "jprim/marker/marker_pair.h"

namespace jprim {

using SimTK::State;
using SimTK::Transform;
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
        if (!part.ground && part.cm != 0)
            largest = std::max(largest, calcReach(m_partIndex.at(part.id), getMarkerPose(part.cm).p()));
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
    for (const PointMassStatement& mass : m_dataset.pointMasses) m_pointMassIndex[mass.id] = index++;
    for (const FlexBodyStatement& body : m_dataset.flexBodies) m_flexBodyIndex[body.id] = index++;
    m_numParts = size_t(index);
}

void MechanismBuilder::findMarkerPoses() {
    for (const MarkerStatement& marker : m_dataset.markers) {
        std::string problem;
        m_markerPoses[marker.id] =
            makeFrame({findOrigin(marker), marker.reuler, marker.zp, marker.xp, marker.usexp},
                      m_mechanism.m_units.length, problem);
        const int owner = marker.flexBody != 0    ? m_flexBodyIndex.at(marker.flexBody)
                          : marker.pointMass != 0 ? m_pointMassIndex.at(marker.pointMass)
                                                  : m_partIndex.at(marker.part);
        m_ownerOfMarker[marker.id] = owner;
        if (marker.floating)  // it is where it is needed, and says nothing of its part's size
            m_functions.floatingMarkers.insert(marker.id);
        else
            m_markersOfOwner[owner].push_back(marker.id);
        if (!problem.empty()) reportFrame(fmt::format("MARKER/{}", marker.id), marker.where, problem);
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
    for (const PointMassStatement& mass : m_dataset.pointMasses) setAxes(mass, m_mechanism.m_parts[index++]);
    for (const FlexBodyStatement& body : m_dataset.flexBodies) setAxes(body, m_mechanism.m_parts[index++]);
}

// Expressions cannot name floating markers, whose place is decided by what names them.
const Marker* MechanismBuilder::findFixedMarker(int id) const {
    const auto found = m_mechanism.m_markers.find(id);
    const bool usable = found != m_mechanism.m_markers.end() && m_functions.floatingMarkers.count(id) == 0;
    return usable ? &found->second : nullptr;
}

Transform MechanismBuilder::getGivenPose(int marker) const {
    if (marker == 0) return Transform();
    return m_mechanism.m_parts[size_t(m_ownerOfMarker.at(marker))].givenPose * m_markerPoses.at(marker);
}

// False if that is a mistake already.
bool MechanismBuilder::hasGivenPose(int marker) const {
    if (marker == 0) return true;
    const MechanismPart& part = m_mechanism.m_parts[size_t(m_ownerOfMarker.at(marker))];
    return m_undefined.count(part.name) == 0 && m_undefined.count(fmt::format("MARKER/{}", marker)) == 0;
}

void MechanismBuilder::checkAxes() {
    const auto check = [&](const auto& statements, const char* keyword) {
        for (const auto& s : statements) {
            if (!hasGivenPose(s.i) || !hasGivenPose(s.j)) continue;
            const std::string problem =
                findMisalignment(s.type, getGivenPose(s.i).R(), getGivenPose(s.j).R(), s.i, s.j);
            if (!problem.empty())
                report(Severity::Error, s.where,
                       fmt::format("{}/{} {}: {}", keyword, s.id, getAdamsName(s.type), problem));
        }
    };
    check(m_dataset.jprims, "JPRIM");
    check(m_dataset.joints, "JOINT");
}

//---------------------------------------------------------------------------------------------- joints
void MechanismBuilder::addConnections() {
    for (const JprimStatement& s : m_dataset.jprims)
        addConnection("JPRIM", s, [&](const std::string& name) {
            return makeConnection(s.type, m_mechanism.getMarker(s.i), m_mechanism.getMarker(s.j), name);
        });
    for (const JointStatement& s : m_dataset.joints) {
        m_joints[s.id] = &s;
        addConnection("JOINT", s, [&](const std::string& name) { return makeJoint(s, name); });
    }
}

// Its equations, unless a mobilizer is in their place, or the tree leaves them nothing to do.
template <class Statement, class Make>
void MechanismBuilder::addConnection(const char* keyword, const Statement& s, const Make& makeEquations) {
    const std::string name = fmt::format("{}/{}", keyword, s.id);
    Connection connection{name, getAdamsName(s.type), s.i, s.j, false, {}};
    m_mechanism.m_connectionLoad[name] = m_mechanism.m_loadElements.size();
    const auto inTree = m_inTree.find(name);
    connection.inTree = inTree != m_inTree.end();
    attempt(name, s.where, [&] {
        if (connection.inTree)
            addLoadElement(makeTreeLoad(s.i, s.j, inTree->second));
        else {
            const LoopEquations left =
                m_planarLoops.isPlanar(s.i, s.j) ? findLoopEquations(s.type) : LoopEquations::All;
            if (left == LoopEquations::All) connection.joint = makeEquations(name);
            if (left == LoopEquations::InLine)
                connection.joint = makeConnection(JprimType::InLine, m_mechanism.getMarker(s.i),
                                                  m_mechanism.getMarker(s.j), name);
            addLoadElement(makeLoad(connection));
        }
        m_mechanism.m_connections.push_back(connection);
    });
}

LoadElement MechanismBuilder::makeLoad(const Connection& c) {
    const LoadFunction none = [](const State&) { return SimTK::SpatialVec(Vec3(0), Vec3(0)); };
    if (!c.joint) return {c.name, c.i, c.j, none, none, true};
    return {c.name,
            c.i,
            c.j,
            [joint = *c.joint](const State& s) { return joint.calcReactionOnI(s); },
            [joint = *c.joint](const State& s) { return joint.calcReactionOnJ(s); },
            true};
}

LoadElement MechanismBuilder::makeTreeLoad(int i, int j, const TreePlace& place) const {
    const PlannedMobilizer& m = *place.mobilizer;
    const TreeJoint joint(m_mechanism.m_parts[size_t(m.part)].body, m_mechanism.getMarker(m.i),
                          m_mechanism.getMarker(m.j), m.reversed);
    const LoadShare share = place.element->share;
    LoadFunction onI = [=](const State& state) { return joint.calcLoadOnI(state, share); };
    LoadFunction onJ = [=](const State& state) { return joint.calcLoadOnJ(state, share); };
    if (place.element->swapped) std::swap(onI, onJ);
    return {place.element->name, i, j, onI, onJ, true};
}

// A SCREW or RACKPIN keeps the travel and angle that the markers are given with: only what is added to them
// must go together. The z axes of a CONVEL, which may point down the two shafts or both the same way, say by
// their given directions which.
Joint MechanismBuilder::makeJoint(const JointStatement& s, const std::string& name) const {
    const Marker &I = m_mechanism.getMarker(s.i), &J = m_mechanism.getMarker(s.j);
    const MarkerPair given(getGivenPose(s.i), getGivenPose(s.j));
    const SimTK::Rotation& R = given.getRotation();
    const double length = m_mechanism.m_units.length, travel = given.getPosition()[2];
    if (s.type == JointType::Screw) {
        const double pitch = *s.pitch * length, angle = std::atan2(R[1][0], R[0][0]);
        return Joint::Screw(I, J, pitch, travel - pitch * angle / (2 * SimTK::Pi), name);
    }
    if (s.type == JointType::Rackpin) {
        const double diameter = *s.diameter * length, angle = -std::atan2(R[2][1], R[2][0]);
        return Joint::Rackpin(I, J, diameter, travel - diameter / 2 * angle, name);
    }
    if (s.type == JointType::Convel) return Joint::Convel(I, J, R[2][2] < 0, name);
    return makeConnection(s.type, I, J, name);
}

std::optional<Mechanism> buildMechanism(const Dataset& dataset, Diagnostics& diagnostics,
                                        const BuildOptions& options) {
    std::optional<Mechanism> mechanism = MechanismBuilder(dataset, diagnostics, options).build();
    if (mechanism && options.formulation == Formulation::Tree)
        mechanism->m_makeWithFreeParts = [dataset] {
            Diagnostics known;  // what was found in it has been said
            return std::move(buildMechanism(dataset, known, {Formulation::Constraints}).value());
        };
    return mechanism;
}

}  // namespace jprim
