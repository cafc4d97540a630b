// SPDX-License-Identifier: Apache-2.0
#include "base/format.h"
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = JointStatement;

const SpellingTable<JointType>& getTypes() {
    using T = JointType;
    static const SpellingTable<T> types = {
        {T::Spherical, "SPHERICAL"},     {T::Revolute, "REVOLUTE"},
        {T::Cylindrical, "CYLINDRICAL"}, {T::Translational, "TRANSLATIONAL"},
        {T::Planar, "PLANAR", 2},        {T::Fixed, "FIXED"},
        {T::Universal, "UNIVERSAL"},     {T::Hooke, "HOOKE"},
        {T::Convel, "CONVEL", 2},        {T::Screw, "SCREW"},
        {T::Rackpin, "RACKPIN"}};
    return types;
}

Field<S> initialValueField(const ArgumentRule& rule, std::optional<JointInitialValue> S::*member) {
    return {rule,
            [member](S& s, const ArgumentValue& given) {
                JointInitialValue& value = (s.*member).emplace();
                value.displacement = given.getNumber();
                if (given.numbers.size() > 1) value.velocity = given.numbers[1];
            },
            [member, rule](StatementWriter& writer, const S& s) {
                if (!(s.*member)) return;
                writer.addValue(rule.name, (s.*member)->displacement);
                if ((s.*member)->velocity) writer.add(fmt::format("{}", *(s.*member)->velocity));
            },
            [member](const S& a, const S& b) {
                const std::optional<JointInitialValue>&x = a.*member, &y = b.*member;
                return x.has_value() == y.has_value() &&
                       (!x || (x->displacement == y->displacement && x->velocity == y->velocity));
            }};
}

// Friction of old files: zeros say that there is none.
std::vector<Field<S>> frictionFields() {
    constexpr Word names[] = {{"DELTA_V"},
                              {"MU_DYN_ROT", 8},
                              {"MU_STAT_ROT", 9},
                              {"MU_DYN_TRANS", 8},
                              {"MU_STAT_TRANS", 9},
                              {"MAX_FRIC_ROT", 10},
                              {"MAX_FRIC_TRANS", 10},
                              {"MAX_DEFORMATION", 5},
                              {"INNER_RADIUS", 2},
                              {"OUTER_RADIUS"},
                              {"PIN_RADIUS", 3},
                              {"BALL_RADIUS"},
                              {"HEIGHT", 2},
                              {"WIDTH"},
                              {"PRELOAD_RADIAL", 9},
                              {"PRELOAD_AXIAL", 9},
                              {"PRELOAD_X", ExactOnly},
                              {"PRELOAD_Y", ExactOnly}};
    std::vector<Field<S>> fields;
    for (const Word& word : names) fields.emplace_back(ArgumentRule(word.name, Kind::Zero, word.minimum));
    return fields;
}

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {
        choice(getTypes(), &S::type, true),
        endMarkers<S>(),
        field({"PITCH", Kind::Real, 2}, &S::pitch),
        field({"PD", Kind::Real, ExactOnly}, &S::diameter),
        initialValueField(ArgumentRule("IC", Kind::Angle, ExactOnly).of(1, 2), &S::ic),
        initialValueField(ArgumentRule("ICTRAN", Kind::Real, 3).of(1, 2), &S::icTranslation),
        initialValueField(ArgumentRule("ICROT", Kind::Angle, 3).of(1, 2), &S::icRotation),
        frictionFields()};
    return fields;
}

void check(StatementReader& reader, S& joint) {
    const bool screw = joint.type == JointType::Screw;
    const bool rackpin = joint.type == JointType::Rackpin;
    const bool translational = joint.type == JointType::Translational;
    const bool cylindrical = joint.type == JointType::Cylindrical;
    reader.checkNeeded("PITCH", screw);
    reader.checkNeeded("PD", rackpin);
    reader.checkAllowed("PITCH", screw, "SCREW joints");
    reader.checkAllowed("PD", rackpin, "RACKPIN joints");
    reader.checkAllowed("IC", translational || joint.type == JointType::Revolute,
                        "REVOLUTE and TRANSLATIONAL joints");
    reader.checkAllowed("ICTRAN", cylindrical, "CYLINDRICAL joints");
    reader.checkAllowed("ICROT", cylindrical, "CYLINDRICAL joints");
    if (joint.diameter == 0.0)
        reader.addError(
            reader.getOffset("PD"),
            fmt::format("PD of {} is 0; the pitch diameter of a pinion is not", reader.getName()));
    if (translational && reader.isInDegrees("IC"))
        reader.addError(
            reader.getOffset("IC"),
            fmt::format("IC of {} is in degrees (suffix D), but a TRANSLATIONAL joint has no angle",
                        reader.getName()));
}

}  // namespace

StatementKind describeJoint() {
    return makeKind("JOINT", 1, getFields(), &Dataset::joints, check);
}

const char* getAdamsName(JointType type) {
    return getTypes().getName(type).data();
}

}  // namespace jprim
