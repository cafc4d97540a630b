// SPDX-License-Identifier: Apache-2.0
// MARKER: a frame on a body.
#include "base/format.h"
#include "dataset/statements/body_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = MarkerStatement;

// NODE is the Fortran solver's word for NODE_ID.
Field<S> fortranNode() {
    return {ArgumentRule("NODE", Kind::Node, ExactOnly), field({"NODE_ID", Kind::Node}, &S::node).read};
}

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {field({"PART", Kind::Part}, &S::part),
                                         field({"POINT_MASS", Kind::PointMass, 3}, &S::pointMass),
                                         field({"FLEX_BODY", Kind::FlexBody, 3}, &S::flexBody),
                                         field({"NODE_ID", Kind::Node, 3}, &S::node),
                                         fortranNode(),
                                         field(ArgumentRule("QP", Kind::Real).of(3), &S::qp),
                                         field(ArgumentRule("REULER", Kind::Angle).of(3), &S::reuler),
                                         field(ArgumentRule("ZP", Kind::Real).of(3), &S::zp),
                                         field(ArgumentRule("XP", Kind::Real).of(3), &S::xp),
                                         field({"USEXP", Kind::Flag, ExactOnly}, &S::usexp),
                                         field({"FLOATING", Kind::Flag, 3}, &S::floating),
                                         ArgumentRule("FE_PART", Kind::Unsupported, 2),
                                         ArgumentRule("CURVE", Kind::Unsupported),
                                         ArgumentRule("NODE_LABEL", Kind::Unsupported, 6),
                                         ArgumentRule("RM", Kind::Unsupported, ExactOnly)};
    return fields;
}

// The body that the marker names, or else the one before it. Unknown if a mistake may have hidden a name.
Owner findOwner(StatementReader& reader, const S& marker) {
    const int named = (marker.part != 0) + (marker.pointMass != 0) + (marker.flexBody != 0);
    if (named > 1) return {};
    if (marker.part != 0) return {"PART", marker.part};
    if (marker.pointMass != 0) return {"POINT_MASS", marker.pointMass};
    if (marker.flexBody != 0) return {"FLEX_BODY", marker.flexBody};
    if (reader.hasErrors()) return {};
    const Owner& owner = reader.updState().precedingOwner;
    if (owner.keyword.empty())
        reader.addError(0, fmt::format("{} names no body, and none precedes it; name one: PART=, POINT_MASS= "
                                       "or FLEX_BODY=",
                                       reader.getName()));
    return owner;
}

int& updOwnerId(S& marker, std::string_view keyword) {
    if (keyword == "PART") return marker.part;
    return keyword == "POINT_MASS" ? marker.pointMass : marker.flexBody;
}

// The solver decides where a floating marker is.
void checkFloating(StatementReader& reader) {
    for (const char* name : {"QP", "REULER", "ZP", "XP", "USEXP", "NODE_ID", "NODE"})
        reader.checkNotBoth(name, "FLOATING");
}

void checkNode(StatementReader& reader, const Owner& owner) {
    reader.checkNotBoth("NODE", "NODE_ID");
    if (owner.keyword == "FLEX_BODY" || owner.id == 0) return;
    for (const char* name : {"NODE", "NODE_ID"})
        if (reader.has(name))
            reader.addWarning(reader.getOffset(name), fmt::format("{} of {} has no effect: {} is rigid", name,
                                                                  reader.getName(), owner.getName()));
}

void read(StatementReader& reader) {
    S marker;
    marker.where = reader.getPosition();
    marker.id = reader.getId();
    const bool isGood = reader.readArguments(getFields(), marker);
    const Owner owner = findOwner(reader, marker);
    reader.registerId(owner, marker.floating);
    reader.checkNotBoth("FLEX_BODY", "PART");
    reader.checkNotBoth("POINT_MASS", "PART");
    reader.checkNotBoth("POINT_MASS", "FLEX_BODY");
    checkFloating(reader);
    checkNode(reader, owner);
    checkOrientation(reader, "ZP", "XP");
    if (isGood && marker.usexp && !marker.xp)
        reader.addError(reader.getOffset("USEXP"),
                        fmt::format("USEXP of {} needs a point on the x axis: XP=", reader.getName()));
    if (reader.hasErrors()) return;
    updOwnerId(marker, owner.keyword) = owner.id;
    reader.updState().dataset.markers.push_back(marker);
}

}  // namespace

StatementKind describeMarker() {
    return readBy(read, makeKind("MARKER", 1, getFields(), &Dataset::markers));
}

}  // namespace jprim
