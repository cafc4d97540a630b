// SPDX-License-Identifier: Apache-2.0
// Every mistake has its place and its words. QQQ marks what is wrong on purpose.
#include "dataset/error_cases.h"

namespace jprim {
namespace {

TEST(DatasetErrors, Statements) {
    check({
        {"nearest keyword", "MARKRE/3", "3:1: error: unknown statement 'MARKRE'; did you mean MARKER?"},
        {"no keyword is near", "QQQ/3", "3:1: error: unknown statement 'QQQ'"},
        {"no slash", "MARKER", "3:7: error: a slash is missing after 'MARKER'"},
        {"no slash before the id", "MARKER 3", "3:8: error: a slash is missing after 'MARKER'"},
        {"no keyword", "=QQQ, 1", "3:1: error: '=QQQ' does not begin a statement; one begins with KEYWORD/"},
        {"ampersand inside a line", "MARKER/3 & , QP=1,2,3",
         "3:10: error: '&' may only end a line, to continue it on the next"},
        {"id missing", "MARKER/, PART=1",
         "3:8: error: id of MARKER: '' is not an id; ids are whole numbers from 1"},
        {"id is a word", "JPRIM/QQQ, ATPOINT, I=1, J=2",
         "3:7: error: id of JPRIM: 'QQQ' is not an id; ids are whole numbers from 1"},
        {"id is zero", "PART/0", "3:6: error: id of PART: '0' is not an id; ids are whole numbers from 1"},
        {"id is negative", "PART/-1",
         "3:6: error: id of PART: '-1' is not an id; ids are whole numbers from 1"},
        {"id is too large", "PART/2147483648",
         "3:6: error: id of PART: '2147483648' is out of range; ids go up to 2147483647"},
        {"no comma after the id", "MARKER/3 PART=1", "3:10: error: a comma is missing after MARKER/3"},
        {"id given twice", "MARKER/1", "3:1: error: MARKER/1 is already given in line 2; choose another id"},
        {"twice with a leading zero", "JPRIM/4,ATP,I=1,J=2\nJPRIM/04,ATP,I=1,J=2",
         "4:1: error: JPRIM/4 is already given in line 3; choose another id"},
        {"graphics given twice", "GRAPHICS/1, OUTLINE=1,2\nGRAPHICS/1, OUTLINE=1,2",
         "4:1: error: GRAPHICS/1 is already given in line 3; choose another id"},
        {"all mistakes are listed", "MARKRE/3\nPART/3, QQQ\nMARKER/1",
         "3:1: error: unknown statement 'MARKRE'; did you mean MARKER?\n"
         "4:9: error: unknown argument 'QQQ' of PART/3\n"
         "5:1: error: MARKER/1 is already given in line 2; choose another id"},
    });
}

TEST(DatasetErrors, StatementsNotSupportedYet) {
    for (const std::string keyword :
         {"CURVE",      "PTCV",    "CVCV",      "CONTACT", "FRICTION",    "BEAM",       "FIELD",
          "NFORCE",     "UCON",    "FE_PART",   "SURFACE", "TIRE",        "FE_LOAD",    "FE_NODE",
          "FE_SECTION", "FEMDATA", "CLEARANCE", "MFORCE",  "PLANT_STATE", "ENVIRONMENT"})
        EXPECT_EQ(readInModel(keyword + "/1, QQQ=(1,2").findings,
                  "3:1: error: " + keyword + " is not supported yet");
}

TEST(DatasetErrors, Arguments) {
    check({
        {"nearest argument", "MARKER/3, QPX=1,2,3",
         "3:11: error: unknown argument 'QPX' of MARKER/3; did you mean QP?"},
        {"several in one statement", "MARKER/3, QQQ=1, QPX=2,3\n,PRAT=1",
         "3:11: error: unknown argument 'QQQ' of MARKER/3\n"
         "3:18: error: unknown argument 'QPX' of MARKER/3; did you mean QP?\n"
         "4:2: error: unknown argument 'PRAT' of MARKER/3"},
        {"ambiguous", "JOINT/1, R, I=1, J=2",
         "3:10: error: 'R' is ambiguous in JOINT/1: REVOLUTE or RACKPIN?"},
        {"given twice", "MARKER/3, QP=1,2,3, PART=1, Q=1,2,3", "3:29: error: QP of MARKER/3 is given twice"},
        {"needs a value", "MARKER/3, QP", "3:11: error: QP of MARKER/3 needs a value: QP="},
        {"takes no value", "MARKER/3, USEXP=1", "3:11: error: USEXP of MARKER/3 takes no value"},
        {"too few numbers", "MARKER/3, QP=1,2", "3:11: error: QP of MARKER/3 takes 3 numbers, not 2"},
        {"too few before the next argument", "MARKER/3, QP=1, PART=1",
         "3:11: error: QP of MARKER/3 takes 3 numbers, not 1"},
        {"too many numbers", "MARKER/3, QP=1,2,3,4, PART=1",
         "3:11: error: QP of MARKER/3 takes 3 numbers, not 4"},
        {"one number", "PART/3, VX=1,2", "3:9: error: VX of PART/3 takes 1 number, not 2"},
        {"either count", "PART/3, IP=1,2,3,4", "3:9: error: IP of PART/3 takes 3 or 6 numbers, not 4"},
        {"one id", "MARKER/3, PART=1,2", "3:11: error: PART of MARKER/3 takes 1 id, not 2"},
        {"not a number", "MARKER/3, QP=1,QQQ,3",
         "3:16: error: QP of MARKER/3: 'QQQ' is not a number; write it like 1.5 or 1.5E3"},
        {"infinity is no number", "MARKER/3, QP=1,-inf,3",
         "3:16: error: QP of MARKER/3: '-inf' is not a number; write it like 1.5 or 1.5E3"},
        {"two signs", "MARKER/3, QP=1,+-2,3",
         "3:16: error: QP of MARKER/3: '+-2' is not a number; write it like 1.5 or 1.5E3"},
        {"no digits", "MARKER/3, QP=., 2, 3",
         "3:14: error: QP of MARKER/3: '.' is not a number; write it like 1.5 or 1.5E3"},
        {"more after the number", "MARKER/3, QP=1.5.2, 2, 3",
         "3:14: error: QP of MARKER/3: '1.5.2' is not a number; write it like 1.5 or 1.5E3"},
        {"out of range", "PART/3, MASS=1e400",
         "3:14: error: MASS of PART/3: '1e400' is out of range; a number's size is 1E-307 to 1E+308"},
        {"D exponent", "MARKER/3, QP=1.0D+3,0,0",
         "3:14: error: QP of MARKER/3: '1.0D+3' has a D exponent; write E instead, for example 1.0E+3"},
        {"D exponent of an angle", "MARKER/3, REULER=0,1d2,0",
         "3:20: error: REULER of MARKER/3: '1d2' has a D exponent; write E instead, for example 1.0E+3"},
        {"degrees of a length", "MARKER/3, QP=90D,0,0",
         "3:14: error: QP of MARKER/3: '90D' is in degrees (suffix D), but this is not an angle"},
        {"empty value", "MARKER/3, QP=1,,3", "3:16: error: QP of MARKER/3: a value is empty"},
        {"no value", "MARKER/3, QP=", "3:14: error: QP of MARKER/3: a value is empty"},
        {"empty argument", "MARKER/3,,PART=1",
         "3:10: error: an argument of MARKER/3 is empty; there is a comma too many"},
        {"closing comma", "MARKER/3, PART=1,;",
         "3:17: error: MARKER/3 ends in a comma; an argument is missing"},
        {"missing comma", "JPRIM/1, ATPOINT I=1, J=2",
         "3:18: error: a comma or '=' is missing after 'ATPOINT' in JPRIM/1"},
        {"id of an argument", "JPRIM/1, ATPOINT, I=1.5, J=QQQ",
         "3:21: error: I of JPRIM/1: '1.5' is not an id; ids are whole numbers from 1\n"
         "3:28: error: J of JPRIM/1: 'QQQ' is not an id; ids are whole numbers from 1"},
        {"id out of range", "MARKER/3, PART=99999999999",
         "3:16: error: PART of MARKER/3: '99999999999' is out of range; ids go up to 2147483647"},
        {"zero is no marker here", "JPRIM/1, ATPOINT, I=1, J=0",
         "3:26: error: J of JPRIM/1: '0' is not an id; ids are whole numbers from 1"},
    });
}

TEST(DatasetErrors, AtMostTenInAStatement) {
    const Reading reading = readInModel("MARKER/3, " + std::string(100, 'Q') + std::string(99, ',') +
                                        "QQQ,QQQ,QQQ,QQQ,QQQ,QQQ,QQQ,QQQ,QQQ,QQQ,QQQ");
    EXPECT_EQ(std::count(reading.findings.begin(), reading.findings.end(), '\n'), 9);
}

TEST(DatasetErrors, UnitsAndGravity) {
    check({
        {"two of four missing", "UNITS/FORCE=NEWTON, TIME=SECOND",
         "3:1: error: UNITS needs MASS: MASS=\n3:1: error: UNITS needs LENGTH: LENGTH="},
        {"unknown unit", "UNITS/FORCE=QQQ, MASS=KIL, LENGTH=MIL, TIME=SEC",
         "3:13: error: FORCE of UNITS: 'QQQ' is unknown or ambiguous; write the unit's name in full\n"
         "3:35: error: LENGTH of UNITS: 'MIL' is unknown or ambiguous; write the unit's name in full"},
        {"unknown system", "UNITS/SYSTEM=QQQ",
         "3:14: error: SYSTEM of UNITS: 'QQQ' is not one of MKS, CGS, FPS, IPS, NONE"},
        {"both forms", "UNITS/SYSTEM=MKS, FORCE=NEWTON",
         "3:7: error: UNITS takes SYSTEM or the four units, not both"},
        {"factor", "UNITS/UCF=-1", "3:7: error: UCF of UNITS must be larger than 0"},
        {"twice", "UNITS/SYSTEM=MKS\nUNITS/SYSTEM=CGS",
         "4:1: error: UNITS is already given in line 3; it may stand once"},
        {"gravity twice", "ACCGRAV/\nACCGRAV/",
         "4:1: error: ACCGRAV is already given in line 3; it may stand once"},
        {"gravity with an id", "ACCGRAV/1", "3:9: error: unknown argument '1' of ACCGRAV"},
    });
}

TEST(DatasetErrors, Parts) {
    check({
        {"point mass that turns", "POINT_MASS/3, WX=1, EXACT=PSI, IP=1,1,1",
         "3:15: error: unknown argument 'WX' of POINT_MASS/3; did you mean VX?\n"
         "3:27: error: EXACT of POINT_MASS/3: unknown word 'PSI'\n"
         "3:32: error: unknown argument 'IP' of POINT_MASS/3"},
        {"point mass without its place", "POINT_MASS/3, MASS=1",
         "3:1: error: POINT_MASS/3 has a MASS but no mass centre; name its marker: CM="},
        {"marker of the part with the same id", "POINT_MASS/2, MASS=1, CM=2",
         "3:26: error: CM of POINT_MASS/2: MARKER/2 is on PART/2; name a marker of POINT_MASS/2"},
        {"second ground", "PART/3, GROUND",
         "3:9: error: PART/3 is a second GROUND; the first stands in line 2"},
        {"negative mass", "PART/3, CM=30, MASS=-0.5\nMARKER/30",
         "3:16: error: MASS of PART/3 is -0.5; a mass cannot be negative"},
        {"no mass centre", "PART/3, MASS=1",
         "3:1: error: PART/3 has a MASS but no mass centre; name its marker: CM="},
        {"angles and points", "PART/3, ZG=1,2,3, XG=3,2,1, REULER=1,2,3",
         "3:29: error: PART/3 takes REULER or ZG, not both\n3:29: error: PART/3 takes REULER or XG, not "
         "both"},
        {"mass centre on another part", "PART/3, MASS=1, CM=1",
         "3:20: error: CM of PART/3: MARKER/1 is on PART/1; name a marker of PART/3"},
        {"inertia marker on another part", "PART/3, IM=2",
         "3:12: error: IM of PART/3: MARKER/2 is on PART/2; name a marker of PART/3"},
        {"markers that do not exist", "PART/3, MASS=1, CM=96, IM=97, VM=98, WM=99",
         "3:20: error: CM of PART/3: there is no MARKER/96\n3:27: error: IM of PART/3: there is no "
         "MARKER/97\n"
         "3:34: error: VM of PART/3: there is no MARKER/98\n3:41: error: WM of PART/3: there is no "
         "MARKER/99"},
        {"coordinates", "PART/3, EXACT=X:QQQ:THETTA:X",
         "3:17: error: EXACT of PART/3: unknown word 'QQQ'\n"
         "3:21: error: EXACT of PART/3: unknown word 'THETTA'; did you mean THETA?\n"
         "3:28: error: EXACT of PART/3: 'X' is given twice"},
        {"no coordinate", "PART/3, EXACT=", "3:15: error: EXACT of PART/3: unknown word ''"},
    });
    EXPECT_EQ(read("t\nPART/1\nEND").findings, "3:1: error: there is no ground part; add PART/1, GROUND");
    // The misspelt part may have been meant as ground: one message is enough.
    EXPECT_EQ(read("t\nPART/1, GRUOND\nEND").findings,
              "2:9: error: unknown argument 'GRUOND' of PART/1; did you mean GROUND?");
}

TEST(DatasetErrors, Markers) {
    check({
        {"part that does not exist", "MARKER/3, PART=77",
         "3:16: error: PART of MARKER/3: there is no PART/77"},
        {"angles and points", "MARKER/3, REULER=1,2,3, ZP=1,2,3",
         "3:11: error: MARKER/3 takes REULER or ZP, not both"},
        {"no point for USEXP", "MARKER/3, USEXP, ZP=1,2,3",
         "3:11: error: USEXP of MARKER/3 needs a point on the x axis: XP="},
        {"owner of another kind", "MARKER/3, FE_PART=1",
         "3:11: error: FE_PART of MARKER/3 is not supported yet"},
        {"point mass that does not exist", "MARKER/3, POI=77",
         "3:15: error: POINT_MASS of MARKER/3: there is no POINT_MASS/77"},
        {"two owners", "POINT_MASS/1\nMARKER/3, PART=1, POINT_MASS=1",
         "4:19: error: MARKER/3 takes POINT_MASS or PART, not both"},
        {"two owners, one flexible", "POINT_MASS/1\nMARKER/3, POINT_MASS=1, FLEX_BODY=1",
         "4:11: error: MARKER/3 takes POINT_MASS or FLEX_BODY, not both\n"
         "4:35: error: FLEX_BODY of MARKER/3: there is no FLEX_BODY/1"},
        {"floating marker with a place", "MARKER/3, FLOATING, QP=1,2,3, REULER=1,2,3",
         "3:21: error: MARKER/3 takes QP or FLOATING, not both\n"
         "3:31: error: MARKER/3 takes REULER or FLOATING, not both"},
        {"floating marker named by others", "MARKER/3, FLOATING\nJPRIM/1, ATPOINT, I=3, J=1\nPART/4, VM=3",
         "4:21: error: I of JPRIM/1: MARKER/3 is FLOATING, and only JFLOAT may name such a marker\n"
         "5:12: error: VM of PART/4: MARKER/3 is FLOATING, and only JFLOAT may name such a marker"},
        {"label of nodes", "MARKER/3, NODE_LABEL=1,2,3, QP=1,2",
         "3:11: error: NODE_LABEL of MARKER/3 is not supported yet\n"
         "3:29: error: QP of MARKER/3 takes 3 numbers, not 2"},
        {"reference marker", "MARKER/3, RM=1", "3:11: error: RM of MARKER/3 is not supported yet"},
        {"curve", "MARKER/3, CURVE=1", "3:11: error: CURVE of MARKER/3 is not supported yet"},
    });
    EXPECT_EQ(read("t\nMARKER/3\nPART/1, GROUND\nEND").findings,
              "2:1: error: MARKER/3 names no body, and none precedes it; name one: PART=, POINT_MASS= or "
              "FLEX_BODY=");
}

TEST(DatasetErrors, PrimitivesAndJoints) {
    check({
        {"no I", "JPRIM/1, ATPOINT, J=1", "3:1: error: JPRIM/1 needs I: I="},
        {"nothing at all", "JPRIM/1",
         "3:1: error: JPRIM/1 needs I: I=\n3:1: error: JPRIM/1 needs J: J=\n3:1: error: JPRIM/1 needs a "
         "type: "
         "ATPOINT, INLINE, INPLANE, ORIENTATION, PARALLEL_AXES, PERPENDICULAR"},
        {"two types", "JPRIM/1, INLINE, I=1, INPLANE, J=2",
         "3:23: error: JPRIM/1 cannot be both INLINE and INPLANE"},
        {"type of a joint", "JPRIM/1, SPHERICAL, I=1, J=2",
         "3:10: error: unknown argument 'SPHERICAL' of JPRIM/1"},
        {"markers that do not exist", "JPRIM/1, ATPOINT, I=98, J=99",
         "3:21: error: I of JPRIM/1: there is no MARKER/98\n3:27: error: J of JPRIM/1: there is no "
         "MARKER/99"},
        {"same part", "MARKER/3\nJPRIM/1, ATPOINT, J=3\n, I=2",
         "5:5: error: JPRIM/1 connects PART/2 with itself; I and J must be markers of different parts"},
        {"same marker", "JOINT/1, FIXED, I=2, J=2",
         "3:24: error: JOINT/1 connects PART/2 with itself; I and J must be markers of different parts"},
        {"type of joint missing", "JOINT/1, I=1, J=2",
         "3:1: error: JOINT/1 needs a type: SPHERICAL, REVOLUTE, CYLINDRICAL, TRANSLATIONAL, PLANAR, FIXED, "
         "UNIVERSAL, HOOKE, CONVEL, SCREW, RACKPIN"},
        {"screw without pitch", "JOINT/1, SCREW, I=1, J=2, PD=1",
         "3:1: error: JOINT/1 needs PITCH: PITCH=\n"
         "3:27: error: PD of JOINT/1 is for RACKPIN joints only"},
        {"rack without diameter", "JOINT/1, RACKPIN, I=1, J=2, PITCH=1",
         "3:1: error: JOINT/1 needs PD: PD=\n3:29: error: PITCH of JOINT/1 is for SCREW joints only"},
        {"pinion of no size", "JOINT/1, RACKPIN, PD=0, I=1, J=2",
         "3:19: error: PD of JOINT/1 is 0; the pitch diameter of a pinion is not"},
        {"initial values of the wrong type",
         "JOINT/1, CYL, IC=1,2, I=1, J=2\nJOINT/2, REV, ICT=1, ICR=2, I=1, J=2",
         "3:15: error: IC of JOINT/1 is for REVOLUTE and TRANSLATIONAL joints only\n"
         "4:15: error: ICTRAN of JOINT/2 is for CYLINDRICAL joints only\n"
         "4:22: error: ICROT of JOINT/2 is for CYLINDRICAL joints only"},
        {"initial angle of a slider", "JOINT/1, TRA, IC=10D, I=1, J=2",
         "3:15: error: IC of JOINT/1 is in degrees (suffix D), but a TRANSLATIONAL joint has no angle"},
        {"three initial values", "JOINT/1, REV, IC=1,2,3, I=1, J=2",
         "3:15: error: IC of JOINT/1 takes 1 or 2 numbers, not 3"},
        {"degrees of a length", "JOINT/1, CYL, ICTRAN=1D, I=1, J=2",
         "3:22: error: ICTRAN of JOINT/1: '1D' is in degrees (suffix D), but this is not an angle"},
        {"friction", "JOINT/1, REV, I=1, J=2, MU_DYN_ROT=0.1, INNER_RADIUS=0",
         "3:36: error: MU_DYN_ROT of JOINT/1: '0.1' has an effect that is not supported yet; only 0 is "
         "accepted"},
    });
}

TEST(DatasetErrors, Requests) {
    check({
        {"nothing to write", "REQUEST/1, I=1",
         "3:1: error: REQUEST/1 needs DISPLACEMENT, VELOCITY, ACCELERATION, FORCE or expressions F1 to F8"},
        {"no I", "REQUEST/1, D, J=1", "3:1: error: REQUEST/1 needs I: I="},
        {"both forms", "REQUEST/1, FORCE, I=1, F2=1",
         "3:1: error: REQUEST/1 takes FORCE or expressions F1 to F8, not both"},
        {"two types", "REQUEST/1, D, V, I=1",
         "3:15: error: REQUEST/1 cannot be both DISPLACEMENT and VELOCITY"},
        {"markers that do not exist", "REQUEST/1, D, I=97, J=98, RM=99",
         "3:17: error: I of REQUEST/1: there is no MARKER/97\n3:23: error: J of REQUEST/1: there is no "
         "MARKER/98\n"
         "3:30: error: RM of REQUEST/1: there is no MARKER/99"},
        {"no such component", "REQUEST/1, F9=QQQ",
         "3:12: error: unknown argument 'F9' of REQUEST/1; there are F1 to F8"},
        {"open quotes", "REQUEST/1, CNAMES=\"a\", \"QQQ, F2=1",
         "3:24: error: CNAMES of REQUEST/1: the closing quote of '\"QQQ' is missing"},
        {"quotes over two lines", "REQUEST/1, F2=1, CNAMES=\"QQQ\n, QQQ\"",
         "3:25: error: CNAMES of REQUEST/1: the closing quote of '\"QQQ' is missing"},
        {"text behind quotes", "REQUEST/1, CNAMES=\"a\" QQQ, F2=1",
         "3:22: error: CNAMES of REQUEST/1: a comma is missing after '\"a\"'"},
        {"a name too many", "REQUEST/1, CUNITS=a,b,c,d,e,f,g,h,QQQ, F2=1",
         "3:12: error: CUNITS of REQUEST/1 takes at most 8 names, not 9"},
        {"comma behind a list", "REQUEST/1, F2=1, CLABELS=\"a\",",
         "3:29: error: REQUEST/1 ends in a comma; an argument is missing"},
        {"two results names", "REQUEST/1, RESULTS_NAME=a, QQQ, F2=1",
         "3:28: error: unknown argument 'QQQ' of REQUEST/1"},
        {"arguments that are not supported", "REQUEST/1, VARIABLES=1,2, ROUTINE=QQQ",
         "3:12: error: VARIABLES of REQUEST/1 is not supported yet\n"
         "3:27: error: ROUTINE of REQUEST/1 is not supported yet"},
        {"expression twice", "REQUEST/1, F2=1\\F2=2", "3:17: error: F2 of REQUEST/1 is given twice"},
        {"empty expression", "REQUEST/1, F2=\\F3=1", "3:12: error: F2 of REQUEST/1 is empty"},
        {"comma at the end", "REQUEST/1, F2=MAX(1, \\F3=2",
         "3:20: error: F2 of REQUEST/1 ends in a comma; something is missing after it"},
        {"equals sign", "REQUEST/1, F2=JOINT(1,0, C=QQQ",
         "3:27: error: '=' cannot stand in F2 of REQUEST/1; a '\\' or ')' may be missing before it"},
        {"comma", "REQUEST/1, F2=DX(1), QQQ",
         "3:20: error: ',' cannot stand in F2 of REQUEST/1; a '\\' or ')' may be missing before it"},
        {"function of the user", "REQUEST/1, FUNCTION=USER(1,2)\\ROUTINE=QQQ::QQQ",
         "3:21: error: FUNCTION of REQUEST/1 calls a user subroutine, and none can be run; write it as an "
         "expression"},
    });
}

}  // namespace
}  // namespace jprim
