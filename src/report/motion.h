// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_REPORT_MOTION_H_
#define JPRIM_SRC_REPORT_MOTION_H_

#include <string>
#include <unordered_map>
#include <vector>

#include "jprim/mechanism/mechanism.h"
#include "jprim/results/results.h"

namespace jprim {

/// Where the parts of a mechanism were, as results have it: in the dataset's units.
class Motion {
public:
    /// Both must outlive it. @throws Error if the results are of another mechanism
    Motion(const Mechanism& mechanism, const Results& results);

    size_t getNumFrames() const { return m_results.parts.getNumRows(); }
    double getTime(size_t frame) const { return m_results.parts.getValue(frame, 0); }
    /// Pose in ground of a part's body coordinate system.
    SimTK::Transform calcPose(size_t frame, size_t part) const;
    /// Modal coordinate, from 0, of a flexible body.
    double getModalCoordinate(size_t frame, size_t part, int mode) const;

    /// A marker in its part's body coordinate system, nothing being deformed.
    SimTK::Transform findPoseOnPart(const Marker& marker, size_t part) const;
    /// The place among the mechanism's parts of the one that the marker is on.
    size_t findPart(const Marker& marker) const;

private:
    size_t findColumn(const std::string& name) const;

    const Mechanism& m_mechanism;
    const Results& m_results;
    std::unordered_map<std::string, size_t> m_columns;
    std::unordered_map<int, size_t> m_partOfBody;
    std::vector<size_t> m_first;           // of each part, the column of X
    std::vector<SimTK::Transform> m_X_CB;  // and the BCS in the CM marker's frame
    std::vector<size_t> m_firstMode;
};

}  // namespace jprim

#endif
