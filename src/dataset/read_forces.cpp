// SPDX-License-Identifier: Apache-2.0
// SFORCE, SPRINGDAMPER and BUSHING: forces between two markers.
#include <array>
#include <utility>

#include "dataset/connection_arguments.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using V = ArgumentValue;

template <class Statement>
void setTranslational(Statement& s, const V&) {
    s.rotational = false;
}
template <class Statement>
void setRotational(Statement& s, const V&) {
    s.rotational = true;
}

constexpr ArgumentRule type(std::string_view name, std::size_t minimum) {
    return ArgumentRule(name, Kind::Choice, minimum).required();
}

const ArgumentTable<SforceStatement>& getSforceTable() {
    using F = SforceStatement;
    static const ArgumentTable<F> table = {
        {type("TRANSLATIONAL", 2), setTranslational<F>},
        {type("ROTATIONAL", 3), setRotational<F>},
        {{"ACTIONONLY", Kind::Flag}, [](F& f, const V&) { f.actionOnly = true; }},
        {endMarker("I").required(), setI<F>},
        {endMarker("J").required(), setJ<F>},
        {functionRule(), setFunction<F>}};
    return table;
}

const ArgumentTable<SpringdamperStatement>& getSpringdamperTable() {
    using S = SpringdamperStatement;
    static const ArgumentTable<S> table = {
        {type("TRANSLATIONAL", 2), setTranslational<S>},
        {type("ROTATIONAL", 2), setRotational<S>},
        {endMarker("I").required(), setI<S>},
        {endMarker("J").required(), setJ<S>},
        {{"K", Kind::Real, ExactOnly}, [](S& s, const V& v) { s.stiffness = v.getNumber(); }},
        {{"C", Kind::Real, ExactOnly}, [](S& s, const V& v) { s.damping = v.getNumber(); }},
        {{"LENGTH", Kind::Real}, [](S& s, const V& v) { s.freeLength = v.getNumber(); }},
        {{"FORCE", Kind::Real}, [](S& s, const V& v) { s.preload = v.getNumber(); }},
        {{"KT", Kind::Real, ExactOnly}, [](S& s, const V& v) { s.stiffness = v.getNumber(); }},
        {{"CT", Kind::Real, ExactOnly}, [](S& s, const V& v) { s.damping = v.getNumber(); }},
        {{"ANGLE", Kind::Angle}, [](S& s, const V& v) { s.freeLength = v.getNumber(); }},
        {{"TORQUE", Kind::Real, 2}, [](S& s, const V& v) { s.preload = v.getNumber(); }}};
    return table;
}

constexpr ArgumentRule triple(std::string_view name, std::size_t minimum) {
    return ArgumentRule(name, Kind::Real, minimum).of(3);
}

const ArgumentTable<BushingStatement>& getBushingTable() {
    using B = BushingStatement;
    static const ArgumentTable<B> table = {
        {endMarker("I").required(), setI<B>},
        {endMarker("J").required(), setJ<B>},
        {triple("K", ExactOnly), [](B& b, const V& v) { b.k = v.getTriple(); }},
        {triple("C", ExactOnly), [](B& b, const V& v) { b.c = v.getTriple(); }},
        {triple("KT", ExactOnly), [](B& b, const V& v) { b.kt = v.getTriple(); }},
        {triple("CT", ExactOnly), [](B& b, const V& v) { b.ct = v.getTriple(); }},
        {triple("FORCE", 1), [](B& b, const V& v) { b.force = v.getTriple(); }},
        {triple("TORQUE", 1), [](B& b, const V& v) { b.torque = v.getTriple(); }}};
    return table;
}

}  // namespace

void readSforce(StatementReader& reader) {
    SforceStatement force;
    if (!reader.readStatement(getSforceTable(), force)) return;
    // Without a reaction J only says which way, and a force may turn with the body that it acts on.
    if (force.actionOnly) reader.allowAnyOwner();
    reader.updState().dataset.sforces.push_back(std::move(force));
}

void readSpringdamper(StatementReader& reader) {
    SpringdamperStatement spring;
    if (!reader.readStatement(getSpringdamperTable(), spring)) return;
    for (const char* name : {"K", "C", "LENGTH", "FORCE"})
        checkAllowed(reader, name, !spring.rotational, "TRANSLATIONAL");
    for (const char* name : {"KT", "CT", "ANGLE", "TORQUE"})
        checkAllowed(reader, name, spring.rotational, "ROTATIONAL");
    if (!reader.hasErrors()) reader.updState().dataset.springdampers.push_back(spring);
}

void readBushing(StatementReader& reader) {
    BushingStatement bushing;
    if (reader.readStatement(getBushingTable(), bushing))
        reader.updState().dataset.bushings.push_back(bushing);
}

}  // namespace jprim
