// SPDX-License-Identifier: Apache-2.0
// JPRIM and JOINT: a type and two markers.
#include "base/format.h"
#include "dataset/connection_arguments.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using V = ArgumentValue;

// A type's row is its value in the enumeration, so the types come first, in that order.
template <class Statement>
void setType(Statement& s, const V& v) {
    s.type = static_cast<decltype(s.type)>(v.row);
}
constexpr ArgumentRule type(std::string_view name, std::size_t minimum = 1) {
    return ArgumentRule(name, Kind::Choice, minimum).required();
}
const ArgumentTable<JprimStatement>& getJprimTable() {
    using J = JprimStatement;
    static const ArgumentTable<J> table = {
        {type("ATPOINT"), setType<J>},          {type("INLINE", 3), setType<J>},
        {type("INPLANE", 3), setType<J>},       {type("ORIENTATION"), setType<J>},
        {type("PARALLEL_AXES", 2), setType<J>}, {type("PERPENDICULAR", 2), setType<J>},
        {endMarker("I").required(), setI<J>},   {endMarker("J").required(), setJ<J>}};
    return table;
}

// The statement, and whether IC was given in degrees, which only an angle can be.
struct JointArguments : JointStatement {
    bool degrees = false;
};

JointInitialValue makeInitialValue(const V& v) {
    JointInitialValue value;
    value.displacement = v.getNumber();
    if (v.numbers.size() > 1) value.velocity = v.numbers[1];
    return value;
}

void setIc(JointArguments& j, const V& v) {
    j.ic = makeInitialValue(v);
    j.degrees = v.degrees;
}

// Friction of old files: zeros say that there is none.
void addFriction(ArgumentTable<JointArguments>& table) {
    table.add({{{"DELTA_V", Kind::Zero}, nullptr},
               {{"MU_DYN_ROT", Kind::Zero, 8}, nullptr},
               {{"MU_STAT_ROT", Kind::Zero, 9}, nullptr},
               {{"MU_DYN_TRANS", Kind::Zero, 8}, nullptr},
               {{"MU_STAT_TRANS", Kind::Zero, 9}, nullptr},
               {{"MAX_FRIC_ROT", Kind::Zero, 10}, nullptr},
               {{"MAX_FRIC_TRANS", Kind::Zero, 10}, nullptr},
               {{"MAX_DEFORMATION", Kind::Zero, 5}, nullptr},
               {{"INNER_RADIUS", Kind::Zero, 2}, nullptr},
               {{"OUTER_RADIUS", Kind::Zero}, nullptr},
               {{"PIN_RADIUS", Kind::Zero, 3}, nullptr},
               {{"BALL_RADIUS", Kind::Zero}, nullptr},
               {{"HEIGHT", Kind::Zero, 2}, nullptr},
               {{"WIDTH", Kind::Zero}, nullptr},
               {{"PRELOAD_RADIAL", Kind::Zero, 9}, nullptr},
               {{"PRELOAD_AXIAL", Kind::Zero, 9}, nullptr},
               {{"PRELOAD_X", Kind::Zero, ExactOnly}, nullptr},
               {{"PRELOAD_Y", Kind::Zero, ExactOnly}, nullptr}});
}

ArgumentTable<JointArguments> makeJointTable() {
    using J = JointArguments;
    ArgumentTable<J> table = {
        {type("SPHERICAL"), setType<J>},
        {type("REVOLUTE"), setType<J>},
        {type("CYLINDRICAL"), setType<J>},
        {type("TRANSLATIONAL"), setType<J>},
        {type("PLANAR", 2), setType<J>},
        {type("FIXED"), setType<J>},
        {type("UNIVERSAL"), setType<J>},
        {type("HOOKE"), setType<J>},
        {type("CONVEL", 2), setType<J>},
        {type("SCREW"), setType<J>},
        {type("RACKPIN"), setType<J>},
        {endMarker("I").required(), setI<J>},
        {endMarker("J").required(), setJ<J>},
        {{"PITCH", Kind::Real, 2}, [](J& j, const V& v) { j.pitch = v.getNumber(); }},
        {{"PD", Kind::Real, ExactOnly}, [](J& j, const V& v) { j.diameter = v.getNumber(); }},
        {ArgumentRule("IC", Kind::Angle, ExactOnly).of(1, 2), setIc},
        {ArgumentRule("ICTRAN", Kind::Real, 3).of(1, 2),
         [](J& j, const V& v) { j.icTranslation = makeInitialValue(v); }},
        {ArgumentRule("ICROT", Kind::Angle, 3).of(1, 2),
         [](J& j, const V& v) { j.icRotation = makeInitialValue(v); }}};
    addFriction(table);
    return table;
}

void checkNeeded(StatementReader& reader, const char* name, bool needed) {
    if (needed && !reader.has(name))
        reader.addError(0, fmt::format("{} needs {}: {}=", reader.getName(), name, name));
}

void checkJoint(StatementReader& reader, const JointArguments& joint) {
    const bool screw = joint.type == JointType::Screw;
    const bool rackpin = joint.type == JointType::Rackpin;
    const bool revolute = joint.type == JointType::Revolute;
    const bool cylindrical = joint.type == JointType::Cylindrical;
    checkNeeded(reader, "PITCH", screw);
    checkNeeded(reader, "PD", rackpin);
    checkAllowed(reader, "PITCH", screw, "SCREW joints");
    checkAllowed(reader, "PD", rackpin, "RACKPIN joints");
    checkAllowed(reader, "IC", revolute || joint.type == JointType::Translational,
                 "REVOLUTE and TRANSLATIONAL joints");
    checkAllowed(reader, "ICTRAN", cylindrical, "CYLINDRICAL joints");
    checkAllowed(reader, "ICROT", cylindrical, "CYLINDRICAL joints");
    if (joint.diameter == 0.0)
        reader.addError(
            reader.getOffset("PD"),
            fmt::format("PD of {} is 0; the pitch diameter of a pinion is not", reader.getName()));
    if (joint.type == JointType::Translational && joint.degrees)
        reader.addError(
            reader.getOffset("IC"),
            fmt::format("IC of {} is in degrees (suffix D), but a TRANSLATIONAL joint has no angle",
                        reader.getName()));
}

}  // namespace

void readJprim(StatementReader& reader) {
    JprimStatement jprim;
    if (reader.readStatement(getJprimTable(), jprim)) reader.updState().dataset.jprims.push_back(jprim);
}

void readJoint(StatementReader& reader) {
    static const ArgumentTable<JointArguments> table = makeJointTable();
    JointArguments joint;
    if (reader.readStatement(table, joint)) checkJoint(reader, joint);
    if (!reader.hasErrors()) reader.updState().dataset.joints.push_back(joint);
}

}  // namespace jprim
