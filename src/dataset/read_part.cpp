// SPDX-License-Identifier: Apache-2.0
// PART: a rigid body, or ground.
#include <fmt/format.h>

#include "dataset/body_arguments.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using P = PartStatement;
using V = ArgumentValue;

const ArgumentTable<P>& getPartTable() {
    static const ArgumentTable<P> table = makeBodyTable<P>(
        {{{"GROUND", Kind::Flag}, [](P& p, const V&) { p.ground = true; }},
         {{"MASS", Kind::Real}, [](P& p, const V& v) { p.mass = v.numbers[0]; }},
         {ArgumentRule("CM", Kind::Marker, ExactOnly).on(MarkerLink::SamePart),
          [](P& p, const V& v) { p.cm = v.id; }},
         {ArgumentRule("IM", Kind::Marker, ExactOnly).on(MarkerLink::SamePart),
          [](P& p, const V& v) { p.im = v.id; }},
         {ArgumentRule("IP", Kind::Real, ExactOnly).of(3, 6), [](P& p, const V& v) { p.ip = v.numbers; }},
         {{"MATERIAL", Kind::Ignored, 3}, nullptr}});
    return table;
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
    state.precedingOwner = {"PART", part.id};
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

}  // namespace jprim
