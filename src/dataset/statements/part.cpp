// SPDX-License-Identifier: Apache-2.0
// PART: a rigid body, or ground.
#include <algorithm>

#include "base/format.h"
#include "dataset/statements/body_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = PartStatement;

// Without products they are 0.
Field<S> inertiaField() {
    return {ArgumentRule("IP", Kind::Real, ExactOnly).of(3, 6),
            [](S& s, const ArgumentValue& given) {
                s.ip.emplace();
                std::copy(given.numbers.begin(), given.numbers.end(), s.ip->begin());
            },
            [](StatementWriter& writer, const S& s) {
                if (!s.ip) return;
                const std::array<double, 6>& ip = *s.ip;
                writer.add("IP", Triple{ip[0], ip[1], ip[2]});
                if (ip[3] != 0 || ip[4] != 0 || ip[5] != 0)
                    writer.add(fmt::format("{}, {}, {}", ip[3], ip[4], ip[5]));
            },
            [](const S& a, const S& b) { return a.ip == b.ip; }};
}

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {
        field({"GROUND", Kind::Flag}, &S::ground),
        poseFields(),
        field({"MASS", Kind::Real}, &S::mass),
        field(ArgumentRule("CM", Kind::Marker, ExactOnly).on(MarkerLink::SamePart), &S::cm),
        field(ArgumentRule("IM", Kind::Marker, ExactOnly).on(MarkerLink::SamePart), &S::im),
        inertiaField(),
        velocityFields(),
        rotationFields(),
        exactField(true),
        ArgumentRule("MATERIAL", Kind::Ignored, 3)};
    return fields;
}

void checkGround(StatementReader& reader) {
    SourcePosition& ground = reader.updState().ground;
    if (!reader.has("GROUND")) return;
    if (ground.line != 0)
        reader.addError(
            reader.getOffset("GROUND"),
            fmt::format("{} is a second GROUND; the first stands in line {}", reader.getName(), ground.line));
    else
        ground = reader.getPosition();
}

void read(StatementReader& reader) {
    ReadState& state = reader.updState();
    S part;
    state.precedingOwner = {"PART", reader.getId()};
    const bool isGood = reader.readStatement(getFields(), part);
    checkGround(reader);
    checkOrientation(reader, "ZG", "XG");
    if (isGood) checkMass(reader, part.mass, part.cm);
    if (reader.hasErrors())
        state.partFailed = true;
    else
        state.dataset.parts.push_back(part);
}

}  // namespace

StatementKind describePart() {
    return readBy(read, makeKind("PART", 1, getFields(), &Dataset::parts));
}

}  // namespace jprim
