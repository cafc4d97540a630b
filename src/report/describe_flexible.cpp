// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "report/describe.h"

namespace jprim {

using SimTK::Rotation;
using SimTK::Vec3;

namespace {

void append(const Vec3& v, std::vector<float>& numbers) {
    for (int k = 0; k < 3; ++k) numbers.push_back(float(v[k]));
}

class Describer {
public:
    Describer(const Mechanism& mechanism, const Motion& motion, size_t part)
        : m_motion(motion),
          m_units(mechanism.getUnits()),
          m_index(part),
          m_part(mechanism.getParts()[part]),
          m_basis(m_part.flexible->getBasis()) {}

    Json describe(size_t stride, ReportData& data) const {
        const size_t n = m_basis.nodes.size(), m = size_t(m_basis.getNumModes());
        return {{"part", m_index},
                {"points", data.addArray(makePoints(), {n, 3})},
                {"modes", data.addArray(makeModes(), {m, n, 3})},
                {"amplitudes", data.addArray(makeAmplitudes(stride), {countFrames(stride), m})}};
    }

private:
    size_t countFrames(size_t stride) const { return (m_motion.getNumFrames() + stride - 1) / stride; }

    std::vector<float> makePoints() const {
        std::vector<float> points;
        for (const ModalNode& node : m_basis.nodes)
            append(~m_part.bcs.getUndeformedPoseInBody() * node.position / m_units.length, points);
        return points;
    }

    // A modal coordinate is in sqrt(mass) length, both the dataset's.
    std::vector<float> makeModes() const {
        const Rotation R = ~m_part.bcs.getUndeformedPoseInBody().R();
        std::vector<float> modes;
        for (size_t k = 0; k < size_t(m_basis.getNumModes()); ++k)
            for (const ModalNode& node : m_basis.nodes)
                append(R * node.translation[k] * std::sqrt(m_units.mass), modes);
        return modes;
    }

    std::vector<float> makeAmplitudes(size_t stride) const {
        std::vector<float> amplitudes;
        for (size_t frame = 0; frame < m_motion.getNumFrames(); frame += stride)
            for (int k = 0; k < m_basis.getNumModes(); ++k)
                amplitudes.push_back(float(m_motion.getModalCoordinate(frame, m_index, k)));
        return amplitudes;
    }

    const Motion& m_motion;
    const UnitSystem& m_units;
    size_t m_index;
    const MechanismPart& m_part;
    const ModalBasis& m_basis;
};

}  // namespace

Json describeFlexible(const Mechanism& mechanism, const Motion& motion, size_t stride, ReportData& data) {
    Json flexible = Json::array();
    for (size_t k = 0; k < mechanism.getParts().size(); ++k)
        if (mechanism.getParts()[k].flexible)
            flexible.push_back(Describer(mechanism, motion, k).describe(stride, data));
    return flexible;
}

}  // namespace jprim
