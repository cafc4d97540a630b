// SPDX-License-Identifier: Apache-2.0
// Constraints, forces, and what belongs to them. What has its default value is left out.
#include <array>

#include "base/format.h"
#include "dataset/statement_writer.h"

namespace jprim {
namespace {

// `KEYWORD/id, TYPE, I=, J=`
template <class Statement>
void beginConnection(StatementWriter& w, const char* keyword, const char* type, const Statement& s) {
    w.begin(keyword, s.id);
    w.add(type);
    w.add("I", s.i);
    w.add("J", s.j);
}

const char* getForceType(bool rotational) {
    return rotational ? "ROTATIONAL" : "TRANSLATIONAL";
}

void addInitialValue(StatementWriter& w, const char* name, const std::optional<JointInitialValue>& value) {
    if (!value) return;
    w.add(name, std::optional<double>(value->displacement));
    if (value->velocity) w.add(fmt::format("{}", *value->velocity));
}

void addFunction(StatementWriter& w, const ExpressionText& function) {
    w.addExpression("FUNCTION", function.text);
}

// A list that is 0 need not be written.
void addTriple(StatementWriter& w, const char* name, const Triple& triple) {
    if (triple != Triple{}) w.add(name, std::optional<Triple>(triple));
}

void addNonzero(StatementWriter& w, const char* name, double number) {
    if (number != 0) w.add(name, std::optional<double>(number));
}

}  // namespace

void write(StatementWriter& w, const JprimStatement& s) {
    beginConnection(w, "JPRIM", getAdamsName(s.type), s);
    w.end();
}

void write(StatementWriter& w, const JointStatement& s) {
    beginConnection(w, "JOINT", getAdamsName(s.type), s);
    w.add("PITCH", s.pitch);
    w.add("PD", s.diameter);
    addInitialValue(w, "IC", s.ic);
    addInitialValue(w, "ICTRAN", s.icTranslation);
    addInitialValue(w, "ICROT", s.icRotation);
    w.end();
}

void write(StatementWriter& w, const GconStatement& s) {
    w.begin("GCON", s.id);
    w.add("I", s.i);
    addFunction(w, s.function);
    w.end();
}

void write(StatementWriter& w, const MotionStatement& s) {
    w.begin("MOTION", s.id);
    w.add("JOINT", s.joint);
    w.add("I", s.i);
    w.add("J", s.j);
    if (s.axis != MotionAxis::Joint) w.add(getAdamsName(s.axis));
    if (s.level != MotionLevel::Displacement) w.add(getAdamsName(s.level));
    w.add("ICDISP", s.icdisp);
    w.add("ICVEL", s.icvel);
    addFunction(w, s.function);
    w.end();
}

void write(StatementWriter& w, const CouplerStatement& s) {
    w.begin("COUPLER", s.id);
    for (std::size_t k = 0; k < s.joints.size(); ++k)
        w.add(fmt::format("{}{}", k == 0 ? "JOINTS=" : "", s.joints[k]));
    std::string types;
    for (const CouplerType type : s.types)
        types += (types.empty() ? "" : ":") + std::string(1, *getAdamsName(type));
    w.add("TYPE", types);
    w.add("SCALES", s.scales);
    w.end();
}

void write(StatementWriter& w, const SforceStatement& s) {
    beginConnection(w, "SFORCE", getForceType(s.rotational), s);
    if (s.actionOnly) w.add("ACTIONONLY");
    addFunction(w, s.function);
    w.end();
}

void write(StatementWriter& w, const VectorForceStatement& s) {
    constexpr std::array<const char*, 6> names = {"FX", "FY", "FZ", "TX", "TY", "TZ"};
    w.begin(getAdamsName(s.type), s.id);
    w.add("I", s.i);
    w.add("JFLOAT", s.jfloat);
    w.add("RM", s.rm);
    for (std::size_t k = 0; k < names.size(); ++k) w.add(names[k], s.components[k]);
    w.add("FXYZ", s.fxyz);
    w.add("TXYZ", s.txyz);
    w.end();
}

void write(StatementWriter& w, const SpringdamperStatement& s) {
    beginConnection(w, "SPRINGDAMPER", getForceType(s.rotational), s);
    addNonzero(w, s.rotational ? "KT" : "K", s.stiffness);
    addNonzero(w, s.rotational ? "CT" : "C", s.damping);
    addNonzero(w, s.rotational ? "ANGLE" : "LENGTH", s.freeLength);
    addNonzero(w, s.rotational ? "TORQUE" : "FORCE", s.preload);
    w.end();
}

void write(StatementWriter& w, const BushingStatement& s) {
    w.begin("BUSHING", s.id);
    w.add("I", s.i);
    w.add("J", s.j);
    addTriple(w, "K", s.k);
    addTriple(w, "C", s.c);
    addTriple(w, "KT", s.kt);
    addTriple(w, "CT", s.ct);
    addTriple(w, "FORCE", s.force);
    addTriple(w, "TORQUE", s.torque);
    w.end();
}

void write(StatementWriter& w, const VariableStatement& s) {
    w.begin("VARIABLE", s.id);
    w.add("IC", s.ic);
    addFunction(w, s.function);
    w.end();
}

// A single curve at z = 0 is written, and read, without its z.
void write(StatementWriter& w, const SplineStatement& s) {
    w.begin("SPLINE", s.id);
    if (s.linearExtrapolate) w.add("LINEAR_EXTRAPOLATE");
    w.add("X", s.x);
    for (const auto& [z, y] : s.curves) {
        std::vector<double> numbers = y;
        if (s.curves.size() > 1 || z != 0) numbers.insert(numbers.begin(), z);
        w.add("Y", numbers);
    }
    w.end();
}

void write(StatementWriter& w, const SensorStatement& s) {
    w.begin("SENSOR", s.id);
    w.add(getAdamsName(s.comparison));
    w.add("VALUE", std::optional<double>(s.value));
    w.add("ERROR", std::optional<double>(s.error));
    if (s.halt) w.add("HALT");
    if (s.endsCommand) w.add("RETURN");
    addFunction(w, s.function);
    w.end();
}

}  // namespace jprim
