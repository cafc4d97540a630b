// SPDX-License-Identifier: Apache-2.0
// POINT_MASS: a body that does not turn.
#include "dataset/statements/body_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = PointMassStatement;

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {
        poseFields(), field({"MASS", Kind::Real}, &S::mass),
        field(ArgumentRule("CM", Kind::Marker, ExactOnly).on(MarkerLink::SamePart), &S::cm), velocityFields(),
        exactField(false)};
    return fields;
}

void read(StatementReader& reader) {
    ReadState& state = reader.updState();
    S mass;
    state.precedingOwner = {"POINT_MASS", reader.getId()};
    const bool isGood = reader.readStatement(getFields(), mass);
    checkOrientation(reader, "ZG", "XG");
    if (isGood) checkMass(reader, mass.mass, mass.cm);
    if (!reader.hasErrors()) state.dataset.pointMasses.push_back(mass);
}

}  // namespace

StatementKind describePointMass() {
    return readBy(read, makeKind("POINT_MASS", 3, getFields(), &Dataset::pointMasses));
}

}  // namespace jprim
