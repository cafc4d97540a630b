// SPDX-License-Identifier: Apache-2.0
#include "mechanism/mechanism_vocabulary.h"

#include <algorithm>
#include <iterator>

#include "base/format.h"
#include "expression/compile_expression.h"
#include "force/marker_force_impl.h"
#include "general/check_expression.h"
#include "jprim/marker/load.h"

namespace jprim {

using SimTK::Real;
using SimTK::SpatialVec;
using SimTK::State;
using SimTK::Vec3;

namespace {

/// A function's name and the kind of element whose load it gives.
const std::pair<const char*, ElementKind> ElementFunctions[] = {
    {"JPRIM", ElementKind::Jprim},   {"JOINT", ElementKind::Joint},   {"GCON", ElementKind::Gcon},
    {"MOTION", ElementKind::Motion}, {"SFORCE", ElementKind::Sforce}, {"SPDP", ElementKind::Springdamper},
    {"BUSH", ElementKind::Bushing},  {"GFORCE", ElementKind::Gforce}, {"VFORCE", ElementKind::Vforce},
    {"VTORQ", ElementKind::Vtorque}};

// In the order of the component numbers 1 … 8.
const char* const NetLoads[] = {"FM", "FX", "FY", "FZ", "TM", "TX", "TY", "TZ"};

// A load [moment, force] in the axes of a marker, or Ground's if the marker is on no body.
SpatialVec resolve(const State& state, const SpatialVec& load, const Marker& axes) {
    return axes.isOnBody() ? expressLoadIn(state, load, axes) : load;
}

Real getUnit(const UnitSystem& units, int component) {
    return component <= 4 ? units.force : units.getMoment();
}

}  // namespace

void FunctionContext::addUnknownLoad(const ElementId& id) {
    Element element;
    element.id = id;
    element.onI = element.onJ = [](const State&) { return SpatialVec(Vec3(0), Vec3(0)); };
    elements.add(std::move(element));
}

std::optional<Operand> MechanismVocabulary::call(ProgramBuilder& builder, const Call& call) {
    if (call.name == "VARVAL") return MarkerVocabulary::call(builder, call);
    if (const std::optional<Operand> value = callControl(builder, call)) return value;
    const std::optional<Operand> value = makeMeasure(builder, call);
    if (value && m_use == FunctionUse::OfTime) throw ExpressionError(call.offset, NotOnlyTime);
    return value;
}

std::string MechanismVocabulary::findProblem(const ProgramBuilder& builder, Operand value) const {
    switch (m_use) {
        case FunctionUse::Equation:
            return findValueProblem(builder.getLevel(value), builder.isLinearInVelocity(value));
        case FunctionUse::Force: return findForceProblem(builder.getLevel(value));
        default: return "";
    }
}

std::optional<Operand> MechanismVocabulary::makeMeasure(ProgramBuilder& builder, const Call& call) {
    if (call.name == "ORIENT") return makeEulerParameter(call);
    for (const auto& [function, kind] : ElementFunctions)
        if (call.name == function) return makeElementLoad(call, kind);
    const auto net = std::find(std::begin(NetLoads), std::end(NetLoads), call.name);
    if (net != std::end(NetLoads)) return makeNetLoad(call, int(net - std::begin(NetLoads)) + 1);
    return MarkerVocabulary::call(builder, call);
}

const InterpolatingSpline* MechanismVocabulary::findSpline(int id) {
    const auto found = m_context.splines.find(id);
    return found == m_context.splines.end() ? nullptr : &found->second;
}

std::vector<std::string> MechanismVocabulary::getNames() const {
    std::vector<std::string> names = MarkerVocabulary::getNames();
    names.emplace_back("ORIENT");
    for (const auto& [function, kind] : ElementFunctions) names.emplace_back(function);
    names.insert(names.end(), std::begin(NetLoads), std::end(NetLoads));
    for (const std::string& name : getControlNames()) names.push_back(name);
    return names;
}

std::string MechanismVocabulary::describeMissing(int id) const {
    if (m_context.floatingMarkers.count(id) == 0) return MarkerVocabulary::describeMissing(id);
    return fmt::format("MARKER/{} is FLOATING and cannot be measured; name a fixed marker", id);
}

// A variable's own mistakes are reported at its statement, so its text is known to be good.
const std::string* MechanismVocabulary::findVariable(int id) const {
    const auto found = m_context.variables.find(id);
    return found == m_context.variables.end() ? nullptr : &found->second->function.text;
}

Operand MechanismVocabulary::makeElementLoad(const Call& call, ElementKind kind) {
    const std::vector<int> ids = getIds(call, 3, 4);
    const ElementId id{kind, ids[0]};
    const int jflag = ids[1], component = ids[2];
    const Element* element = m_context.elements.find(id);
    if (!element)
        throw ExpressionError(
            call.arguments[0].offset,
            fmt::format("{} does not exist, or its load is not known here: only REQUEST and SENSOR "
                        "can depend on loads of elements",
                        id.getText()));
    if (jflag > 1)
        throw ExpressionError(call.arguments[1].offset,
                              "the second argument must be 0 for the load on I or 1 for the "
                              "load on J");
    if (jflag == 1 && !element->onJ)
        throw ExpressionError(call.arguments[1].offset,
                              fmt::format("{} has no reaction on a J marker", id.getText()));
    if (component < 1 || component > 8)
        throw ExpressionError(call.arguments[2].offset,
                              "the third argument must be 1 to 8 for FM FX FY FZ TM TX TY TZ");
    if (call.arguments.size() > 3) checkMarker(call, 3, ids[3]);
    const Real unit = getUnit(m_context.units, component);
    return updFrames().addScalar(
        KinematicLevel::Acceleration,
        [load = jflag == 0 ? element->onI : element->onJ, axes = getMarker(ids[3]), component,
         unit](const State& s) { return getLoadComponent(resolve(s, load(s), axes), component) / unit; });
}

Operand MechanismVocabulary::makeNetLoad(const Call& call, int component) {
    const std::vector<int> ids = getIds(call, 1, 3);
    for (size_t k = 0; k < call.arguments.size(); ++k)
        if (k > 1 || m_context.floatingMarkers.count(ids[k]) == 0) checkMarker(call, k, ids[k]);
    const std::vector<LoadFunction> loads = m_context.elements.findLoads(ids[0], ids[1]);
    const Real unit = getUnit(m_context.units, component);
    return updFrames().addScalar(KinematicLevel::Acceleration,
                                 [loads, axes = getMarker(ids[2]), component, unit](const State& s) {
                                     SpatialVec sum(Vec3(0), Vec3(0));
                                     for (const LoadFunction& load : loads) sum += load(s);
                                     return getLoadComponent(resolve(s, sum, axes), component) / unit;
                                 });
}

// A value for output: its sign is chosen at each State anew, so it has no derivative.
Operand MechanismVocabulary::makeEulerParameter(const Call& call) {
    constexpr int EulerParameters = 27;
    const std::vector<int> ids = getIds(call, 3, 4);
    if (ids[0] != EulerParameters || ids[1] < 1 || ids[1] > 4)
        throw ExpressionError(call.offset,
                              "only ORIENT(27,k,i,j) is supported, the Euler parameters k = 1 … 4");
    for (size_t k = 2; k < call.arguments.size(); ++k) checkMarker(call, k, ids[k]);
    return updFrames().addScalar(KinematicLevel::Acceleration, [k = ids[1] - 1, I = getMarker(ids[2]),
                                                                J = getMarker(ids[3])](const State& s) {
        const SimTK::Rotation R_GI = I.isOnBody() ? I.findPoseInGround(s).R() : SimTK::Rotation();
        const SimTK::Rotation R_GJ = J.isOnBody() ? J.findPoseInGround(s).R() : SimTK::Rotation();
        return (~R_GJ * R_GI).convertRotationToQuaternion()[k];
    });
}

}  // namespace jprim
