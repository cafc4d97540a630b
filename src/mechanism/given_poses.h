// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_GIVEN_POSES_H_
#define JPRIM_SRC_MECHANISM_GIVEN_POSES_H_

#include <set>
#include <unordered_map>
#include <vector>

#include "SimTKcommon.h"
#include "jprim/dataset/dataset.h"
#include "mechanism/load_modes.h"
#include "mechanism/reporter.h"

namespace jprim {

/// Where a dataset puts its parts and markers. Parts are known by their place in Mechanism::getParts(): PARTs,
/// POINT_MASSes, then FLEX_BODYs.
class GivenPoses {
public:
    /// @param lengthToSI  factor of the dataset's lengths; the poses are in metres
    GivenPoses(const Dataset& dataset, const ModesOfBodies& modes, double lengthToSI, Reporter& reporter);

    /// The same in units of so many metres.
    [[nodiscard]] GivenPoses convertTo(double lengthUnit) const;

    [[nodiscard]] int getNumParts() const { return int(m_partPoses.size()); }
    /// The part that carries a marker.
    [[nodiscard]] int getPart(int marker) const { return m_partOfMarker.at(marker); }
    /// A part's body coordinate system (BCS) in ground.
    [[nodiscard]] const SimTK::Transform& getPartPose(int part) const { return m_partPoses[size_t(part)]; }
    /// A marker in the BCS of its part, undeformed; 0 is the BCS itself.
    [[nodiscard]] SimTK::Transform getPoseOnPart(int marker) const {
        return marker == 0 ? SimTK::Transform() : m_markerPoses.at(marker);
    }
    /// A marker in ground; 0 is ground's own frame.
    [[nodiscard]] SimTK::Transform getPose(int marker) const;
    /// False if the dataset has a mistake about it.
    [[nodiscard]] bool isDefined(int marker) const;

    /// Largest distance of a part's marker from a point of its BCS; floating markers, which are where they are needed,
    /// say nothing of that.
    [[nodiscard]] SimTK::Real calcReach(int part, const SimTK::Vec3& center) const;

private:
    template <class Statements>
    void addParts(const char* keyword, const Statements& statements, double lengthToSI, Reporter& reporter);
    void addMarker(const MarkerStatement& marker, int part, const ModesOfBodies& modes, double lengthToSI,
                   Reporter& reporter);

    std::vector<SimTK::Transform> m_partPoses;
    std::unordered_map<int, SimTK::Transform> m_markerPoses;
    std::unordered_map<int, int> m_partOfMarker;
    std::unordered_map<int, std::vector<int>> m_fixedMarkers;  // of a part
    std::set<int> m_undefinedParts, m_undefinedMarkers;
};

}  // namespace jprim

#endif
