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
auto tie(const PointMassStatement& p) {
    return std::tuple_cat(tieCoordinates(p), std::tie(p.id, p.mass, p.cm));
}
auto tie(const MarkerStatement& m) {
    return std::tie(m.id, m.part, m.pointMass, m.flexBody, m.node, m.floating, m.qp, m.reuler, m.zp, m.xp,
                    m.usexp);
}
auto tie(const JprimStatement& j) {
    return std::tie(j.id, j.type, j.i, j.j);
}
auto tie(const JointInitialValue& v) {
    return std::tie(v.displacement, v.velocity);
}
auto tie(const JointStatement& j) {
    return std::tie(j.id, j.type, j.i, j.j, j.pitch, j.diameter);
}
auto tie(const GconStatement& g) {
    return std::tie(g.id, g.i, g.function);
}
auto tie(const MotionStatement& m) {
    return std::tie(m.id, m.joint, m.i, m.j, m.axis, m.level, m.function, m.icdisp, m.icvel);
}
auto tie(const CouplerStatement& c) {
    return std::tie(c.id, c.joints, c.types, c.scales);
}
auto tie(const SforceStatement& f) {
    return std::tie(f.id, f.i, f.j, f.rotational, f.actionOnly, f.function);
}
auto tie(const VectorForceStatement& f) {
    return std::tie(f.type, f.id, f.i, f.jfloat, f.rm, f.components, f.fxyz, f.txyz);
}
auto tie(const SpringdamperStatement& s) {
    return std::tie(s.id, s.i, s.j, s.rotational, s.stiffness, s.damping, s.freeLength, s.preload);
}
auto tie(const BushingStatement& b) {
    return std::tie(b.id, b.i, b.j, b.k, b.c, b.kt, b.ct, b.force, b.torque);
}
auto tie(const VariableStatement& v) {
    return std::tie(v.id, v.function, v.ic);
}
auto tie(const SplineStatement& s) {
    return std::tie(s.id, s.x, s.curves, s.linearExtrapolate);
}
auto tie(const SensorStatement& s) {
    return std::tie(s.id, s.function, s.value, s.error, s.comparison, s.halt, s.endsCommand);
}
auto tie(const RequestStatement& r) {
    return std::tie(r.id, r.type, r.i, r.j, r.rm, r.comment, r.title, r.resultsName, r.cnames, r.cunits,
                    r.clabels, r.ctitle, r.expressions);
}
auto tie(const IgnoredStatement& s) {
    return std::tie(s.keyword, s.id, s.arguments);
}

template <class Statement>
bool equal(const Statement& a, const Statement& b) {
    return tie(a) == tie(b);
}

template <class Statement>
bool equal(const std::optional<Statement>& a, const std::optional<Statement>& b) {
    return a.has_value() == b.has_value() && (!a || equal(*a, *b));
}

bool equal(const JointStatement& a, const JointStatement& b) {
    return tie(a) == tie(b) && equal(a.ic, b.ic) && equal(a.icTranslation, b.icTranslation) &&
           equal(a.icRotation, b.icRotation);
}

template <class Statement>
bool equal(const std::vector<Statement>& a, const std::vector<Statement>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Statement& x, const Statement& y) { return equal(x, y); });
}

bool equalConstraints(const Dataset& a, const Dataset& b) {
    return equal(a.jprims, b.jprims) && equal(a.joints, b.joints) && equal(a.gcons, b.gcons) &&
           equal(a.motions, b.motions) && equal(a.couplers, b.couplers);
}

bool equalForces(const Dataset& a, const Dataset& b) {
    return equal(a.sforces, b.sforces) && equal(a.vectorForces, b.vectorForces) &&
           equal(a.springdampers, b.springdampers) && equal(a.bushings, b.bushings);
}

// The name of an enumerator, from the list of all.
template <class Enum, std::size_t N>
const char* pick(const char* const (&names)[N], Enum value) {
    return names[static_cast<std::size_t>(value)];
}

}  // namespace

bool operator==(const Dataset& a, const Dataset& b) {
    return a.title == b.title && equal(a.units, b.units) && equal(a.gravity, b.gravity) &&
           equal(a.parts, b.parts) && equal(a.pointMasses, b.pointMasses) &&
           equal(a.flexBodies, b.flexBodies) && equal(a.markers, b.markers) && equalConstraints(a, b) &&
           equalForces(a, b) && equal(a.variables, b.variables) && equal(a.splines, b.splines) &&
           equal(a.sensors, b.sensors) && equal(a.requests, b.requests) && equal(a.ignored, b.ignored);
}

bool operator!=(const Dataset& a, const Dataset& b) {
    return !(a == b);
}

const char* getAdamsName(JprimType type) {
    return pick({"ATPOINT", "INLINE", "INPLANE", "ORIENTATION", "PARALLEL_AXES", "PERPENDICULAR"}, type);
}

const char* getAdamsName(JointType type) {
    return pick({"SPHERICAL", "REVOLUTE", "CYLINDRICAL", "TRANSLATIONAL", "PLANAR", "FIXED", "UNIVERSAL",
                 "HOOKE", "CONVEL", "SCREW", "RACKPIN"},
                type);
}

const char* getAdamsName(MotionAxis axis) {
    return pick({"", "ROTATIONAL", "TRANSLATIONAL", "X", "Y", "Z", "B1", "B2", "B3"}, axis);
}

const char* getAdamsName(MotionLevel level) {
    return pick({"DISPLACEMENT", "VELOCITY", "ACCELERATION"}, level);
}

const char* getAdamsName(CouplerType type) {
    return pick({"TRANSLATIONAL", "ROTATIONAL"}, type);
}

const char* getAdamsName(VectorForceType type) {
    return pick({"VFORCE", "VTORQUE", "GFORCE"}, type);
}

const char* getAdamsName(SensorComparison comparison) {
    return pick({"EQ", "GE", "LE"}, comparison);
}

const char* getAdamsName(RequestType type) {
    return pick({"DISPLACEMENT", "VELOCITY", "ACCELERATION", "FORCE", "EXPRESSIONS"}, type);
}

}  // namespace jprim
