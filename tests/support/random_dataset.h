// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_RANDOM_DATASET_H_
#define JPRIM_TESTS_SUPPORT_RANDOM_DATASET_H_

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "SimTKcommon.h"

namespace jprim::testing {

/// A dataset twice: with single joints, and with some of them held by more of the same kind. Both have the markers.
struct DoubledDataset {
    std::string single, doubled;
    std::map<int, std::vector<int>> doubles;  // JOINT ids: each one's doubles
};

/// Over how many decades masses and moments of inertia go, about 1 kg and 0.2 kg m^2, and the dataset's unit of length.
struct Spread {
    double massDecades = 0;
    double inertiaDecades = 0;
    bool inMillimetres = false;
};

/// Writes datasets of parts that are joined at random: first a tree of joints, then joints that close loops. Parts
/// lie anywhere in any orientation; the markers of a joint are placed so that it fits. Sizes are of order 1 m.
class RandomDataset {
public:
    explicit RandomDataset(unsigned seed, const Spread& spread = {})
        : m_spread(spread), m_length(spread.inMillimetres ? 1000 : 1), m_random(seed) {}

    /// @param parts  besides ground
    /// @param loops  joints more than a tree needs
    std::string write(int parts, int loops);
    /// The same without REQUESTs, with joints that are doubled along what they leave free: hinges along their axis,
    /// sliders and fixed joints anywhere.
    DoubledDataset writeDoubled(int parts, int loops);

private:
    struct Joint;

    double draw(double from, double to) { return std::uniform_real_distribution<double>(from, to)(m_random); }
    int choose(int count) { return std::uniform_int_distribution<int>(0, count - 1)(m_random); }
    SimTK::Vec3 drawVec3() { return {draw(-1, 1), draw(-1, 1), draw(-1, 1)}; }
    SimTK::Rotation drawRotation();
    SimTK::Transform drawPose() { return SimTK::Transform(drawRotation(), drawVec3()); }

    void writeMechanism(int parts, int loops);
    void addPart();
    int addMarker(int part, const SimTK::Transform& X_PM);
    void addJoint(const Joint& joint, int partI, int partJ);
    void addDouble(const Joint& joint, int partI, int partJ, const SimTK::Transform& X_GI,
                   const SimTK::Transform& X_GJ);
    SimTK::Transform drawFit(const Joint& joint);
    void addDistance(int partI, int partJ);
    void addForces();
    void addRequests();

    double drawFactor(double decades) {
        return decades > 0 ? std::pow(10, draw(-decades / 2, decades / 2)) : 1;
    }

    Spread m_spread;
    double m_length;  // the dataset's units of length in a metre
    std::mt19937 m_random;
    std::string m_text;
    std::string m_doublesText;
    std::map<int, std::vector<int>> m_doubles;
    bool m_isDoubling = false;
    std::vector<SimTK::Transform> m_poses;  // of the parts, ground first
    std::vector<int> m_centers;             // CM markers
    int m_lastMarker = 0, m_lastElement = 0;
};

}  // namespace jprim::testing

#endif
