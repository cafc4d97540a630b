// SPDX-License-Identifier: Apache-2.0
#include "jprim/dataset/dataset.h"

#include <algorithm>
#include <tuple>

namespace jprim {
namespace {

// What a statement says, without where it stands.
auto tie(const UnitsStatement& u) {
    return std::tie(u.names, u.system, u.toSI.force, u.toSI.mass, u.toSI.length, u.toSI.time, u.ucf);
}
auto tie(const AccgravStatement& a) {
    return std::tie(a.acceleration);
}
auto tieCoordinates(const RigidCoordinates& c) {
    return std::tie(c.qg, c.reuler, c.zg, c.xg, c.v, c.w, c.vm, c.wm, c.exact);
}
auto tie(const PartStatement& p) {
    return std::tuple_cat(tieCoordinates(p), std::tie(p.id, p.ground, p.mass, p.cm, p.im, p.ip));
}
auto tie(const FlexBodyStatement& f) {
    return std::tuple_cat(tieCoordinates(f), std::tie(f.id, f.modesFile, f.cratio, f.constantCoupling));
}
auto tie(const MarkerStatement& m) {
    return std::tie(m.id, m.part, m.flexBody, m.node, m.qp, m.reuler, m.zp, m.xp, m.usexp);
}
auto tie(const JprimStatement& j) {
    return std::tie(j.id, j.type, j.i, j.j);
}
auto tie(const JointStatement& j) {
    return std::tie(j.id, j.type, j.i, j.j);
}
auto tie(const RequestStatement& r) {
    return std::tie(r.id, r.type, r.i, r.j, r.rm, r.comment, r.title, r.expressions);
}
auto tie(const IgnoredStatement& s) {
    return std::tie(s.keyword, s.id, s.arguments);
}

template <class Statement>
bool equal(const std::optional<Statement>& a, const std::optional<Statement>& b) {
    return a.has_value() == b.has_value() && (!a || tie(*a) == tie(*b));
}

template <class Statement>
bool equal(const std::vector<Statement>& a, const std::vector<Statement>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Statement& x, const Statement& y) { return tie(x) == tie(y); });
}

}  // namespace

// Folder and counts tell how reading went and are no part of what the dataset says.
bool operator==(const Dataset& a, const Dataset& b) {
    return a.title == b.title && equal(a.units, b.units) && equal(a.gravity, b.gravity) &&
           equal(a.parts, b.parts) && equal(a.flexBodies, b.flexBodies) && equal(a.markers, b.markers) &&
           equal(a.jprims, b.jprims) && equal(a.joints, b.joints) && equal(a.requests, b.requests) &&
           equal(a.ignored, b.ignored);
}

bool operator!=(const Dataset& a, const Dataset& b) {
    return !(a == b);
}

const char* getAdamsName(JprimType type) {
    constexpr const char* names[] = {"ATPOINT",     "INLINE",        "INPLANE",
                                     "ORIENTATION", "PARALLEL_AXES", "PERPENDICULAR"};
    return names[static_cast<std::size_t>(type)];
}

const char* getAdamsName(JointType type) {
    constexpr const char* names[] = {"SPHERICAL", "REVOLUTE", "CYLINDRICAL", "TRANSLATIONAL",
                                     "PLANAR",    "FIXED",    "UNIVERSAL",   "HOOKE"};
    return names[static_cast<std::size_t>(type)];
}

const char* getAdamsName(RequestType type) {
    constexpr const char* names[] = {"DISPLACEMENT", "VELOCITY", "ACCELERATION", "FORCE", "EXPRESSIONS"};
    return names[static_cast<std::size_t>(type)];
}

}  // namespace jprim
