// SPDX-License-Identifier: Apache-2.0
#include "mechanism/given_poses.h"

#include "base/format.h"
#include "jprim/base/error.h"
#include "mechanism/frames.h"

namespace jprim {

using SimTK::Real;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

// Places of the statements among the parts, which follow each other by kind.
template <class Statements>
std::unordered_map<int, int> findPlaces(const Statements& statements, size_t first) {
    std::unordered_map<int, int> places;
    for (const auto& s : statements) places[s.id] = int(first++);
    return places;
}

// QP, or for a marker on a node the node's place if there is no QP.
std::optional<Triple> findOrigin(const MarkerStatement& marker, const ModesOfBodies& modes, double lengthToSI,
                                 Reporter& reporter) {
    if (marker.flexBody == 0 || marker.node == 0 || modes.count(marker.flexBody) == 0) return marker.qp;
    try {
        const Vec3 p = modes.at(marker.flexBody).getNode(marker.node).position / lengthToSI;
        return marker.qp.value_or(Triple{p[0], p[1], p[2]});
    } catch (const Error& error) {
        reporter.addError(marker.where, fmt::format("MARKER/{}: {}", marker.id, error.what()));
        return marker.qp;
    }
}

}  // namespace

GivenPoses::GivenPoses(const Dataset& dataset, const ModesOfBodies& modes, double lengthToSI,
                       Reporter& reporter) {
    const auto parts = findPlaces(dataset.parts, 0);
    const auto pointMasses = findPlaces(dataset.pointMasses, parts.size());
    const auto flexBodies = findPlaces(dataset.flexBodies, parts.size() + pointMasses.size());
    for (const MarkerStatement& marker : dataset.markers) {
        const int part = marker.flexBody != 0    ? flexBodies.at(marker.flexBody)
                         : marker.pointMass != 0 ? pointMasses.at(marker.pointMass)
                                                 : parts.at(marker.part);
        addMarker(marker, part, modes, lengthToSI, reporter);
    }
    addParts("PART", dataset.parts, lengthToSI, reporter);
    addParts("POINT_MASS", dataset.pointMasses, lengthToSI, reporter);
    addParts("FLEX_BODY", dataset.flexBodies, lengthToSI, reporter);
}

template <class Statements>
void GivenPoses::addParts(const char* keyword, const Statements& statements, double lengthToSI,
                          Reporter& reporter) {
    for (const auto& s : statements) {
        std::string problem;
        const Transform pose = makeFrame({s.qg, s.reuler, s.zg, s.xg, false}, lengthToSI, problem);
        if (!problem.empty()) {
            m_undefinedParts.insert(getNumParts());
            reporter.addError(s.where, fmt::format("{}/{}: {}", keyword, s.id, problem));
        }
        m_partPoses.push_back(pose);
    }
}

void GivenPoses::addMarker(const MarkerStatement& marker, int part, const ModesOfBodies& modes,
                           double lengthToSI, Reporter& reporter) {
    std::string problem;
    m_markerPoses[marker.id] = makeFrame(
        {findOrigin(marker, modes, lengthToSI, reporter), marker.reuler, marker.zp, marker.xp, marker.usexp},
        lengthToSI, problem);
    m_partOfMarker[marker.id] = part;
    if (!marker.floating) m_fixedMarkers[part].push_back(marker.id);
    if (problem.empty()) return;
    m_undefinedMarkers.insert(marker.id);
    reporter.addError(marker.where, fmt::format("MARKER/{}: {}", marker.id, problem));
}

GivenPoses GivenPoses::convertTo(double lengthUnit) const {
    GivenPoses converted = *this;
    for (Transform& pose : converted.m_partPoses) pose.updP() /= lengthUnit;
    for (auto& [id, pose] : converted.m_markerPoses) pose.updP() /= lengthUnit;
    return converted;
}

Transform GivenPoses::getPose(int marker) const {
    return marker == 0 ? Transform() : getPartPose(getPart(marker)) * m_markerPoses.at(marker);
}

bool GivenPoses::isDefined(int marker) const {
    if (marker == 0) return true;
    return m_undefinedMarkers.count(marker) == 0 && m_undefinedParts.count(getPart(marker)) == 0;
}

Real GivenPoses::calcReach(int part, const Vec3& center) const {
    Real reach = 0;
    const auto markers = m_fixedMarkers.find(part);
    if (markers != m_fixedMarkers.end())
        for (const int id : markers->second)
            reach = std::max(reach, (m_markerPoses.at(id).p() - center).norm());
    return reach;
}

}  // namespace jprim
