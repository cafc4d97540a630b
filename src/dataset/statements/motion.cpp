// SPDX-License-Identifier: Apache-2.0
// MOTION: a coordinate of a joint, or between two markers, as a function of time.
#include "base/format.h"
#include "dataset/statements/connection_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = MotionStatement;

const SpellingTable<MotionAxis>& getAxes() {
    using A = MotionAxis;
    static const SpellingTable<A> axes = {{A::Rotation, "ROTATIONAL"}, {A::Translation, "TRANSLATIONAL"},
                                          {A::X, "X", ExactOnly},      {A::Y, "Y", ExactOnly},
                                          {A::Z, "Z", ExactOnly},      {A::B1, "B1", ExactOnly},
                                          {A::B2, "B2", ExactOnly},    {A::B3, "B3", ExactOnly}};
    return axes;
}

const SpellingTable<KinematicLevel>& getLevels() {
    using L = KinematicLevel;
    static const SpellingTable<L> levels = {
        {L::Position, "DISPLACEMENT"}, {L::Velocity, "VELOCITY"}, {L::Acceleration, "ACCELERATION"}};
    return levels;
}

const FieldTable<S>& getFields() {
    constexpr int levelGroup = 1;
    static const FieldTable<S> fields = {
        field({"JOINT", Kind::Joint, 2}, &S::joint),
        field(endMarker("I"), &S::i),
        field(endMarker("J"), &S::j),
        choice(getAxes(), &S::axis),
        choice(getLevels(), &S::level, false, levelGroup),
        field({"ICDISP", Kind::Angle, 3}, &S::icdisp),
        field({"ICVEL", Kind::Angle, 3}, &S::icvel),
        field(functionRule(), &S::function),
        ArgumentRule("JPRIM", Kind::Ignored, ExactOnly)};  // read() refuses it
    return fields;
}

bool isOfJoint(MotionAxis axis) {
    return axis <= MotionAxis::Translation;
}

void checkJointForm(StatementReader& reader, const S& motion) {
    if (!isOfJoint(motion.axis))
        return reader.addError(reader.getOffset(getAdamsName(motion.axis)),
                               fmt::format("{} of {} is a component between two markers; a joint has "
                                           "ROTATIONAL or TRANSLATIONAL",
                                           getAdamsName(motion.axis), reader.getName()));
    std::vector<CouplerType> coordinate;
    if (motion.axis == MotionAxis::Rotation) coordinate = {CouplerType::Rotational};
    if (motion.axis == MotionAxis::Translation) coordinate = {CouplerType::Translational};
    reader.useJoints("JOINT", coordinate, "ROTATIONAL or TRANSLATIONAL");
}

void checkMarkerForm(StatementReader& reader, const S& motion) {
    if (motion.i == 0 || motion.j == 0) reader.checkNeeded(motion.i == 0 ? "I" : "J", true);
    if (isOfJoint(motion.axis))
        reader.addError(
            reader.getOffset(getAdamsName(motion.axis)),
            fmt::format("{} needs a component between its markers: X, Y, Z, B1, B2 or B3", reader.getName()));
}

void checkForm(StatementReader& reader, const S& motion) {
    const bool markers = motion.i != 0 || motion.j != 0;
    if (motion.joint != 0 && markers)
        reader.addError(reader.getOffset("JOINT"),
                        fmt::format("{} takes JOINT or I and J, not both", reader.getName()));
    else if (motion.joint != 0)
        checkJointForm(reader, motion);
    else if (markers)
        checkMarkerForm(reader, motion);
    else
        reader.addError(
            0, fmt::format("{} needs a joint or two markers: JOINT= or I= and J=", reader.getName()));
}

// A constant of integration is needed once for each integral. Whether a joint's only coordinate is an angle
// is not known here.
void checkInitialValues(StatementReader& reader, const S& motion) {
    reader.checkAllowed("ICDISP", motion.level > KinematicLevel::Position, "VELOCITY and ACCELERATION");
    reader.checkAllowed("ICVEL", motion.level == KinematicLevel::Acceleration, "ACCELERATION");
    const bool length = motion.axis >= MotionAxis::Translation && motion.axis <= MotionAxis::Z;
    for (const char* name : {"ICDISP", "ICVEL"})
        if (length && reader.isInDegrees(name))
            reader.addError(reader.getOffset(name),
                            fmt::format("{} of {} is in degrees (suffix D), but {} is not an angle", name,
                                        reader.getName(), getAdamsName(motion.axis)));
}

void read(StatementReader& reader) {
    S motion;
    const bool isGood = reader.readStatement(getFields(), motion);
    if (reader.has("JPRIM"))
        return reader.addError(reader.getOffset("JPRIM"),
                               reader.getName() + " acts on a JPRIM, and no MOTION can; use a JOINT");
    if (isGood) {
        checkForm(reader, motion);
        checkInitialValues(reader, motion);
    }
    if (!reader.hasErrors()) reader.updState().dataset.motions.push_back(std::move(motion));
}

}  // namespace

StatementKind describeMotion() {
    return readBy(read, makeKind("MOTION", 2, getFields(), &Dataset::motions));
}

const char* getAdamsName(MotionAxis axis) {
    return axis == MotionAxis::Joint ? "" : getAxes().getName(axis).data();
}

const char* getAdamsName(KinematicLevel level) {
    return getLevels().getName(level).data();
}

}  // namespace jprim
