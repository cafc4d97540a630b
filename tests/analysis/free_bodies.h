// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_ANALYSIS_FREE_BODIES_H_
#define JPRIM_TESTS_ANALYSIS_FREE_BODIES_H_

#include <algorithm>
#include <deque>
#include <set>
#include <string>
#include <vector>

#include "jprim/analysis/conflicts.h"
#include "jprim/analysis/constraint_report.h"
#include "jprim/joint/joint.h"

namespace jprim::testing {

/// A mechanism drawn in Ground, in a length unit of choice: free bodies, and joints between them that fit
/// where they are drawn.
class FreeBodies {
public:
    using Make = Joint (*)(const Marker& I, const Marker& J, const std::string& name);
    static constexpr int Ground = -1;

    explicit FreeBodies(double unit = 1) : m_unit(unit) {}

    /// A body whose frame is there in the drawing; returns its number.
    int addBody(const SimTK::Transform& X_GB = SimTK::Transform()) {
        const SimTK::Body::Rigid body(SimTK::MassProperties(1, SimTK::Vec3(0), SimTK::Inertia(1)));
        m_bodies.push_back(SimTK::MobilizedBody::Free(matter.Ground(), body));
        m_poses.push_back(X_GB);
        return int(m_bodies.size()) - 1;
    }

    /// The marker of a body that is at X_GM in the drawing.
    Marker mark(int body, const SimTK::Transform& X_GM) {
        if (body == Ground) return Marker(matter.Ground(), scale(X_GM));
        return Marker(m_bodies[size_t(body)], scale(~m_poses[size_t(body)] * X_GM));
    }

    /// A joint between body I and body J with both markers at X_GM.
    void addJoint(Make make, int I, int J, const SimTK::Transform& X_GM) {
        addJoint(make, mark(I, X_GM), mark(J, X_GM));
    }
    void addJoint(Make make, const Marker& I, const Marker& J) {
        joints.push_back(make(I, J, "JOINT/" + std::to_string(joints.size() + 1)));
    }

    /// The State as drawn, realized to Stage::Position.
    SimTK::State draw() {
        SimTK::State state = system.realizeTopology();
        for (size_t k = 0; k < m_bodies.size(); ++k) m_bodies[k].setQToFitTransform(state, scale(m_poses[k]));
        system.realize(state, SimTK::Stage::Position);
        return state;
    }
    ConstraintReport analyze() {
        const SimTK::State state = draw();
        return analyzeConstraints(matter, state, nameElements(joints));
    }

    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    std::vector<Joint> joints;

private:
    SimTK::Transform scale(const SimTK::Transform& X) const { return {X.R(), m_unit * X.p()}; }

    double m_unit;
    std::deque<SimTK::MobilizedBody::Free> m_bodies;
    std::vector<SimTK::Transform> m_poses;
};

/// A frame at p with its z axis along an axis, x anywhere.
inline SimTK::Transform makeHinge(const SimTK::Vec3& p, const SimTK::Vec3& z) {
    return {SimTK::Rotation(SimTK::UnitVec3(z), SimTK::ZAxis), p};
}

/// One primitive as a joint.
template <class Type>
Joint makePrimitive(const Marker& I, const Marker& J, const std::string& name) {
    return Joint(Type(I, J, name));
}

/// The texts of some of a report's equations.
template <class Report>
std::set<std::string> getTexts(const Report& report, const std::vector<int>& equations) {
    std::set<std::string> texts;
    for (const int k : equations) texts.insert(report.equations.at(size_t(k)).getText());
    return texts;
}

/// The texts of the redundant equations that are, or are not, onlyHere.
inline std::set<std::string> getRedundantTexts(const ConstraintReport& report, bool onlyHere = false) {
    std::set<std::string> texts;
    for (const RedundantEquation& r : report.redundant)
        if (r.onlyHere == onlyHere) texts.insert(report.equations.at(size_t(r.equation)).getText());
    return texts;
}

}  // namespace jprim::testing

#endif
