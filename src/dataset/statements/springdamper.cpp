// SPDX-License-Identifier: Apache-2.0
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = SpringdamperStatement;

// A member that the two types call by different names.
std::vector<Field<S>> pair(const ArgumentRule& translational, const ArgumentRule& rotational,
                           double S::*member) {
    Field<S> first = field(translational, member), second = field(rotational, member);
    first.write = [translational, rotational, member](StatementWriter& writer, const S& s) {
        if (s.*member != 0) writer.addValue(s.rotational ? rotational.name : translational.name, s.*member);
    };
    second.write = {};
    return {first, second};
}

const FieldTable<S>& getFields() {
    static const SpellingTable<bool> types = {{false, "TRANSLATIONAL", 2}, {true, "ROTATIONAL", 2}};
    static const FieldTable<S> fields = {
        choice(types, &S::rotational, true),
        endMarkers<S>(),
        pair({"K", Kind::Real, ExactOnly}, {"KT", Kind::Real, ExactOnly}, &S::stiffness),
        pair({"C", Kind::Real, ExactOnly}, {"CT", Kind::Real, ExactOnly}, &S::damping),
        pair({"LENGTH", Kind::Real}, {"ANGLE", Kind::Angle}, &S::freeLength),
        pair({"FORCE", Kind::Real}, {"TORQUE", Kind::Real, 2}, &S::preload)};
    return fields;
}

void check(StatementReader& reader, S& spring) {
    for (const char* name : {"K", "C", "LENGTH", "FORCE"})
        reader.checkAllowed(name, !spring.rotational, "TRANSLATIONAL");
    for (const char* name : {"KT", "CT", "ANGLE", "TORQUE"})
        reader.checkAllowed(name, spring.rotational, "ROTATIONAL");
}

}  // namespace

StatementKind describeSpringdamper() {
    return makeKind("SPRINGDAMPER", 3, getFields(), &Dataset::springdampers, check);
}

}  // namespace jprim
