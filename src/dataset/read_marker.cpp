// SPDX-License-Identifier: Apache-2.0
// MARKER: a frame on a body.
#include "base/format.h"
#include "dataset/body_arguments.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using M = MarkerStatement;
using V = ArgumentValue;

const ArgumentTable<M>& getMarkerTable() {
    static const ArgumentTable<M> table = {
        {{"PART", Kind::Part}, [](M& m, const V& v) { m.part = v.getId(); }},
        {{"POINT_MASS", Kind::PointMass, 3}, [](M& m, const V& v) { m.pointMass = v.getId(); }},
        {{"FLEX_BODY", Kind::FlexBody, 3}, [](M& m, const V& v) { m.flexBody = v.getId(); }},
        {{"NODE_ID", Kind::Node, 3}, [](M& m, const V& v) { m.node = v.getId(); }},
        {{"NODE", Kind::Node, ExactOnly}, [](M& m, const V& v) { m.node = v.getId(); }},
        {ArgumentRule("QP", Kind::Real).of(3), [](M& m, const V& v) { m.qp = v.getTriple(); }},
        {ArgumentRule("REULER", Kind::Angle).of(3), [](M& m, const V& v) { m.reuler = v.getTriple(); }},
        {ArgumentRule("ZP", Kind::Real).of(3), [](M& m, const V& v) { m.zp = v.getTriple(); }},
        {ArgumentRule("XP", Kind::Real).of(3), [](M& m, const V& v) { m.xp = v.getTriple(); }},
        {{"USEXP", Kind::Flag, ExactOnly}, [](M& m, const V&) { m.usexp = true; }},
        {{"FLOATING", Kind::Flag, 3}, [](M& m, const V&) { m.floating = true; }},
        {{"FE_PART", Kind::Unsupported, 2}, nullptr},
        {{"CURVE", Kind::Unsupported}, nullptr},
        {{"NODE_LABEL", Kind::Unsupported, 6}, nullptr},
        {{"RM", Kind::Unsupported, ExactOnly}, nullptr}};
    return table;
}

// The body that the marker names, or else the one before it. Unknown if a mistake may have hidden a name.
Owner findOwner(StatementReader& reader, const MarkerStatement& marker) {
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

int& updOwnerId(MarkerStatement& marker, std::string_view keyword) {
    if (keyword == "PART") return marker.part;
    return keyword == "POINT_MASS" ? marker.pointMass : marker.flexBody;
}

// The solver decides where a floating marker is.
void checkFloating(StatementReader& reader) {
    if (!reader.has("FLOATING")) return;
    for (const char* name : {"QP", "REULER", "ZP", "XP", "USEXP", "NODE_ID", "NODE"})
        checkNotBoth(reader, name, "FLOATING");
}

void checkNode(StatementReader& reader, const Owner& owner) {
    checkNotBoth(reader, "NODE", "NODE_ID");
    if (owner.keyword == "FLEX_BODY" || owner.id == 0) return;
    for (const char* name : {"NODE", "NODE_ID"})
        if (reader.has(name))
            reader.addWarning(reader.getOffset(name), fmt::format("{} of {} has no effect: {} is rigid", name,
                                                                  reader.getName(), owner.getName()));
}

}  // namespace

void readMarker(StatementReader& reader) {
    MarkerStatement marker;
    marker.where = reader.getPosition();
    marker.id = reader.getId();
    const bool good = reader.readArguments(getMarkerTable(), marker);
    const Owner owner = findOwner(reader, marker);
    reader.registerId(owner, marker.floating);
    checkNotBoth(reader, "FLEX_BODY", "PART");
    checkNotBoth(reader, "POINT_MASS", "PART");
    checkNotBoth(reader, "POINT_MASS", "FLEX_BODY");
    checkFloating(reader);
    checkNode(reader, owner);
    checkOrientation(reader, "ZP", "XP");
    if (good && marker.usexp && !marker.xp)
        reader.addError(reader.getOffset("USEXP"),
                        fmt::format("USEXP of {} needs a point on the x axis: XP=", reader.getName()));
    if (reader.hasErrors()) return;
    updOwnerId(marker, owner.keyword) = owner.id;
    reader.updState().dataset.markers.push_back(marker);
}

}  // namespace jprim
