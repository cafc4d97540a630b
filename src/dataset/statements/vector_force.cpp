// SPDX-License-Identifier: Apache-2.0
// VFORCE, VTORQUE and GFORCE: forces given by components. They stand in one list of the dataset.
#include "base/format.h"
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = VectorForceStatement;
using Type = VectorForceType;

const SpellingTable<Type>& getTypes() {
    static const SpellingTable<Type> types = {
        {Type::Vforce, "VFORCE", 2}, {Type::Vtorque, "VTORQUE", 2}, {Type::Gforce, "GFORCE", 2}};
    return types;
}

constexpr ArgumentRule expression(std::string_view name) {
    return ArgumentRule(name, Kind::Expression, ExactOnly);
}

std::vector<Field<S>> forceFields() {
    return {field(expression("FX"), element(&S::components, 0)),
            field(expression("FY"), element(&S::components, 1)),
            field(expression("FZ"), element(&S::components, 2)), field(expression("FXYZ"), &S::fxyz)};
}

std::vector<Field<S>> torqueFields() {
    return {field(expression("TX"), element(&S::components, 3)),
            field(expression("TY"), element(&S::components, 4)),
            field(expression("TZ"), element(&S::components, 5)), field(expression("TXYZ"), &S::txyz)};
}

FieldTable<S> makeFields(Type type) {
    const std::vector<Field<S>> none;
    return {
        field(endMarker("I").required(), &S::i),
        field(ArgumentRule("JFLOAT", Kind::Marker).on(MarkerLink::OtherPartFloating).required(), &S::jfloat),
        field({"RM", Kind::MarkerOrZero, ExactOnly}, &S::rm),
        subroutineRule(),
        type == Type::Vtorque ? none : forceFields(),
        type == Type::Vforce ? none : torqueFields()};
}

const FieldTable<S>& getFields(Type type) {
    static const FieldTable<S> ofVforce = makeFields(Type::Vforce), ofVtorque = makeFields(Type::Vtorque),
                               ofGforce = makeFields(Type::Gforce);
    return type == Type::Vforce ? ofVforce : type == Type::Vtorque ? ofVtorque : ofGforce;
}

void checkComponents(StatementReader& reader, Type type) {
    for (const char* name : {"FX", "FY", "FZ"}) reader.checkNotBoth(name, "FXYZ");
    for (const char* name : {"TX", "TY", "TZ"}) reader.checkNotBoth(name, "TXYZ");
    if (reader.has(Kind::Expression)) return;
    const char* const forces = type == Type::Vtorque ? "" : "FX, FY, FZ or FXYZ";
    const char* const torques = type == Type::Vforce ? "" : "TX, TY, TZ or TXYZ";
    reader.addError(0, fmt::format("{} needs a component: {}{}{}", reader.getName(), forces,
                                   type == Type::Gforce ? ", " : "", torques));
}

template <Type type>
void read(StatementReader& reader) {
    S force;
    force.type = type;
    if (reader.readStatement(getFields(type), force)) checkComponents(reader, type);
    if (!reader.hasErrors()) reader.updState().dataset.vectorForces.push_back(std::move(force));
}

StatementKind makeKind(Type type, void (*read)(StatementReader&)) {
    return {getTypes().getName(type), 2, true, false, read, {}, {}};
}

// Of all three types.
void writeAll(StatementWriter& writer, const Dataset& dataset) {
    for (const S& s : dataset.vectorForces)
        writeStatement(writer, getTypes().getName(s.type), s.id, getFields(s.type), s);
}

bool areEqual(const Dataset& a, const Dataset& b) {
    return std::equal(a.vectorForces.begin(), a.vectorForces.end(), b.vectorForces.begin(),
                      b.vectorForces.end(), [](const S& x, const S& y) {
                          return x.type == y.type && x.id == y.id && getFields(Type::Gforce).equal(x, y);
                      });
}

}  // namespace

StatementKind describeVforce() {
    StatementKind kind = makeKind(Type::Vforce, read<Type::Vforce>);
    kind.write = writeAll;
    kind.equal = areEqual;
    return kind;
}

StatementKind describeVtorque() {
    return makeKind(Type::Vtorque, read<Type::Vtorque>);
}

StatementKind describeGforce() {
    return makeKind(Type::Gforce, read<Type::Gforce>);
}

const char* getAdamsName(VectorForceType type) {
    return getTypes().getName(type).data();
}

}  // namespace jprim
