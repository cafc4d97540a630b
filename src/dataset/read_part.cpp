// SPDX-License-Identifier: Apache-2.0
// PART and MARKER: the bodies and the frames on them.
#include <fmt/format.h>

#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using P = PartStatement;
using M = MarkerStatement;
using V = ArgumentValue;

const std::vector<Word>& getCoordinates() {
    static const std::vector<Word> words = {{"X"}, {"Y"}, {"Z"}, {"PSI"}, {"THETA"}, {"PHI"}};
    return words;
}

const ArgumentTable<P>& getPartTable() {
    static const ArgumentTable<P> table = {
        {{"GROUND", Kind::Flag}, [](P& p, const V&) { p.ground = true; }},
        {ArgumentRule("QG", Kind::Real).of(3), [](P& p, const V& v) { p.qg = v.getTriple(); }},
        {ArgumentRule("REULER", Kind::Angle).of(3), [](P& p, const V& v) { p.reuler = v.getTriple(); }},
        {ArgumentRule("ZG", Kind::Real).of(3), [](P& p, const V& v) { p.zg = v.getTriple(); }},
        {ArgumentRule("XG", Kind::Real).of(3), [](P& p, const V& v) { p.xg = v.getTriple(); }},
        {{"MASS", Kind::Real}, [](P& p, const V& v) { p.mass = v.numbers[0]; }},
        {ArgumentRule("CM", Kind::Marker, ExactOnly).on(MarkerLink::SamePart),
         [](P& p, const V& v) { p.cm = v.id; }},
        {ArgumentRule("IM", Kind::Marker, ExactOnly).on(MarkerLink::SamePart),
         [](P& p, const V& v) { p.im = v.id; }},
        {ArgumentRule("IP", Kind::Real, ExactOnly).of(3, 6), [](P& p, const V& v) { p.ip = v.numbers; }},
        {{"VX", Kind::Real, ExactOnly}, [](P& p, const V& v) { p.v[0] = v.numbers[0]; }},
        {{"VY", Kind::Real, ExactOnly}, [](P& p, const V& v) { p.v[1] = v.numbers[0]; }},
        {{"VZ", Kind::Real, ExactOnly}, [](P& p, const V& v) { p.v[2] = v.numbers[0]; }},
        {{"WX", Kind::Angle, ExactOnly}, [](P& p, const V& v) { p.w[0] = v.numbers[0]; }},
        {{"WY", Kind::Angle, ExactOnly}, [](P& p, const V& v) { p.w[1] = v.numbers[0]; }},
        {{"WZ", Kind::Angle, ExactOnly}, [](P& p, const V& v) { p.w[2] = v.numbers[0]; }},
        {{"VM", Kind::Marker, ExactOnly}, [](P& p, const V& v) { p.vm = v.id; }},
        {{"WM", Kind::Marker, ExactOnly}, [](P& p, const V& v) { p.wm = v.id; }},
        {ArgumentRule("EXACT", Kind::Words).among(getCoordinates()),
         [](P& p, const V& v) {
             for (std::size_t i = 0; i < p.exact.size(); ++i) p.exact[i] = (v.words >> i) & 1u;
         }},
        {{"MATERIAL", Kind::Ignored, 3}, nullptr}};
    return table;
}

const ArgumentTable<M>& getMarkerTable() {
    static const ArgumentTable<M> table = {
        {{"PART", Kind::Part}, [](M& m, const V& v) { m.part = v.id; }},
        {ArgumentRule("QP", Kind::Real).of(3), [](M& m, const V& v) { m.qp = v.getTriple(); }},
        {ArgumentRule("REULER", Kind::Angle).of(3), [](M& m, const V& v) { m.reuler = v.getTriple(); }},
        {ArgumentRule("ZP", Kind::Real).of(3), [](M& m, const V& v) { m.zp = v.getTriple(); }},
        {ArgumentRule("XP", Kind::Real).of(3), [](M& m, const V& v) { m.xp = v.getTriple(); }},
        {{"USEXP", Kind::Flag, ExactOnly}, [](M& m, const V&) { m.usexp = true; }},
        {{"FLEX_BODY", Kind::Unsupported, 3}, nullptr},
        {{"FE_PART", Kind::Unsupported, 2}, nullptr},
        {{"POINT_MASS", Kind::Unsupported, 3}, nullptr},
        {{"CURVE", Kind::Unsupported}, nullptr},
        {{"FLOATING", Kind::Unsupported, 3}, nullptr},
        {{"NODE", Kind::Unsupported, 3}, nullptr},
        {{"NODE_ID", Kind::Unsupported, 6}, nullptr},
        {{"NODE_LABEL", Kind::Unsupported, 6}, nullptr},
        {{"RM", Kind::Unsupported, ExactOnly}, nullptr}};
    return table;
}

// Euler angles and points are two ways to say the same thing.
void checkOrientation(StatementReader& reader, const char* z, const char* x) {
    for (const char* point : {z, x})
        if (reader.has("REULER") && reader.has(point))
            reader.addError(reader.getOffset("REULER"),
                            fmt::format("{} takes REULER or {}, not both", reader.getName(), point));
}

void checkMass(StatementReader& reader, const PartStatement& part) {
    if (part.mass && *part.mass < 0)
        reader.addError(reader.getOffset("MASS"), fmt::format("MASS of {} is {}; a mass cannot be negative",
                                                              reader.getName(), *part.mass));
    if (part.mass && *part.mass > 0 && part.cm == 0)
        reader.addError(
            0, fmt::format("{} has a MASS but no mass centre; name its marker: CM=", reader.getName()));
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

}  // namespace

void readPart(StatementReader& reader) {
    ReadState& state = reader.updState();
    PartStatement part;
    part.where = reader.getPosition();
    part.id = reader.getId();
    if (part.id != 0) state.precedingPart = part.id;
    const bool good = reader.readArguments(getPartTable(), part);
    if (part.id != 0) reader.registerId();
    checkGround(reader);
    checkOrientation(reader, "ZG", "XG");
    if (good) checkMass(reader, part);
    if (reader.hasErrors())
        state.partFailed = true;
    else
        state.dataset.parts.push_back(part);
}

void readMarker(StatementReader& reader) {
    ReadState& state = reader.updState();
    MarkerStatement marker;
    marker.where = reader.getPosition();
    marker.id = reader.getId();
    const bool good = reader.readArguments(getMarkerTable(), marker);
    if (good && marker.part == 0) {
        marker.part = state.precedingPart;
        if (marker.part == 0)
            reader.addError(
                0, fmt::format("{} names no PART, and none precedes it; name one: PART=", reader.getName()));
    }
    if (marker.id != 0) reader.registerId(marker.part);
    checkOrientation(reader, "ZP", "XP");
    if (good && marker.usexp && !marker.xp)
        reader.addError(reader.getOffset("USEXP"),
                        fmt::format("USEXP of {} needs a point on the x axis: XP=", reader.getName()));
    if (!reader.hasErrors()) state.dataset.markers.push_back(marker);
}

}  // namespace jprim
