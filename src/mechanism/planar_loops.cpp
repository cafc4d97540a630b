// SPDX-License-Identifier: Apache-2.0
#include "mechanism/planar_loops.h"

#include <cmath>

namespace jprim {

using SimTK::Real;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

// Of an axis of length 1, and of a height in a mechanism whose parts are of order 1: what assembly lets pass.
constexpr Real Aligned = 1e-9;

// Whether a joint moves in planes of the normal n, given in its markers' axes, only.
bool keepsPlane(MobilizerType type, const Vec3& n) {
    switch (type) {
        case MobilizerType::Weld: return true;
        case MobilizerType::Pin:
        case MobilizerType::Planar: return std::hypot(n[0], n[1]) <= Aligned;
        case MobilizerType::Slider: return std::abs(n[2]) <= Aligned;
        default: return false;
    }
}

}  // namespace

PlanarLoops::PlanarLoops(const TreePlan& plan, const GivenPoses& poses) : m_poses(poses) {
    for (const PlannedMobilizer& mobilizer : plan.getMobilizers()) m_mobilizers[mobilizer.part] = &mobilizer;
}

// Joints that keep a plane leave its normal alone, and the heights of I and J the same.
std::optional<PlanarLoops::Plane> PlanarLoops::carryToParent(const PlannedMobilizer& m,
                                                             const Plane& plane) const {
    const Transform onPart = m_poses.getPoseOnPart(m.reversed ? m.j : m.i);
    const Transform onParent = m_poses.getPoseOnPart(m.reversed ? m.i : m.j);
    const Vec3 n = ~onPart.R() * plane.normal;
    if (!keepsPlane(m.type, n)) return std::nullopt;
    const Vec3 normal = onParent.R() * n;
    return Plane{normal, plane.height - dot(onPart.p(), plane.normal) + dot(onParent.p(), normal)};
}

// The marker's xy plane as it looks on each part on the way to the root, as far as it stays a plane.
std::unordered_map<int, PlanarLoops::Plane> PlanarLoops::carryToRoot(int marker) const {
    const Transform X = m_poses.getPoseOnPart(marker);
    const Vec3 normal(X.R().z());
    std::optional<Plane> plane = Plane{normal, dot(X.p(), normal)};
    int part = m_poses.getPart(marker);
    std::unordered_map<int, Plane> planes;
    while (plane) {
        planes[part] = *plane;
        const auto mobilizer = m_mobilizers.find(part);
        if (mobilizer == m_mobilizers.end() || mobilizer->second->parent < 0) break;
        plane = carryToParent(*mobilizer->second, *plane);
        part = mobilizer->second->parent;
    }
    return planes;
}

bool PlanarLoops::isPlanar(int i, int j) const {
    const auto ofI = carryToRoot(i), ofJ = carryToRoot(j);
    for (const auto& [part, plane] : ofI) {
        const auto other = ofJ.find(part);
        if (other == ofJ.end()) continue;
        return (plane.normal - other->second.normal).norm() <= Aligned &&
               std::abs(plane.height - other->second.height) <= Aligned;
    }
    return false;
}

LoopEquations findLoopEquations(JprimType type) {
    switch (type) {
        case JprimType::AtPoint: return LoopEquations::InLine;
        case JprimType::InPlane:
        case JprimType::ParallelAxes: return LoopEquations::None;
        default: return LoopEquations::All;
    }
}

LoopEquations findLoopEquations(JointType type) {
    switch (type) {
        case JointType::Spherical:
        case JointType::Revolute:
        case JointType::Cylindrical: return LoopEquations::InLine;
        case JointType::Planar: return LoopEquations::None;
        default: return LoopEquations::All;
    }
}

}  // namespace jprim
