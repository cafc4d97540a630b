// SPDX-License-Identifier: Apache-2.0
// VFORCE, VTORQUE and GFORCE: forces given by components.
#include <utility>

#include "base/format.h"
#include "dataset/body_arguments.h"
#include "dataset/connection_arguments.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using F = VectorForceStatement;
using V = ArgumentValue;

template <std::size_t K>
void setComponent(F& f, const V& v) {
    f.components[K] = v.expression;
}

constexpr ArgumentRule expression(std::string_view name) {
    return ArgumentRule(name, Kind::Expression, ExactOnly);
}

void addForce(ArgumentTable<F>& table) {
    table.add({{expression("FX"), setComponent<0>},
               {expression("FY"), setComponent<1>},
               {expression("FZ"), setComponent<2>},
               {expression("FXYZ"), [](F& f, const V& v) { f.fxyz = v.expression; }}});
}

void addTorque(ArgumentTable<F>& table) {
    table.add({{expression("TX"), setComponent<3>},
               {expression("TY"), setComponent<4>},
               {expression("TZ"), setComponent<5>},
               {expression("TXYZ"), [](F& f, const V& v) { f.txyz = v.expression; }}});
}

ArgumentTable<F> makeTable(VectorForceType type) {
    ArgumentTable<F> table = {
        {endMarker("I").required(), setI<F>},
        {ArgumentRule("JFLOAT", Kind::Marker).on(MarkerLink::OtherPartFloating).required(),
         [](F& f, const V& v) { f.jfloat = v.getId(); }},
        {{"RM", Kind::MarkerOrZero, ExactOnly}, [](F& f, const V& v) { f.rm = v.getId(); }},
        {{"FUNCTION", Kind::Subroutine, 2}, nullptr}};
    if (type != VectorForceType::Vtorque) addForce(table);
    if (type != VectorForceType::Vforce) addTorque(table);
    return table;
}

void checkComponents(StatementReader& reader, const F& force) {
    for (const char* name : {"FX", "FY", "FZ"}) checkNotBoth(reader, name, "FXYZ");
    for (const char* name : {"TX", "TY", "TZ"}) checkNotBoth(reader, name, "TXYZ");
    if (reader.has(Kind::Expression)) return;
    constexpr const char* names[] = {"FX, FY, FZ or FXYZ", "TX, TY, TZ or TXYZ",
                                     "FX, FY, FZ or FXYZ, TX, TY, TZ or TXYZ"};
    reader.addError(0, fmt::format("{} needs a component: {}", reader.getName(),
                                   names[static_cast<std::size_t>(force.type)]));
}

}  // namespace

void readVectorForce(StatementReader& reader) {
    static const ArgumentTable<F> tables[] = {makeTable(VectorForceType::Vforce),
                                              makeTable(VectorForceType::Vtorque),
                                              makeTable(VectorForceType::Gforce)};
    F force;
    while (getAdamsName(force.type) != reader.getKeyword())
        force.type = static_cast<VectorForceType>(static_cast<int>(force.type) + 1);
    if (reader.readStatement(tables[static_cast<std::size_t>(force.type)], force))
        checkComponents(reader, force);
    if (!reader.hasErrors()) reader.updState().dataset.vectorForces.push_back(std::move(force));
}

}  // namespace jprim
