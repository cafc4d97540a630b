// SPDX-License-Identifier: Apache-2.0
// MOTION: a coordinate of a joint, or between two markers, as a function of time.
#include <utility>

#include "base/format.h"
#include "dataset/connection_arguments.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using V = ArgumentValue;

// The statement, and whether its initial values were given in degrees, which only angles can be.
struct MotionArguments : MotionStatement {
    bool displacementInDegrees = false;
    bool velocityInDegrees = false;
};
using M = MotionArguments;

// The axes come first, in the order of MotionAxis but without Joint, then the levels.
constexpr std::size_t FirstLevelRow = 8;
constexpr int LevelGroup = 1;

void setAxis(M& m, const V& v) {
    m.axis = static_cast<MotionAxis>(v.row + 1);
}
void setLevel(M& m, const V& v) {
    m.level = static_cast<MotionLevel>(v.row - FirstLevelRow);
}
void setIcdisp(M& m, const V& v) {
    m.icdisp = v.getNumber();
    m.displacementInDegrees = v.degrees;
}
void setIcvel(M& m, const V& v) {
    m.icvel = v.getNumber();
    m.velocityInDegrees = v.degrees;
}

const ArgumentTable<M>& getMotionTable() {
    static const ArgumentTable<M> table = {
        {{"ROTATIONAL", Kind::Choice}, setAxis},
        {{"TRANSLATIONAL", Kind::Choice}, setAxis},
        {{"X", Kind::Choice, ExactOnly}, setAxis},
        {{"Y", Kind::Choice, ExactOnly}, setAxis},
        {{"Z", Kind::Choice, ExactOnly}, setAxis},
        {{"B1", Kind::Choice, ExactOnly}, setAxis},
        {{"B2", Kind::Choice, ExactOnly}, setAxis},
        {{"B3", Kind::Choice, ExactOnly}, setAxis},
        {ArgumentRule("DISPLACEMENT", Kind::Choice).in(LevelGroup), setLevel},
        {ArgumentRule("VELOCITY", Kind::Choice).in(LevelGroup), setLevel},
        {ArgumentRule("ACCELERATION", Kind::Choice).in(LevelGroup), setLevel},
        {{"JOINT", Kind::Joint, 2}, [](M& m, const V& v) { m.joint = v.getId(); }},
        {endMarker("I"), setI<M>},
        {endMarker("J"), setJ<M>},
        {functionRule(), setFunction<M>},
        {{"ICDISP", Kind::Angle, 3}, setIcdisp},
        {{"ICVEL", Kind::Angle, 3}, setIcvel},
        {{"JPRIM", Kind::Ignored, ExactOnly}, nullptr}};  // readMotion() refuses it
    return table;
}

bool isOfJoint(MotionAxis axis) {
    return axis <= MotionAxis::Translation;
}

void checkJointForm(StatementReader& reader, const M& motion) {
    if (!isOfJoint(motion.axis))
        return reader.addError(reader.getOffset(getAdamsName(motion.axis)),
                               fmt::format("{} of {} is a component between two markers; a joint has "
                                           "ROTATIONAL or TRANSLATIONAL",
                                           getAdamsName(motion.axis), reader.getName()));
    std::optional<CouplerType> coordinate;
    if (motion.axis == MotionAxis::Rotation) coordinate = CouplerType::Rotational;
    if (motion.axis == MotionAxis::Translation) coordinate = CouplerType::Translational;
    reader.useJoint("JOINT", reader.getOffset("JOINT"), motion.joint, coordinate,
                    "ROTATIONAL or TRANSLATIONAL");
}

void checkMarkerForm(StatementReader& reader, const M& motion) {
    if (motion.i == 0 || motion.j == 0)
        reader.addError(0, fmt::format("{} needs {}: {}=", reader.getName(), motion.i == 0 ? "I" : "J",
                                       motion.i == 0 ? "I" : "J"));
    if (isOfJoint(motion.axis))
        reader.addError(
            reader.getOffset(getAdamsName(motion.axis)),
            fmt::format("{} needs a component between its markers: X, Y, Z, B1, B2 or B3", reader.getName()));
}

void checkForm(StatementReader& reader, const M& motion) {
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
void checkInitialValues(StatementReader& reader, const M& motion) {
    checkAllowed(reader, "ICDISP", motion.level > MotionLevel::Displacement, "VELOCITY and ACCELERATION");
    checkAllowed(reader, "ICVEL", motion.level == MotionLevel::Acceleration, "ACCELERATION");
    const bool length = motion.axis >= MotionAxis::Translation && motion.axis <= MotionAxis::Z;
    const auto check = [&](const char* name, bool degrees) {
        if (length && degrees)
            reader.addError(reader.getOffset(name),
                            fmt::format("{} of {} is in degrees (suffix D), but {} is not an angle", name,
                                        reader.getName(), getAdamsName(motion.axis)));
    };
    check("ICDISP", motion.displacementInDegrees);
    check("ICVEL", motion.velocityInDegrees);
}

}  // namespace

void readMotion(StatementReader& reader) {
    MotionArguments motion;
    const bool good = reader.readStatement(getMotionTable(), motion);
    if (reader.has("JPRIM"))
        return reader.addError(reader.getOffset("JPRIM"),
                               reader.getName() + " acts on a JPRIM, and no MOTION can; use a JOINT");
    if (good) {
        checkForm(reader, motion);
        checkInitialValues(reader, motion);
    }
    if (!reader.hasErrors()) reader.updState().dataset.motions.push_back(std::move(motion));
}

}  // namespace jprim
