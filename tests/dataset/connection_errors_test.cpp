// SPDX-License-Identifier: Apache-2.0
// Mistakes in constraints, forces, and the data and events that go with them.
#include "dataset/error_cases.h"

namespace jprim {
namespace {

TEST(DatasetErrors, Gcon) {
    check({
        {"no function", "GCON/1, I=1", "3:1: error: GCON/1 needs FUNCTION: FUNCTION="},
        {"second marker", "GCON/1, I=1, J=2, FUNC=DM(1,2)-3", "3:14: error: unknown argument 'J' of GCON/1"},
        {"marker that does not exist", "GCON/1, I=77, FUNC=DX(1)",
         "3:11: error: I of GCON/1: there is no MARKER/77"},
        {"empty", "GCON/1, FUNCTION=", "3:9: error: FUNCTION of GCON/1 is empty"},
        {"twice", "GCON/1, FUNCTION=1\nGCON/1, FUNCTION=2",
         "4:1: error: GCON/1 is already given in line 3; choose another id"},
    });
}

TEST(DatasetErrors, UserSubroutines) {
    const char* const remedy = " calls a user subroutine, and none can be run; write it as an expression";
    const std::pair<std::string, std::string> cases[] = {
        {"GCON/1, FUNCTION=USER(1,2)", "3:18: error: FUNCTION of GCON/1"},
        {"SFORCE/1, I=1, J=2, TRANS, FUNC = user (3)\\ROUTINE=QQQ", "3:35: error: FUNCTION of SFORCE/1"},
        {"VFORCE/1, FUNCTION=USER(1)", "3:20: error: FUNCTION of VFORCE/1"},
        {"GFORCE/1, FUNCTION=USER(1)\\I=QQQ", "3:20: error: FUNCTION of GFORCE/1"},
        {"COUPLER/1, FUNCTION=USER(1)", "3:21: error: FUNCTION of COUPLER/1"},
        {"VARIABLE/1\n, FUNCTION =\n, USER(1)", "5:3: error: FUNCTION of VARIABLE/1"},
        {"SPLINE/1, FUNCTION=USER(1)", "3:20: error: FUNCTION of SPLINE/1"},
    };
    for (const auto& [statement, where] : cases) {
        const std::string findings = readInModel(statement).findings;
        EXPECT_EQ(findings.substr(0, findings.find('\n')), where + remedy);
    }
    readGood(
        "VARIABLE/1, FUNCTION=USERS+1\nVARIABLE/2, FUNCTION=2*USER(1)");  // other names; not the only call
}

constexpr const char* Joints =
    "JOINT/1, REV, I=1, J=2; JOINT/2, TRA, I=1, J=2; JOINT/3, CYL, I=1, J=2; JOINT/4, SPH, I=1, J=2\n";

void checkWithJoints(const std::vector<ErrorCase>& cases) {
    for (const ErrorCase& c : cases) check({{c.name, Joints + c.statements, c.findings}});
}

TEST(DatasetErrors, MotionForms) {
    checkWithJoints({
        {"neither form", "MOTION/1, FUNCTION=TIME",
         "4:1: error: MOTION/1 needs a joint or two markers: JOINT= or I= and J="},
        {"both forms", "MOTION/1, I=1, JOINT=1, J=2, FUNCTION=TIME",
         "4:16: error: MOTION/1 takes JOINT or I and J, not both"},
        {"one marker", "MOTION/1, I=1, B1, FUNCTION=TIME", "4:1: error: MOTION/1 needs J: J="},
        {"one marker and a word for joints", "MOTION/1, J=1, ROT, FUNCTION=TIME",
         "4:1: error: MOTION/1 needs I: I=\n"
         "4:16: error: MOTION/1 needs a component between its markers: X, Y, Z, B1, B2 or B3"},
        {"no component", "MOTION/1, I=1, J=2, FUNCTION=TIME",
         "4:1: error: MOTION/1 needs a component between its markers: X, Y, Z, B1, B2 or B3"},
        {"component of a joint", "MOTION/1, JOINT=1, B3, FUNCTION=TIME",
         "4:20: error: B3 of MOTION/1 is a component between two markers; a joint has ROTATIONAL or "
         "TRANSLATIONAL"},
        {"two components", "MOTION/1, I=1, J=2, X, B3, FUNCTION=TIME",
         "4:24: error: MOTION/1 cannot be both X and B3"},
        {"two levels", "MOTION/1, JOINT=1, VEL, ACC, FUNCTION=TIME",
         "4:25: error: MOTION/1 cannot be both VELOCITY and ACCELERATION"},
        {"on a primitive", "MOTION/1, FUNCTION=JPRIM(1,0,2,0)\\\n, jprim = 1",
         "5:3: error: MOTION/1 acts on a JPRIM, and no MOTION can; use a JOINT"},
        {"on one part", "MARKER/3, PART=2\nMOTION/1, I=3, J=2, X, FUNCTION=TIME",
         "5:18: error: MOTION/1 connects PART/2 with itself; I and J must be markers of different parts"},
    });
}

TEST(DatasetErrors, MotionValues) {
    checkWithJoints({
        {"constant of no integral", "MOTION/1, JOINT=1, ICDISP=1, FUNCTION=TIME",
         "4:20: error: ICDISP of MOTION/1 is for VELOCITY and ACCELERATION only"},
        {"constant of one integral", "MOTION/1, JOINT=1, VEL, ICVEL=1, FUNCTION=TIME",
         "4:25: error: ICVEL of MOTION/1 is for ACCELERATION only"},
        {"degrees of a length", "MOTION/1, I=1, J=2, Z, ACC, ICD=1D, ICV=2d, FUNCTION=TIME",
         "4:29: error: ICDISP of MOTION/1 is in degrees (suffix D), but Z is not an angle\n"
         "4:37: error: ICVEL of MOTION/1 is in degrees (suffix D), but Z is not an angle"},
    });
}

TEST(DatasetErrors, JointsOfMotionsAndCouplers) {
    checkWithJoints({
        {"joint that does not exist", "MOTION/1, JOINT=9, FUNCTION=TIME",
         "4:17: error: JOINT of MOTION/1: there is no JOINT/9"},
        {"joint without a coordinate", "MOTION/1, JOINT=4, FUNCTION=TIME",
         "4:11: error: JOINT of MOTION/1: JOINT/4 is SPHERICAL; only REVOLUTE, TRANSLATIONAL and CYLINDRICAL "
         "joints have a coordinate"},
        {"joint with two", "MOTION/1, JOINT=3, FUNCTION=TIME",
         "4:11: error: JOINT of MOTION/1: JOINT/3 is CYLINDRICAL, so it must be said which of its two "
         "coordinates is meant: ROTATIONAL or TRANSLATIONAL"},
        {"hinge that slides", "MOTION/1, TRANS, JOINT=1, FUNCTION=TIME",
         "4:18: error: JOINT of MOTION/1: JOINT/1 is REVOLUTE, which does not translate"},
        {"slider that turns", "MOTION/1, ROT, JOINT=2, FUNCTION=TIME",
         "4:16: error: JOINT of MOTION/1: JOINT/2 is TRANSLATIONAL, which does not rotate"},
        {"coupled ball", "COUPLER/1, JOINTS=1,4, SCALES=2",
         "4:21: error: JOINTS of COUPLER/1: JOINT/4 is SPHERICAL; only REVOLUTE, TRANSLATIONAL and "
         "CYLINDRICAL joints have a coordinate"},
        {"coupled cylinder", "COUPLER/1, JOINTS=1,2, 3, SCALES=2,3",
         "4:24: error: JOINTS of COUPLER/1: JOINT/3 is CYLINDRICAL, so it must be said which of its two "
         "coordinates is meant: TYPE="},
        {"coupled the wrong way", "COUPLER/1, JOINTS=1,2, TYPE=T:R, SCALES=2",
         "4:19: error: JOINTS of COUPLER/1: JOINT/1 is REVOLUTE, which does not translate\n"
         "4:21: error: JOINTS of COUPLER/1: JOINT/2 is TRANSLATIONAL, which does not rotate"},
        {"coupled joints that do not exist", "COUPLER/1, JOINTS=8,1,9, SCALES=2,2",
         "4:19: error: JOINTS of COUPLER/1: there is no JOINT/8\n"
         "4:23: error: JOINTS of COUPLER/1: there is no JOINT/9"},
    });
    // The joint's own mistake is reported, and nothing made up about its type.
    EXPECT_EQ(readInModel("JOINT/1, QQQ, I=1, J=2\nMOTION/1, JOINT=1, FUNCTION=TIME").findings,
              "3:10: error: unknown argument 'QQQ' of JOINT/1");
}

TEST(DatasetErrors, CouplerLists) {
    checkWithJoints({
        {"one joint", "COUPLER/1, JOINTS=1, SCALES=2",
         "4:12: error: JOINTS of COUPLER/1 takes 2 or 3 ids, not 1"},
        {"no scales", "COUPLER/1, JOINTS=1,2", "4:1: error: COUPLER/1 needs SCALES: SCALES="},
        {"too many scales", "COUPLER/1, JOINTS=1,2, SCALES=1,2,3",
         "4:24: error: SCALES of COUPLER/1 takes 1 or 2 numbers for 2 joints, not 3"},
        {"too few scales", "COUPLER/1, JOINTS=1,2,1, SCALES=1",
         "4:26: error: SCALES of COUPLER/1 takes 2 or 3 numbers for 3 joints, not 1"},
        {"too few types", "COUPLER/1, JOINTS=1,2,1, TYPE=R:T, SCALES=1,2",
         "4:26: error: TYPE of COUPLER/1 takes 3 words for 3 joints, not 2"},
        {"unknown type", "COUPLER/1, JOINTS=1,2, TYPE=R:QQQ, SCALES=1,2",
         "4:31: error: TYPE of COUPLER/1: unknown word 'QQQ'"},
    });
}

TEST(DatasetErrors, Forces) {
    check({
        {"no type", "SFORCE/1, I=1, J=2, FUNCTION=1",
         "3:1: error: SFORCE/1 needs a type: TRANSLATIONAL, ROTATIONAL"},
        {"both types", "SFORCE/1, I=1, J=2, ROT, TRANSLATION, FUNCTION=1",
         "3:26: error: SFORCE/1 cannot be both ROTATIONAL and TRANSLATIONAL"},
        {"reaction on the same part", "MARKER/3\nSFORCE/1, I=3, J=2, ROT, FUNCTION=1",
         "4:18: error: SFORCE/1 connects PART/2 with itself; I and J must be markers of different parts"},
        {"spring of the other type", "SPRINGDAMPER/1, TRANS, I=1, J=2, KT=1, CT=1, ANG=1, TOR=1",
         "3:34: error: KT of SPRINGDAMPER/1 is for ROTATIONAL only\n"
         "3:40: error: CT of SPRINGDAMPER/1 is for ROTATIONAL only\n"
         "3:46: error: ANGLE of SPRINGDAMPER/1 is for ROTATIONAL only\n"
         "3:53: error: TORQUE of SPRINGDAMPER/1 is for ROTATIONAL only"},
        {"spring of the first type", "SPRINGDAMPER/1, ROT, I=1, J=2, K=1, C=1, LEN=1, FORCE=1",
         "3:32: error: K of SPRINGDAMPER/1 is for TRANSLATIONAL only\n"
         "3:37: error: C of SPRINGDAMPER/1 is for TRANSLATIONAL only\n"
         "3:42: error: LENGTH of SPRINGDAMPER/1 is for TRANSLATIONAL only\n"
         "3:49: error: FORCE of SPRINGDAMPER/1 is for TRANSLATIONAL only"},
        {"length in degrees", "SPRINGDAMPER/1, TRANS, I=1, J=2, LENGTH=90D",
         "3:41: error: LENGTH of SPRINGDAMPER/1: '90D' is in degrees (suffix D), but this is not an angle"},
        {"two stiffnesses", "BUSHING/1, I=1, J=2, K=1,2",
         "3:22: error: K of BUSHING/1 takes 3 numbers, not 2"},
        {"no J", "BUSHING/1, I=1", "3:1: error: BUSHING/1 needs J: J="},
    });
}

TEST(DatasetErrors, VectorForces) {
    check({
        {"no component", "MARKER/3, FLO\nVFORCE/1, I=1, JFLOAT=3",
         "4:1: error: VFORCE/1 needs a component: FX, FY, FZ or FXYZ"},
        {"no component of a torque", "MARKER/3, FLO\nVTORQUE/1, I=1, JFLOAT=3",
         "4:1: error: VTORQUE/1 needs a component: TX, TY, TZ or TXYZ"},
        {"no component of both", "MARKER/3, FLO\nGFORCE/1, I=1, JFLOAT=3",
         "4:1: error: GFORCE/1 needs a component: FX, FY, FZ or FXYZ, TX, TY, TZ or TXYZ"},
        {"components and vectors",
         "MARKER/3, FLO\nGFORCE/1, I=1, JFLOAT=3, FY=1\\FXYZ=[1,2,3]\\TX=2\\TXYZ=[4,5,6]",
         "4:26: error: GFORCE/1 takes FY or FXYZ, not both\n4:44: error: GFORCE/1 takes TX or TXYZ, not both"},
        {"torque of a force", "VFORCE/1, TX=1",
         "3:11: error: unknown argument 'TX' of VFORCE/1; did you mean FX?"},
        {"force of a torque", "VTORQUE/1, FZ=1",
         "3:12: error: unknown argument 'FZ' of VTORQUE/1; did you mean TZ?"},
        {"reaction at a fixed marker", "VFORCE/1, I=1, JFLOAT=2, FX=1",
         "3:23: error: JFLOAT of VFORCE/1: MARKER/2 is not FLOATING, as a marker that moves along with I must "
         "be"},
        {"action at a floating marker", "MARKER/3, FLO, PART=1\nVFORCE/1, I=3, JFLOAT=3, FX=1",
         "4:13: error: I of VFORCE/1: MARKER/3 is FLOATING, and only JFLOAT may name such a marker"},
        {"reaction on the same part", "MARKER/3, FLO\nVFORCE/1, JFLOAT=3, I=2, FX=1",
         "4:23: error: VFORCE/1 connects PART/2 with itself; I and JFLOAT must be markers of different parts"},
    });
}

TEST(DatasetErrors, VariablesAndSplines) {
    check({
        {"no function", "VARIABLE/1, IC=2", "3:1: error: VARIABLE/1 needs FUNCTION: FUNCTION="},
        {"too short", "SPLINE/1, X=1,2,3, Y=1,2,3",
         "3:11: error: X of SPLINE/1 takes at least 4 numbers, not 3\n"
         "3:20: error: Y of SPLINE/1 takes at least 4 numbers, not 3"},
        {"no Y", "SPLINE/1, X=1,2,3,4", "3:1: error: SPLINE/1 needs Y: Y="},
        {"not increasing", "SPLINE/1, X=1,2\n, 2.5,2.5, Y=1,2,3,4",
         "4:7: error: X of SPLINE/1 must increase, but 2.5 follows 2.5"},
        {"one y too many", "SPLINE/1, X=1,2,3,4,5, Y=1,2,3,4,5,6,7",
         "3:26: error: Y of SPLINE/1 takes 5 numbers, one for each X, or in a family 6, z before them, not 7"},
        {"family without z", "SPLINE/1, X=1,2,3,4, Y=0,1,2,3,4, Y=1,2,3,4",
         "3:37: error: Y of SPLINE/1 takes 4 numbers, one for each X, or in a family 5, z before them, not 4"},
        {"family not increasing", "SPLINE/1, X=1,2,3,4, Y=3,1,2,3,4, Y=2,1,2,3,4",
         "3:37: error: z of SPLINE/1 must increase, but 2 follows 3"},
        {"no number", "SPLINE/1, X=1,2,3,QQQ, Y=1,2,3,4",
         "3:19: error: X of SPLINE/1: 'QQQ' is not a number; write it like 1.5 or 1.5E3"},
        {"from a file", "SPLINE/1, FILE=QQQ", "3:11: error: FILE of SPLINE/1 is not supported yet"},
    });
}

TEST(DatasetErrors, Sensors) {
    check({
        {"no value", "SENSOR/1, HALT, FUNCTION=TIME", "3:1: error: SENSOR/1 needs VALUE: VALUE="},
        {"two comparisons", "SENSOR/1, GE, LE, VALUE=1, HALT, FUNCTION=TIME",
         "3:15: error: SENSOR/1 cannot be both GE and LE"},
        {"negative tolerance", "SENSOR/1, ERROR=-0.1, VALUE=1, HALT, FUNCTION=TIME",
         "3:11: error: ERROR of SENSOR/1 is -0.1; it cannot be negative"},
        {"without effect", "SENSOR/1, VALUE=1, PRINT, YYDUMP, FUNCTION=TIME",
         "3:1: warning: SENSOR/1 has no effect without HALT, RETURN or EVALUATE\n"
         "3:20: warning: PRINT of SENSOR/1 has no effect\n3:27: warning: YYDUMP of SENSOR/1 has no effect"},
        {"other output steps", "SENSOR/1, VALUE=1, DT=1, STEP=2, ANGULAR, FUNCTION=TIME",
         "3:20: error: DT of SENSOR/1 is not supported yet\n"
         "3:26: error: STEPSIZE of SENSOR/1 is not supported yet\n"
         "3:34: error: ANGULAR of SENSOR/1 is not supported yet"},
    });
}

TEST(DatasetErrors, MrequestsAreWarnedAbout) {
    const Reading reading = readInModel("MREQUEST/1, PART=2, DISPLACEMENT");
    EXPECT_EQ(reading.findings,
              "3:1: warning: MREQUEST/1 writes nothing here; write a REQUEST for each pair of markers");
    EXPECT_EQ(reading.dataset.counts.ignored, 1);
}

}  // namespace
}  // namespace jprim
