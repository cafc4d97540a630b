// SPDX-License-Identifier: Apache-2.0
#include "support/random_dataset.h"

#include "base/format.h"
#include "jprim/marker/angles.h"

namespace jprim::testing {

using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;

/// A joint by its own name or by those of JPRIMs, and what it leaves free of I in J.
struct RandomDataset::Joint {
    enum class Turn { None, AboutZ, Any, CrossedZ, CrossedBars, InPlane };

    const char* name;                 // of a JOINT; null if there is none
    std::vector<const char*> jprims;  // empty if there are none
    Turn turn;
    Vec3 shift;  // 1 for each axis of J along which I is free
};

namespace {

std::string format(const Vec3& v) {
    return fmt::format("{},{},{}", v[0], v[1], v[2]);
}

}  // namespace

Rotation RandomDataset::drawRotation() {
    return Rotation(SimTK::BodyRotationSequence, draw(-3, 3), SimTK::XAxis, draw(-1.5, 1.5), SimTK::YAxis,
                    draw(-3, 3), SimTK::ZAxis);
}

// Where I may be in J. Turns stay away from where two orientations of a joint meet.
Transform RandomDataset::drawFit(const Joint& joint) {
    const Rotation aboutZ(draw(-1.5, 1.5), SimTK::ZAxis);
    Rotation R;
    switch (joint.turn) {
        case Joint::Turn::None: break;
        case Joint::Turn::AboutZ: R = aboutZ; break;
        case Joint::Turn::Any: R = drawRotation(); break;
        case Joint::Turn::CrossedZ:
            R = Rotation(draw(-3, 3), SimTK::ZAxis) * Rotation(SimTK::Pi / 2, SimTK::XAxis) * aboutZ;
            break;
        case Joint::Turn::CrossedBars:
            R = Rotation(draw(-1, 1), SimTK::YAxis) * Rotation(draw(-1, 1), SimTK::XAxis);
            break;
        case Joint::Turn::InPlane: R = ~aboutZ * Rotation(draw(-1, 1), SimTK::XAxis) * aboutZ; break;
    }
    return Transform(R, drawVec3().elementwiseMultiply(joint.shift));
}

void RandomDataset::addPart() {
    const int id = int(m_poses.size()) + 1;
    m_poses.push_back(drawPose());
    const double a = draw(0.1, 0.2), b = draw(0.1, 0.2), c = draw(0.1, 0.2);  // moments of three rods
    const double unit = m_length * m_length * drawFactor(m_spread.inertiaDecades), L = m_length;
    const double mass = draw(0.5, 3) * drawFactor(m_spread.massDecades);
    m_text += fmt::format("PART/{},MASS={},IP={},{},{},CM={},QG={},REULER={}", id, mass, (a + b) * unit,
                          (b + c) * unit, (c + a) * unit, m_lastMarker + 1, format(L * m_poses.back().p()),
                          format(calcAngles313(m_poses.back().R())));
    if (choose(3) == 0) m_text += fmt::format(",VX={},VZ={}", L * draw(-1, 1), L * draw(-1, 1));
    if (choose(3) == 0) m_text += fmt::format(",WY={},VY={}", draw(-2, 2), L * draw(-1, 1));
    m_text += "\n";
    m_centers.push_back(addMarker(id, Transform(drawRotation(), 0.3 * drawVec3())));
}

int RandomDataset::addMarker(int part, const Transform& X_PM) {
    m_text += fmt::format("MARKER/{},PART={},QP={},REULER={}\n", ++m_lastMarker, part,
                          format(m_length * X_PM.p()), format(calcAngles313(X_PM.R())));
    return m_lastMarker;
}

void RandomDataset::addJoint(const Joint& joint, int partI, int partJ) {
    const Transform X_PJ(drawRotation(), 0.7 * drawVec3());
    const Transform X_GI = m_poses[size_t(partJ) - 1] * X_PJ * drawFit(joint);
    const int j = addMarker(partJ, X_PJ), i = addMarker(partI, ~m_poses[size_t(partI) - 1] * X_GI);
    if (joint.name && (m_isDoubling || joint.jprims.empty() || choose(2) == 0)) {
        m_text += fmt::format("JOINT/{},{},I={},J={}\n", ++m_lastElement, joint.name, i, j);
        const std::string type = joint.name;
        if (choose(4) == 0 && (type == "REVOLUTE" || type == "TRANSLATIONAL"))
            m_text += fmt::format("MOTION/{0},JOINT={0},VELOCITY,FUNCTION={2}*({1}+SIN(TIME))\n",
                                  m_lastElement, draw(-1, 1), type == "REVOLUTE" ? 1 : m_length);
        if (m_isDoubling)
            for (int k = choose(3); k > 0; --k)
                addDouble(joint, partI, partJ, X_GI, m_poses[size_t(partJ) - 1] * X_PJ);
        return;
    }
    bool isFirst = true;
    for (const char* jprim : joint.jprims) {
        const bool swapped = !isFirst && choose(2) == 0;  // rotational ones mean the same either way
        m_text +=
            fmt::format("JPRIM/{},{},I={},J={}\n", ++m_lastElement, jprim, swapped ? j : i, swapped ? i : j);
        isFirst = false;
    }
}

// Where the joint leaves both markers free to go together, its equations are met at any place: X_GI D and X_GJ D.
void RandomDataset::addDouble(const Joint& joint, int partI, int partJ, const Transform& X_GI,
                              const Transform& X_GJ) {
    const std::map<std::string, Vec3> shifts = {{"REVOLUTE", Vec3(0, 0, 1)},
                                                {"CYLINDRICAL", Vec3(0, 0, 1)},
                                                {"TRANSLATIONAL", Vec3(1)},
                                                {"PLANAR", Vec3(1, 1, 0)},
                                                {"FIXED", Vec3(1)}};
    const auto shift = shifts.find(joint.name);
    if (shift == shifts.end()) return;
    const Rotation turn = shift->first == "FIXED" ? drawRotation() : Rotation(draw(-3, 3), SimTK::ZAxis);
    const Transform D(turn, drawVec3().elementwiseMultiply(shift->second));
    const int doubled = m_lastElement;
    const int j = addMarker(partJ, ~m_poses[size_t(partJ) - 1] * X_GJ * D);
    const int i = addMarker(partI, ~m_poses[size_t(partI) - 1] * X_GI * D);
    const int id = 1000 * doubled + int(m_doubles[doubled].size()) + 1;
    m_doubles[doubled].push_back(id);
    m_doublesText += fmt::format("JOINT/{},{},I={},J={}\n", id, joint.name, i, j);
}

// Two points stay as far apart as they are.
void RandomDataset::addDistance(int partI, int partJ) {
    const Vec3 onI = drawVec3(), onJ = drawVec3();
    const int i = addMarker(partI, onI), j = addMarker(partJ, onJ);
    const Vec3 r = m_poses[size_t(partI) - 1] * onI - m_poses[size_t(partJ) - 1] * onJ;
    m_text +=
        fmt::format("GCON/{0},I={1},FUNCTION=DM({1},{2})-{3}\n", ++m_lastElement, i, j, m_length * r.norm());
}

// Of the last two markers, relative to each other and in the axes of another; and all loads on the first centre.
void RandomDataset::addRequests() {
    const int i = m_lastMarker, j = m_lastMarker - 1, rm = choose(m_lastMarker) + 1;
    int id = 0;
    for (const char* type : {"DISPLACEMENT", "VELOCITY", "ACCELERATION", "FORCE"})
        m_text += fmt::format("REQUEST/{},{},I={},J={},RM={}\n", ++id, type, i, j, rm);
    // AX itself jumps by half a turn where a PERPENDICULAR's z_I passes x_J, to either side.
    m_text +=
        fmt::format("REQUEST/{},F2=SIN(AX({},{}))\\F3=ACCX({})\\F4=FZ({},{},{})\n", ++id, i, j, i, i, j, rm);
}

void RandomDataset::addForces() {
    const int i = m_centers[size_t(choose(int(m_centers.size())))];
    m_text += fmt::format(
        "MARKER/9999,PART=1,FLOATING\nGFORCE/1,I={0},JFLOAT=9999,RM={0},FX={1}\\FY=-VY({0})\\TZ={2}\n", i,
        draw(-2, 2), draw(-1, 1));
}

std::string RandomDataset::write(int parts, int loops) {
    writeMechanism(parts, loops);
    addRequests();
    if (choose(2) == 0) addForces();
    return m_text + "END\n";
}

DoubledDataset RandomDataset::writeDoubled(int parts, int loops) {
    m_isDoubling = true;
    writeMechanism(parts, loops);
    return {m_text + "END\n", m_text + m_doublesText + "END\n", m_doubles};
}

void RandomDataset::writeMechanism(int parts, int loops) {
    using Turn = Joint::Turn;
    const Vec3 none(0), alongZ(0, 0, 1), inXy(1, 1, 0), all(1);
    const Joint joints[] = {{"FIXED", {"ATPOINT", "ORIENTATION"}, Turn::None, none},
                            {"REVOLUTE", {"ATPOINT", "PARALLEL_AXES"}, Turn::AboutZ, none},
                            {"TRANSLATIONAL", {"INLINE", "ORIENTATION"}, Turn::None, alongZ},
                            {"UNIVERSAL", {"ATPOINT", "PERPENDICULAR"}, Turn::CrossedZ, none},
                            {"CYLINDRICAL", {"INLINE", "PARALLEL_AXES"}, Turn::AboutZ, alongZ},
                            {"HOOKE", {}, Turn::CrossedBars, none},
                            {"CONVEL", {}, Turn::InPlane, none},
                            {"SPHERICAL", {"ATPOINT"}, Turn::Any, none},
                            {"PLANAR", {"INPLANE", "PARALLEL_AXES"}, Turn::AboutZ, inXy},
                            {nullptr, {"ORIENTATION"}, Turn::None, all},
                            {nullptr, {"ORIENTATION", "INPLANE"}, Turn::None, inXy},
                            {nullptr, {"INLINE"}, Turn::Any, alongZ},
                            {nullptr, {"INPLANE"}, Turn::Any, inXy},
                            {nullptr, {"PARALLEL_AXES"}, Turn::AboutZ, all},
                            {nullptr, {"PERPENDICULAR"}, Turn::CrossedZ, all}};
    const int numJoints = int(std::size(joints)), firstForLoops = 7;

    m_text = "random\n";
    if (m_spread.inMillimetres) m_text += "UNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=SECOND\n";
    m_text += "PART/1,GROUND\n";
    m_poses = {Transform()};
    m_centers.clear();
    m_text += fmt::format("ACCGRAV/IGRAV={},JGRAV={},KGRAV={}\n", m_length * draw(-9, 9),
                          m_length * draw(-9, 9), m_length * draw(-9, 9));
    for (int part = 2; part < parts + 2; ++part) {
        addPart();
        const int other = choose(part - 1) + 1;
        const Joint& joint = joints[choose(numJoints)];
        const bool carriesI = choose(2) == 0;
        addJoint(joint, carriesI ? part : other, carriesI ? other : part);
    }
    for (int k = 0; k < loops; ++k) {
        const int a = choose(parts) + 2;
        const int b = (a + choose(parts)) % (parts + 1) + 1;  // another one, or ground
        const int joint = firstForLoops + choose(numJoints - firstForLoops + 1);
        if (joint < numJoints)
            addJoint(joints[joint], a, b);
        else
            addDistance(a, b);
    }
}

}  // namespace jprim::testing
