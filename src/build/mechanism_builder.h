// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BUILD_MECHANISM_BUILDER_H_
#define JPRIM_SRC_BUILD_MECHANISM_BUILDER_H_

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "jprim/base/diagnostic.h"
#include "jprim/build/mechanism.h"

namespace jprim {

/// One pass over the dataset in the order in which things need each other: units, modes, marker poses,
/// gravity, parts, markers, joints, requests.
class MechanismBuilder {
public:
    MechanismBuilder(const Dataset& dataset, Diagnostics& diagnostics)
        : m_dataset(dataset), m_diagnostics(diagnostics) {}

    std::optional<Mechanism> build() {
        m_mechanism.m_title = m_dataset.title;
        chooseUnits();
        indexParts();
        loadModes();
        if (m_failed) return std::nullopt;
        findMarkerPoses();
        chooseLengthUnit();
        addGravity();
        addParts();
        addFlexBodies();
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
    void applyUcf(const UnitsStatement& statement);
    void indexParts();
    void loadModes();
    void findMarkerPoses();
    std::optional<Triple> findOrigin(const MarkerStatement& marker);
    void chooseLengthUnit();
    void addGravity();
    void addParts();
    void addPart(const PartStatement& statement, SimTK::Real lightestMass);
    void addFlexBodies();
    void addFlexBody(const FlexBodyStatement& statement);
    void setRigidCoordinates(const RigidCoordinates& statement, const SourcePosition& where,
                             MechanismPart& part);
    void checkGround(const PartStatement& statement);
    SimTK::Body::Rigid makeBody(const PartStatement& statement, const SimTK::Transform& X_PC,
                                SimTK::Real size, SimTK::Real lightestMass);
    void addMarkers();
    Marker makeMarker(const MarkerStatement& statement) const;
    void checkAxes();
    void addConnections();
    void addRequests();
    MechanismRequest makeRequest(const RequestStatement& statement) const;

    SimTK::Transform getMarkerPose(int id) const {
        return id == 0 ? SimTK::Transform() : m_markerPoses.at(id);
    }
    SimTK::Real calcReach(const PartStatement& statement) const;

    const Dataset& m_dataset;
    Diagnostics& m_diagnostics;
    bool m_failed = false;
    Mechanism m_mechanism;
    std::unordered_map<int, SimTK::Transform> m_markerPoses;  // in the part's BCS, undeformed
    // Parts are known by their place in Mechanism::getParts(), also before they are there.
    std::unordered_map<int, int> m_partIndex, m_flexBodyIndex;
    std::unordered_map<int, int> m_ownerOfMarker;
    std::unordered_map<int, std::vector<int>> m_markersOfOwner;
    std::unordered_map<int, ModalBasis> m_modes;  // by FLEX_BODY; in SI until it is added
};

}  // namespace jprim

#endif
