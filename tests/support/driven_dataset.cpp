// SPDX-License-Identifier: Apache-2.0
#include "support/driven_dataset.h"

#include <cmath>

#include "base/format.h"

namespace jprim::testing {

using SimTK::Vec3;

namespace {

std::string format(const Vec3& v) {
    return fmt::format("{},{},{}", v[0], v[1], v[2]);
}

}  // namespace

int DrivenDataset::addMarker(int part, const Vec3& place, const Vec3& angles) {
    m_text +=
        fmt::format("MARKER/{},PART={},QP={},REULER={}\n", ++m_markers, part, format(place), format(angles));
    return m_markers;
}

int DrivenDataset::addPart(int part, const Vec3& center) {
    const double mass = std::pow(10, draw(-1, 1)), I = mass * m_size * m_size;
    const double a = I * draw(0.02, 0.1), b = I * draw(0.02, 0.1), c = I * draw(0.02, 0.1);
    m_text +=
        fmt::format("PART/{},MASS={},IP={},{},{},CM={}\n", part, mass, a + b, b + c, c + a, m_markers + 1);
    return addMarker(part, center, drawVec3());
}

void DrivenDataset::addJoint(const char* type, int part, int onto, const Vec3& place, const Vec3& angles) {
    const int i = addMarker(part, place, angles), j = addMarker(onto, place, angles);
    m_text += fmt::format("JOINT/{},{},I={},J={}\n", ++m_joints, type, i, j);
}

void DrivenDataset::addMotion(bool isTurn) {
    const double a = draw(0.2, 1) * (isTurn ? 1 : m_size), w = draw(1, 7), phase = draw(-1.5, 1.5);
    const std::string functions[] = {fmt::format("SHF(TIME,0,{},{},{},{})", a, w, phase, a * std::sin(phase)),
                                     fmt::format("STEP(TIME,0.13,0,0.71,{})", a),
                                     fmt::format("{}*SIN({}*TIME)", a / 2, w),
                                     fmt::format("{}*SIN({}*TIME)", a * w / 2, w)};
    const int function = choose(4);
    m_text += fmt::format("MOTION/{0},JOINT={0}{1},FUNCTION={2}\n", m_joints,
                          function == 3 ? ",VELOCITY" : "", functions[function]);
}

void DrivenDataset::addSpring(int center, const Vec3& place) {
    const int j = addMarker(1, place, drawVec3());
    m_text += fmt::format("SPRINGDAMPER/{},TRANSLATION,I={},J={},K={},C={},LENGTH={}\n", ++m_forces, center,
                          j, std::pow(10, draw(0, 2.5)), choose(2) * draw(0.1, 3), m_size * draw(0.3, 2));
}

void DrivenDataset::addContact(int center, const Vec3& place) {
    const int j = addMarker(1, place, drawVec3());
    m_text += fmt::format(
        "SFORCE/{0},TRANSLATION,I={1},J={2},FUNCTION=IMPACT(DM({1},{2}),VR({1},{2}),{3},{4},{5},{6},{7})\n",
        ++m_forces, center, j, m_size * draw(0.4, 0.9), std::pow(10, draw(2, 4)), draw(1.3, 2.2), draw(0, 20),
        m_size * draw(0.01, 0.1));
}

// A brake is dry friction but for a small speed.
void DrivenDataset::addTree() {
    const char* types[] = {"REVOLUTE", "TRANSLATIONAL", "REVOLUTE", "SPHERICAL", "CYLINDRICAL"};
    const int parts = 1 + choose(4);
    for (int part = 2; part < parts + 2; ++part) {
        const Vec3 center = m_size * drawVec3();
        const int marker = addPart(part, center), type = choose(5);
        addJoint(types[type], part, 1 + choose(part - 1), center + m_size * 0.5 * drawVec3(), 3 * drawVec3());
        if (type < 3 && choose(2) == 0)
            addMotion(type != 1);
        else if (type != 1 && type != 3 && choose(2) == 0)
            m_text += fmt::format(
                "SFORCE/{0},ROTATION,I={1},J={2},FUNCTION=-{3}*STEP(WZ({1},{2},{2}),-0.2,-1,0.2,1)\n",
                ++m_forces, m_markers - 1, m_markers, draw(0.1, 1));
        if (choose(2) == 0) addSpring(marker, center + m_size * drawVec3());
        if (choose(3) == 0) addContact(marker, center + m_size * Vec3(0, 1, 0) + 0.2 * m_size * drawVec3());
    }
}

// The crank swings by less than a radian; the rod is long enough for any of its positions.
void DrivenDataset::addLinkage() {
    const Vec3 top = m_size * (Vec3(0, draw(0.4, 1), 0) + 0.1 * drawVec3());
    const Vec3 foot = m_size * (Vec3(draw(2, 3), 0, 0) + 0.2 * drawVec3());
    const Vec3 head = foot + m_size * (Vec3(0, draw(1.3, 2), 0) + 0.2 * drawVec3());
    addPart(2, top / 2);
    addPart(3, (top + head) / 2 + 0.1 * m_size * drawVec3());
    const int rocker = addPart(4, (foot + head) / 2);
    addJoint("SPHERICAL", 3, 2, top, drawVec3());
    addJoint("SPHERICAL", 4, 3, head, drawVec3());
    addJoint("REVOLUTE", 4, 1, foot, 0.2 * drawVec3());
    addJoint("REVOLUTE", 2, 1, Vec3(0), 0.2 * drawVec3());
    if (choose(4) > 0) addMotion(true);
    if (choose(2) == 0) addSpring(rocker, head + m_size * drawVec3());
}

std::string DrivenDataset::write() {
    m_text = "driven\nPART/1,GROUND\n";
    m_markers = m_joints = m_forces = 0;
    m_size = std::pow(10, draw(-1, 0.5));
    m_text += fmt::format("ACCGRAV/IGRAV={},JGRAV={},KGRAV={}\n", draw(-5, 5), draw(-9, 9), draw(-5, 5));
    if (choose(3) == 0)
        addLinkage();
    else
        addTree();
    return m_text + "END\n";
}

}  // namespace jprim::testing
