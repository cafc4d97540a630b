// SPDX-License-Identifier: Apache-2.0
#include "marker/marker_vocabulary.h"

#include <algorithm>
#include <iterator>

#include "base/format.h"
#include "expression/compile_expression.h"

namespace jprim {

namespace {

/// One measure, or one for each axis. Ids that were left out are 0.
struct Measure {
    const char* name;
    int most;        // markers; the first is mandatory
    int leastGiven;  // and so are the others up to here
    int axis;        // 0, 1, 2, or -1 if the measure has none
    Operand (*make)(MarkerFrames& frames, const int* ids, int axis);
};

Operand makeArctangent(MarkerFrames& f, Operand y, Operand x) {
    return f.updBuilder().atan2(y, x);
}

Operand makeNegative(MarkerFrames& f, Operand a) {
    return f.updBuilder().negate(a);
}

// Body-fixed 3-1-3 angles: R = Rz(psi) Rx(theta) Rz(phi).
Operand makePsi(MarkerFrames& f, const int* m, int) {
    return makeArctangent(f, f.element(m[0], m[1], 0, 2), makeNegative(f, f.element(m[0], m[1], 1, 2)));
}

Operand makeTheta(MarkerFrames& f, const int* m, int) {
    ProgramBuilder& b = f.updBuilder();
    const Operand tilt = b.vector(f.element(m[0], m[1], 0, 2), f.element(m[0], m[1], 1, 2), b.number(0));
    return b.atan2(b.norm(tilt), f.element(m[0], m[1], 2, 2));
}

Operand makePhi(MarkerFrames& f, const int* m, int) {
    return makeArctangent(f, f.element(m[0], m[1], 2, 0), f.element(m[0], m[1], 2, 1));
}

// Body-fixed 3-2-1 angles; PITCH is minus the second one.
Operand makeYaw(MarkerFrames& f, const int* m, int) {
    return makeArctangent(f, f.element(m[0], m[1], 1, 0), f.element(m[0], m[1], 0, 0));
}

Operand makePitch(MarkerFrames& f, const int* m, int) {
    ProgramBuilder& b = f.updBuilder();
    const Operand level = b.vector(f.element(m[0], m[1], 0, 0), f.element(m[0], m[1], 1, 0), b.number(0));
    return b.atan2(f.element(m[0], m[1], 2, 0), b.norm(level));
}

Operand makeRoll(MarkerFrames& f, const int* m, int) {
    return makeArctangent(f, f.element(m[0], m[1], 2, 1), f.element(m[0], m[1], 2, 2));
}

Operand makeIncludedAngle(MarkerFrames& f, const int* m, int) {
    ProgramBuilder& b = f.updBuilder();
    const Operand toI = f.position(m[0], m[1]), toK = f.position(m[2], m[1]);
    return b.atan2(b.norm(b.cross(toI, toK)), b.multiply(toI, toK));
}

// clang-format off
#define JPRIM_EACH_AXIS(name, most, least, make) {name "X", most, least, 0, make}, {name "Y", most, least, 1, make}, {name "Z", most, least, 2, make}
const Measure Measures[] = {
    JPRIM_EACH_AXIS("D", 3, 1, [](MarkerFrames& f, const int* m, int axis) { return f.along(f.position(m[0], m[1]), m[2], axis); }),
    {"DXYZ", 3, 1, -1, [](MarkerFrames& f, const int* m, int) { return f.inAxesOf(f.position(m[0], m[1]), m[2]); }},
    {"DM", 2, 1, -1, [](MarkerFrames& f, const int* m, int) { return f.distance(m[0], m[1]); }},
    JPRIM_EACH_AXIS("V", 4, 1, [](MarkerFrames& f, const int* m, int axis) { return f.along(f.velocity(m[0], m[1], m[3]), m[2], axis); }),
    {"VXYZ", 4, 1, -1, [](MarkerFrames& f, const int* m, int) { return f.inAxesOf(f.velocity(m[0], m[1], m[3]), m[2]); }},
    {"VM", 3, 1, -1, [](MarkerFrames& f, const int* m, int) { return f.updBuilder().norm(f.velocity(m[0], m[1], m[2])); }},
    {"VR", 3, 2, -1, [](MarkerFrames& f, const int* m, int) { return f.radialVelocity(m[0], m[1], m[2]); }},
    JPRIM_EACH_AXIS("ACC", 4, 1, [](MarkerFrames& f, const int* m, int axis) { return f.along(f.acceleration(m[0], m[1], m[3]), m[2], axis); }),
    {"ACCXYZ", 4, 1, -1, [](MarkerFrames& f, const int* m, int) { return f.inAxesOf(f.acceleration(m[0], m[1], m[3]), m[2]); }},
    {"ACCM", 3, 1, -1, [](MarkerFrames& f, const int* m, int) { return f.updBuilder().norm(f.acceleration(m[0], m[1], m[2])); }},
    JPRIM_EACH_AXIS("W", 3, 1, [](MarkerFrames& f, const int* m, int axis) { return f.along(f.angularVelocity(m[0], m[1]), m[2], axis); }),
    {"WXYZ", 3, 1, -1, [](MarkerFrames& f, const int* m, int) { return f.inAxesOf(f.angularVelocity(m[0], m[1]), m[2]); }},
    {"WM", 2, 1, -1, [](MarkerFrames& f, const int* m, int) { return f.updBuilder().norm(f.angularVelocity(m[0], m[1])); }},
    JPRIM_EACH_AXIS("WDT", 4, 1, [](MarkerFrames& f, const int* m, int axis) { return f.along(f.angularAcceleration(m[0], m[1], m[3]), m[2], axis); }),
    {"WDTXYZ", 4, 1, -1, [](MarkerFrames& f, const int* m, int) { return f.inAxesOf(f.angularAcceleration(m[0], m[1], m[3]), m[2]); }},
    {"WDTM", 3, 1, -1, [](MarkerFrames& f, const int* m, int) { return f.updBuilder().norm(f.angularAcceleration(m[0], m[1], m[2])); }},
    JPRIM_EACH_AXIS("A", 2, 1, [](MarkerFrames& f, const int* m, int axis) { return f.projectedAngle(m[0], m[1], axis); }),
    {"PSI", 2, 1, -1, makePsi}, {"THETA", 2, 1, -1, makeTheta}, {"PHI", 2, 1, -1, makePhi},
    {"YAW", 2, 1, -1, makeYaw}, {"PITCH", 2, 1, -1, makePitch}, {"ROLL", 2, 1, -1, makeRoll},
    JPRIM_EACH_AXIS("UV", 1, 1, [](MarkerFrames& f, const int* m, int axis) { return f.axis(m[0], axis); }),
    {"INCANG", 3, 3, -1, makeIncludedAngle}};
#undef JPRIM_EACH_AXIS
// clang-format on

std::string describeNumber(int least, int most) {
    if (least == most) return least == 1 ? "1 id" : fmt::format("{} ids", least);
    return fmt::format("{} to {} ids", least, most);
}

}  // namespace

std::vector<int> MarkerVocabulary::getIds(const Call& call, int least, int most) {
    const int given = int(call.arguments.size());
    if (given < least || given > most)
        throw ExpressionError(
            call.offset, fmt::format("{} takes {}, not {}", call.name, describeNumber(least, most), given));
    std::vector<int> ids(size_t(most), 0);
    for (size_t k = 0; k < call.arguments.size(); ++k) {
        const Argument& argument = call.arguments[k];
        if (!argument.id)
            throw ExpressionError(argument.offset,
                                  fmt::format("argument {} of {} must be an id", k + 1, call.name));
        ids[k] = *argument.id;
    }
    return ids;
}

void MarkerVocabulary::checkMarker(const Call& call, size_t argument, int id) const {
    if (!m_frames.exists(id)) throw ExpressionError(call.arguments[argument].offset, describeMissing(id));
}

std::string MarkerVocabulary::describeMissing(int id) const {
    return fmt::format("MARKER/{} does not exist", id);
}

std::optional<Operand> MarkerVocabulary::call(ProgramBuilder& builder, const Call& call) {
    if (call.name == "VARVAL")
        return makeVariable(builder, getIds(call, 1, 1)[0], call.offset, call.arguments[0].offset);
    const auto named = [&call](const Measure& measure) { return call.name == measure.name; };
    const Measure* measure = std::find_if(std::begin(Measures), std::end(Measures), named);
    if (measure == std::end(Measures)) return std::nullopt;
    const std::vector<int> ids = getIds(call, measure->leastGiven, measure->most);
    for (size_t k = 0; k < call.arguments.size(); ++k) checkMarker(call, k, ids[k]);
    if (ids[0] == 0)
        throw ExpressionError(call.arguments[0].offset,
                              fmt::format("the first marker of {} must not be 0", call.name));
    return measure->make(m_frames, ids.data(), measure->axis);
}

Operand MarkerVocabulary::makeVariable(ProgramBuilder& builder, int id, size_t offset, size_t idOffset) {
    const std::string* text = findVariable(id);
    if (!text) throw ExpressionError(idOffset, fmt::format("VARIABLE/{} does not exist", id));
    return makeNamed(fmt::format("VARIABLE/{}", id), offset,
                     [&] { return compileExpression(*text, builder, *this); });
}

Operand MarkerVocabulary::makeNamed(const std::string& name, size_t offset,
                                    const std::function<Operand()>& make) {
    const auto known = m_named.find(name);
    if (known != m_named.end()) return known->second;
    if (std::find(m_open.begin(), m_open.end(), name) != m_open.end())
        throw ExpressionError(
            offset, fmt::format("{} depends on itself; implicit variables are not supported", name));
    m_open.push_back(name);
    Operand value;
    try {
        value = make();
    } catch (const ExpressionError& error) {
        throw ExpressionError(offset, fmt::format("in {}: {}", name, error.what()));
    }
    m_open.pop_back();
    m_named[name] = value;
    return value;
}

std::vector<std::string> MarkerVocabulary::getNames() const {
    std::vector<std::string> names{"VARVAL"};
    for (const Measure& measure : Measures) names.emplace_back(measure.name);
    return names;
}

}  // namespace jprim
