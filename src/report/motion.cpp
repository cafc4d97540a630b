// SPDX-License-Identifier: Apache-2.0
#include "report/motion.h"

#include "jprim/base/error.h"

namespace jprim {

using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

// Ground's columns are nowhere, and it does not move.
constexpr size_t NoColumn = size_t(-1);

}  // namespace

Motion::Motion(const Mechanism& mechanism, const Results& results)
    : m_mechanism(mechanism), m_results(results) {
    for (size_t k = 0; k < results.parts.columns.size(); ++k) m_columns.emplace(results.parts.columns[k], k);
    const std::vector<MechanismPart>& parts = mechanism.getParts();
    for (size_t k = 0; k < parts.size(); ++k) {
        const MechanismPart& part = parts[k];
        m_partOfBody.emplace(int(part.body.getMobilizedBodyIndex()), k);
        m_first.push_back(part.ground ? NoColumn : findColumn(part.name + ".X"));
        m_firstMode.push_back(part.flexible ? findColumn(part.name + ".Q1") : NoColumn);
    }
    for (size_t k = 0; k < parts.size(); ++k) m_X_CB.push_back(~findPoseOnPart(parts[k].cm, k));
}

size_t Motion::findColumn(const std::string& name) const {
    const auto found = m_columns.find(name);
    if (found == m_columns.end())
        throw Error(name, "is not a column of the results; they are not of this model");
    return found->second;
}

size_t Motion::findPart(const Marker& marker) const {
    const auto found = m_partOfBody.find(int(marker.getBody().getMobilizedBodyIndex()));
    if (found == m_partOfBody.end()) throw Error("marker", "is on no part of the mechanism");
    return found->second;
}

Transform Motion::findPoseOnPart(const Marker& marker, size_t part) const {
    const Marker& bcs = m_mechanism.getParts()[part].bcs;
    Transform X = ~bcs.getUndeformedPoseInBody() * marker.getUndeformedPoseInBody();
    X.updP() /= m_mechanism.getUnits().length;
    return X;
}

Transform Motion::calcPose(size_t frame, size_t part) const {
    if (m_first[part] == NoColumn) return {};
    const double* const x =
        m_results.parts.values.data() + frame * m_results.parts.columns.size() + m_first[part];
    const SimTK::Quaternion e(SimTK::Vec4(x[3], x[4], x[5], x[6]));
    return Transform(Rotation(e), Vec3(x[0], x[1], x[2])) * m_X_CB[part];
}

double Motion::getModalCoordinate(size_t frame, size_t part, int mode) const {
    return m_results.parts.getValue(frame, m_firstMode[part] + size_t(mode));
}

}  // namespace jprim
