// SPDX-License-Identifier: Apache-2.0
// PART: a rigid body, or ground. POINT_MASS: a body that does not turn.
#include <algorithm>

#include "base/format.h"
#include "dataset/body_arguments.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using P = PartStatement;
using V = ArgumentValue;

void setInertia(P& p, const V& v) {
    p.ip.emplace();
    std::copy(v.numbers.begin(), v.numbers.end(), p.ip->begin());  // without products they are 0
}

const ArgumentTable<P>& getPartTable() {
    static const ArgumentTable<P> table =
        makeBodyTable<P>({{{"GROUND", Kind::Flag}, [](P& p, const V&) { p.ground = true; }},
                          {{"MASS", Kind::Real}, [](P& p, const V& v) { p.mass = v.getNumber(); }},
                          {ArgumentRule("CM", Kind::Marker, ExactOnly).on(MarkerLink::SamePart),
                           [](P& p, const V& v) { p.cm = v.getId(); }},
                          {ArgumentRule("IM", Kind::Marker, ExactOnly).on(MarkerLink::SamePart),
                           [](P& p, const V& v) { p.im = v.getId(); }},
                          {ArgumentRule("IP", Kind::Real, ExactOnly).of(3, 6), setInertia},
                          {{"MATERIAL", Kind::Ignored, 3}, nullptr}});
    return table;
}

const ArgumentTable<PointMassStatement>& getPointMassTable() {
    using M = PointMassStatement;
    static const std::vector<Word> coordinates = {{"X"}, {"Y"}, {"Z"}};
    static const ArgumentTable<M> table = makePointTable<M>(
        coordinates, {{{"MASS", Kind::Real}, [](M& m, const V& v) { m.mass = v.getNumber(); }},
                      {ArgumentRule("CM", Kind::Marker, ExactOnly).on(MarkerLink::SamePart),
                       [](M& m, const V& v) { m.cm = v.getId(); }}});
    return table;
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
    state.precedingOwner = {"PART", reader.getId()};
    const bool good = reader.readStatement(getPartTable(), part);
    checkGround(reader);
    checkOrientation(reader, "ZG", "XG");
    if (good) checkMass(reader, part.mass, part.cm);
    if (reader.hasErrors())
        state.partFailed = true;
    else
        state.dataset.parts.push_back(part);
}

void readPointMass(StatementReader& reader) {
    ReadState& state = reader.updState();
    PointMassStatement mass;
    state.precedingOwner = {"POINT_MASS", reader.getId()};
    const bool good = reader.readStatement(getPointMassTable(), mass);
    checkOrientation(reader, "ZG", "XG");
    if (good) checkMass(reader, mass.mass, mass.cm);
    if (!reader.hasErrors()) state.dataset.pointMasses.push_back(mass);
}

}  // namespace jprim
