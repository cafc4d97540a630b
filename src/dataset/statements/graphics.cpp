// SPDX-License-Identifier: Apache-2.0
// GRAPHICS: what is drawn.
#include "base/format.h"
#include "dataset/statements/ignored.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = GraphicsStatement;
using Shape = GraphicsShape;

const SpellingTable<Shape>& getShapes() {
    static const SpellingTable<Shape> shapes = {{Shape::Arc, "ARC"},
                                                {Shape::Box, "BOX", ExactOnly},
                                                {Shape::Circle, "CIRCLE", 2},
                                                {Shape::Curve, "CURVE", 2},
                                                {Shape::Cylinder, "CYLINDER", 2},
                                                {Shape::Ellipsoid, "ELLIPSOID", 3},
                                                {Shape::External, "EXTERNAL", 2},
                                                {Shape::Force, "FORCE", 2},
                                                {Shape::Frustum, "FRUSTUM", 2},
                                                {Shape::Plane, "PLANE", 2},
                                                {Shape::Point, "POINT", 2},
                                                {Shape::SpringDamper, "SPDP", 2}};
    return shapes;
}

// OUTLINE is the word and its markers in one.
std::vector<Field<S>> shapeFields() {
    std::vector<Field<S>> fields = choice(getShapes(), &S::shape);
    fields.front().write = [](StatementWriter& writer, const S& s) {
        writer.add(getShapes().getName(s.shape));
    };
    return fields;
}

ArgumentRule marker(std::string_view name, std::size_t minimum = ExactOnly) {
    return {name, Kind::Marker, minimum};
}

ArgumentRule real(std::string_view name, std::size_t minimum = ExactOnly) {
    return {name, Kind::Real, minimum};
}

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {shapeFields(),
                                         field(marker("OUTLINE", 1).of(2, NoLimit), &S::outline),
                                         field(marker("CM"), &S::cm),
                                         field(marker("CORNER", 3), &S::corner),
                                         field(marker("I"), &S::i),
                                         field(marker("J"), &S::j),
                                         field(marker("RM"), &S::rm),
                                         field(real("X"), element(&S::size, 0)),
                                         field(real("Y"), element(&S::size, 1)),
                                         field(real("Z"), element(&S::size, 2)),
                                         field(real("XSCALE", 2), element(&S::scale, 0)),
                                         field(real("YSCALE", 2), element(&S::scale, 1)),
                                         field(real("ZSCALE", 2), element(&S::scale, 2)),
                                         field(real("LENGTH", 2), &S::length),
                                         field(real("RADIUS", 3), &S::radius),
                                         field(real("BOTTOM", 2), &S::bottom),
                                         field(real("TOP", 2), &S::top),
                                         field({"RANGLE", Kind::Angle, 3}, &S::rangle),
                                         field(real("SIDES", 2), &S::sides),
                                         field(real("SEG", 2), &S::seg),
                                         field(real("COILS", 3), &S::coils),
                                         field(real("DA"), &S::da),
                                         field(real("DB"), &S::db),
                                         field(real("DC"), &S::dc),
                                         field(real("LA"), &S::la),
                                         field(real("LB"), &S::lb),
                                         field(real("LC"), &S::lc),
                                         field(real("LD"), &S::ld),
                                         field(real("XMIN", 3), element(&S::limits, 0)),
                                         field(real("XMAX", 3), element(&S::limits, 1)),
                                         field(real("YMIN", 3), element(&S::limits, 2)),
                                         field(real("YMAX", 3), element(&S::limits, 3)),
                                         field({"CID", Kind::Id, ExactOnly}, &S::curve),
                                         field(marker("CRM"), &S::crm),
                                         field({"FILE", Kind::Text, 2}, &S::file),
                                         field({"ELEMENT", Kind::Text, 3}, &S::element),
                                         field({"ETYPE", Kind::Text, 2}, &S::forceKind),
                                         field({"EID", Kind::Id, ExactOnly}, &S::force),
                                         field(marker("EMARKER", 2), &S::forceMarker)};
    return fields;
}

// What a shape takes, beside the word that names it.
struct ShapeArguments {
    std::vector<const char*> needed;
    std::vector<const char*> others;
};

const ShapeArguments& getArguments(Shape shape) {
    static const ShapeArguments arc{{"CM", "RANGLE"}, {"RADIUS", "RM", "SEG"}},
        box{{"CORNER", "X", "Y", "Z"}, {}}, circle{{"CM"}, {"RADIUS", "RM", "SEG"}},
        curve{{"CID", "CRM"}, {"SEG"}},
        cylinder{{"CM", "LENGTH"}, {"RADIUS", "RM", "RANGLE", "SIDES", "SEG"}},
        ellipsoid{{"CM", "XSCALE", "YSCALE", "ZSCALE"}, {}}, external{{"RM", "FILE"}, {"ELEMENT"}},
        force{{"ETYPE", "EID", "EMARKER"}, {}},
        frustum{{"CM", "LENGTH", "TOP", "BOTTOM"}, {"RANGLE", "SIDES", "SEG"}}, outline{{"OUTLINE"}, {}},
        plane{{"RM", "XMIN", "XMAX", "YMIN", "YMAX"}, {}}, point{{"RM"}, {}},
        spring{{"I", "J"}, {"COILS", "DA", "DB", "DC", "LA", "LB", "LC", "LD"}};
    switch (shape) {
        case Shape::Arc: return arc;
        case Shape::Box: return box;
        case Shape::Circle: return circle;
        case Shape::Curve: return curve;
        case Shape::Cylinder: return cylinder;
        case Shape::Ellipsoid: return ellipsoid;
        case Shape::External: return external;
        case Shape::Force: return force;
        case Shape::Frustum: return frustum;
        case Shape::Outline: return outline;
        case Shape::Plane: return plane;
        case Shape::Point: return point;
        case Shape::SpringDamper: break;
    }
    return spring;
}

bool takes(const ShapeArguments& arguments, std::string_view name) {
    const auto has = [&](const std::vector<const char*>& names) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    return has(arguments.needed) || has(arguments.others);
}

void checkRadius(StatementReader& reader, const ShapeArguments& arguments) {
    if (!takes(arguments, "RADIUS")) return;
    reader.checkNotBoth("RADIUS", "RM");
    if (!reader.has("RADIUS") && !reader.has("RM"))
        reader.addError(0,
                        fmt::format("{} needs its radius: RADIUS=, or RM=, a marker that far from the axis",
                                    reader.getName()));
}

void check(StatementReader& reader, S& graphics) {
    const bool hasWord = reader.has(Kind::Choice);
    if (reader.has("OUTLINE") && !hasWord) graphics.shape = Shape::Outline;
    if (!hasWord && !reader.has("OUTLINE")) {
        reader.addError(0,
                        fmt::format("{} needs what to draw: CYLINDER, BOX, ELLIPSOID, FRUSTUM, CIRCLE, ARC, "
                                    "OUTLINE= or SPDP",
                                    reader.getName()));
        return;
    }
    const ShapeArguments& arguments = getArguments(graphics.shape);
    for (const ArgumentRule& rule : getFields().getRules())
        if (!isBare(rule.kind) && reader.has(rule.name) && !takes(arguments, rule.name))
            reader.addError(reader.getOffset(rule.name),
                            fmt::format("{} of {}: {} does not take it", rule.name, reader.getName(),
                                        getAdamsName(graphics.shape)));
    for (const char* name : arguments.needed) reader.checkNeeded(name, true);
    checkRadius(reader, arguments);
}

// Adams' manual names no arguments of a TORUS but CM.
void read(StatementReader& reader) {
    constexpr Word torus[] = {{"TORUS", 3}};
    if (findWord(std::vector<Word>(std::begin(torus), std::end(torus)), reader.peekWord()).found)
        readIgnored(reader);
    else
        readStatement(reader, getFields(), &Dataset::graphics, check);
}

}  // namespace

StatementKind describeGraphics() {
    return readBy(read, makeKind("GRAPHICS", 2, getFields(), &Dataset::graphics));
}

const char* getAdamsName(GraphicsShape shape) {
    return shape == Shape::Outline ? "OUTLINE" : getShapes().getName(shape).data();
}

}  // namespace jprim
