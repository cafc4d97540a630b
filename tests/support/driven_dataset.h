// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_DRIVEN_DATASET_H_
#define JPRIM_TESTS_SUPPORT_DRIVEN_DATASET_H_

#include <random>
#include <string>

#include "SimTKcommon.h"

namespace jprim::testing {

/// Writes datasets of mechanisms into which energy is put and out of which it is taken: trees of hinges, slides, balls
/// and cylinders, or a crank and a rocker with a rod between balls, with motors, springs, dampers, brakes and contacts.
/// All parts' frames are Ground's at the start. In SI, sizes of 0.1 to 3, masses over two decades.
class DrivenDataset {
public:
    explicit DrivenDataset(unsigned seed) : m_random(seed) {}
    std::string write();

private:
    double draw(double from, double to) { return std::uniform_real_distribution<double>(from, to)(m_random); }
    int choose(int count) { return std::uniform_int_distribution<int>(0, count - 1)(m_random); }
    SimTK::Vec3 drawVec3() { return {draw(-1, 1), draw(-1, 1), draw(-1, 1)}; }

    int addMarker(int part, const SimTK::Vec3& place, const SimTK::Vec3& angles);
    /// @returns its CM marker
    int addPart(int part, const SimTK::Vec3& center);
    void addJoint(const char* type, int part, int onto, const SimTK::Vec3& place, const SimTK::Vec3& angles);
    void addMotion(bool isTurn);
    void addTree();
    void addLinkage();
    void addSpring(int center, const SimTK::Vec3& place);
    void addContact(int center, const SimTK::Vec3& place);

    std::mt19937 m_random;
    std::string m_text;
    double m_size = 1;
    int m_markers = 0, m_joints = 0, m_forces = 0;
};

}  // namespace jprim::testing

#endif
