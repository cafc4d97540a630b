// SPDX-License-Identifier: Apache-2.0
// What each statement and each of its arguments becomes.
#include "dataset/reading.h"
#include "dataset/statement_kind.h"

namespace jprim {
namespace {

TEST(DatasetReader, Units) {
    const UnitsStatement units =
        *readGood("UNITS/\n, FORCE=NEWTON, LENGTH=millim\n, TIME=SEC, MASS=KIL").units;
    EXPECT_EQ(units.names, (std::array<std::string, 4>{"NEWTON", "KILOGRAM", "MILLIMETER", "SECOND"}));
    EXPECT_EQ(units.system, "");
    EXPECT_EQ(units.toSI.force, 1);
    EXPECT_EQ(units.toSI.mass, 1);
    EXPECT_EQ(units.toSI.length, 1e-3);
    EXPECT_EQ(units.toSI.time, 1);
    EXPECT_FALSE(units.ucf);
    EXPECT_EQ(units.where.line, 3);
}

TEST(DatasetReader, UnitsBySystemOrConsistencyFactor) {
    const UnitsStatement cgs = *readGood("UNITS/SYSTEM=cgs, UCF=2").units;
    EXPECT_EQ(cgs.system, "CGS");
    EXPECT_EQ(cgs.names[0], "");
    EXPECT_EQ(cgs.toSI.force, 1e-5);
    EXPECT_EQ(cgs.ucf, 2.0);
    const UnitsStatement plain = *readGood("UNI/UCF=1000").units;
    EXPECT_EQ(plain.ucf, 1000.0);
    EXPECT_EQ(plain.toSI.length, 1);
    EXPECT_FALSE(readGood("").units);
}

TEST(DatasetReader, Accgrav) {
    EXPECT_EQ(readGood("ACCGRAV/KGRAV=-9.81, IGRAV = 1").gravity->acceleration, (Triple{1, 0, -9.81}));
    EXPECT_EQ(readGood("ACC/\n, J=-9806.65").gravity->acceleration, (Triple{0, -9806.65, 0}));
    EXPECT_FALSE(readGood("").gravity);
}

TEST(DatasetReader, PartWithEveryArgument) {
    const Dataset dataset = readGood(
        "PART/3, QG=1,2,3, ZG=1,2,4, XG=2,2,3, MASS=0.5, CM=30, IM=31, IP=1,2,3,4,5,6\n"
        ", VX=7, VZ=-8, WX=180D, WY=0, VM=1, WM=2, EXACT=X:psi:TH, MATERIAL=STEEL\n"
        "MARKER/30\nMARKER/31");
    const PartStatement& p = dataset.parts[2];
    EXPECT_EQ(p.id, 3);
    EXPECT_FALSE(p.ground);
    EXPECT_EQ(p.qg, (Triple{1, 2, 3}));
    EXPECT_EQ(p.zg, (Triple{1, 2, 4}));
    EXPECT_EQ(p.xg, (Triple{2, 2, 3}));
    EXPECT_EQ(p.mass, 0.5);
    EXPECT_EQ(p.cm, 30);
    EXPECT_EQ(p.im, 31);
    EXPECT_EQ(p.ip, (std::array<double, 6>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(p.v[0], 7.0);
    EXPECT_FALSE(p.v[1]);  // not written is not the same as 0
    EXPECT_EQ(p.v[2], -8.0);
    EXPECT_EQ(p.w[0], 3.14159265358979323846);
    EXPECT_EQ(p.w[1], 0.0);
    EXPECT_FALSE(p.w[2]);
    EXPECT_EQ(p.vm, 1);
    EXPECT_EQ(p.wm, 2);
    EXPECT_EQ(p.exact, (std::array<bool, 6>{true, false, false, true, true, false}));
}

TEST(DatasetReader, PartDefaults) {
    const Dataset dataset = readGood("PART/3, REULER=90D,0,1, IP=1,2,3");
    EXPECT_TRUE(dataset.parts[0].ground);
    EXPECT_FALSE(dataset.parts[1].qg || dataset.parts[1].reuler || dataset.parts[1].mass ||
                 dataset.parts[1].ip);
    EXPECT_EQ(dataset.parts[2].ip, (std::array<double, 6>{1, 2, 3, 0, 0, 0}));
    EXPECT_EQ((*dataset.parts[2].reuler)[2], 1);
}

TEST(DatasetReader, MarkerBelongsToTheNearestPrecedingPart) {
    const Dataset dataset = readGood("MARKER/3\nPART/4\nMARKER/5\nMARKER/6, PART=1\nMARKER/7");
    EXPECT_EQ(dataset.markers[2].part, 2);
    EXPECT_EQ(dataset.markers[3].part, 4);
    EXPECT_EQ(dataset.markers[4].part, 1);
    EXPECT_EQ(dataset.markers[5].part, 4);
}

TEST(DatasetReader, MarkerWithEveryArgument) {
    const Dataset dataset = readGood("MARKER/3, USEXP, ZP=1,2,3, XP=4,5,6\nMARKER/4, REULER=1,2,3, QP=7,8,9");
    EXPECT_EQ(dataset.markers[2].zp, (Triple{1, 2, 3}));
    EXPECT_EQ(dataset.markers[2].xp, (Triple{4, 5, 6}));
    EXPECT_TRUE(dataset.markers[2].usexp);
    EXPECT_FALSE(dataset.markers[2].qp || dataset.markers[2].reuler);
    EXPECT_EQ(dataset.markers[3].reuler, (Triple{1, 2, 3}));
    EXPECT_EQ(dataset.markers[3].qp, (Triple{7, 8, 9}));
}

// A type may be written in full or in any length down to the shortest that is not ambiguous.
template <class Type>
void checkType(const char* keyword, const std::string& shortest, Type type,
               std::vector<Type> (*get)(const Dataset&)) {
    const std::string full = getAdamsName(type);
    ASSERT_EQ(full.substr(0, shortest.size()), shortest);
    for (std::size_t length = shortest.size(); length <= full.size(); ++length) {
        const std::string text = std::string(keyword) + "/1, " + full.substr(0, length) + ", J=1, I=2";
        EXPECT_EQ(get(readGood(text)), std::vector<Type>{type}) << text;
    }
}

TEST(DatasetReader, EveryJprimType) {
    const auto get = [](const Dataset& d) {
        EXPECT_EQ(d.jprims.at(0).i, 2);
        EXPECT_EQ(d.jprims.at(0).j, 1);
        return std::vector<JprimType>{d.jprims.at(0).type};
    };
    checkType<JprimType>("JPRIM", "A", JprimType::AtPoint, get);
    checkType<JprimType>("JPRIM", "INL", JprimType::InLine, get);
    checkType<JprimType>("JPRIM", "INP", JprimType::InPlane, get);
    checkType<JprimType>("JPRIM", "O", JprimType::Orientation, get);
    checkType<JprimType>("JP", "PA", JprimType::ParallelAxes, get);
    checkType<JprimType>("jp", "PE", JprimType::Perpendicular, get);
}

TEST(DatasetReader, EveryJointType) {
    const auto get = [](const Dataset& d) {
        EXPECT_EQ(d.joints.at(0).i, 2);
        EXPECT_EQ(d.joints.at(0).j, 1);
        return std::vector<JointType>{d.joints.at(0).type};
    };
    checkType<JointType>("JOINT", "SP", JointType::Spherical, get);
    checkType<JointType>("JOINT", "RE", JointType::Revolute, get);
    checkType<JointType>("JOINT", "C", JointType::Cylindrical, get);
    checkType<JointType>("JOINT", "T", JointType::Translational, get);
    checkType<JointType>("JOINT", "PL", JointType::Planar, get);
    checkType<JointType>("JOINT", "F", JointType::Fixed, get);
    checkType<JointType>("J", "U", JointType::Universal, get);
    checkType<JointType>("j", "H", JointType::Hooke, get);
    checkType<JointType>("J", "CO", JointType::Convel, get);
}

// The form with leading zeros that the documentation uses for JPRIM.
TEST(DatasetReader, LeadingZerosMeanNothing) {
    const Dataset dataset =
        readGood("MARKER/0140, PART=01\nMARKER/0240, PART=02\nJPRIM/0102, INLINE, I=0140, J=0240");
    ASSERT_EQ(dataset.jprims.size(), 1u);
    EXPECT_EQ(dataset.jprims[0].id, 102);
    EXPECT_EQ(dataset.jprims[0].i, 140);
    EXPECT_EQ(dataset.jprims[0].j, 240);
}

TEST(DatasetReader, JointAcceptsFrictionOfSizeZero) {
    const Dataset dataset = readGood(
        "JOINT/1, REVOLUTE, I=1, J=2, DELTA_V=0.0, MU_DYN_ROT=0, MU_STAT_ROT=0, INNER_RADIUS=0.0\n"
        ", OUTER_RADIUS=-0, MAX_FRIC_ROT=0E5, PRELOAD_RADIAL=0, PRELOAD_AXIAL=0");
    EXPECT_EQ(dataset.joints.size(), 1u);
}

TEST(DatasetReader, Requests) {
    const Dataset dataset = readGood(
        "REQUEST/1, D, I=1, J=2, RM=1, C=DISPLACEMENT: X Y Z (body-fixed)\nREQUEST/2, VELOCITY, I=1, J=0, "
        "RM=0\n"
        "REQ/03, A, TITLE = a:b , I=2\nR/4, COMMENT=, F, I=1, RESULTS_NAME=x, CNAMES=a:b, CUNITS=m:m");
    ASSERT_EQ(dataset.requests.size(), 4u);
    EXPECT_EQ(dataset.requests[0].type, RequestType::Displacement);
    EXPECT_EQ(dataset.requests[0].i, 1);
    EXPECT_EQ(dataset.requests[0].j, 2);
    EXPECT_EQ(dataset.requests[0].rm, 1);
    EXPECT_EQ(dataset.requests[0].comment, "DISPLACEMENT: X Y Z (body-fixed)");
    EXPECT_EQ(dataset.requests[1].type, RequestType::Velocity);
    EXPECT_EQ(dataset.requests[1].j, 0);
    EXPECT_EQ(dataset.requests[2].type, RequestType::Acceleration);
    EXPECT_EQ(dataset.requests[2].title, "a:b");
    EXPECT_EQ(dataset.requests[3].type, RequestType::Force);
    EXPECT_EQ(dataset.requests[3].comment, "");
}

TEST(DatasetReader, IgnoredStatementsAreKeptAsText) {
    const Dataset dataset = readGood(
        "MATERIAL/012\n, NAME=steel ! seen only\n, X = 1,   Y=2\nOUTPUT/REQSAVE\n, GRSAVE\nRES/\nST/13");
    ASSERT_EQ(dataset.ignored.size(), 4u);
    EXPECT_EQ(dataset.ignored[0].keyword, "MATERIAL");
    EXPECT_EQ(dataset.ignored[0].id, 12);
    EXPECT_EQ(dataset.ignored[0].arguments, "NAME=steel, X = 1, Y=2");
    EXPECT_EQ(dataset.ignored[1].keyword, "OUTPUT");
    EXPECT_EQ(dataset.ignored[1].arguments, "REQSAVE, GRSAVE");
    EXPECT_EQ(dataset.ignored[2].keyword, "RESULTS");
    EXPECT_EQ(dataset.counts.built, 4);
    EXPECT_EQ(dataset.counts.ignored, 4);
    EXPECT_EQ(dataset.counts.errors, 0);
}

TEST(DatasetReader, IdsAreUniquePerKindOnly) {
    readGood("JPRIM/1, ATPOINT, I=1, J=2\nJOINT/1, FIXED, I=1, J=2\nMATERIAL/1");
}

TEST(DatasetReader, ReferencesMayComeFirst) {
    readGood("JPRIM/1, ATPOINT, I=30, J=1\nMARKER/30, PART=3\nPART/3, MASS=1, CM=31\nMARKER/31");
}

TEST(DatasetReader, OneStatementWithErrorsCountsOnce) {
    const Dataset dataset = readInModel("MARKER/3, QQQ, QQQ\nMATERIAL/1\nJPRIM/1, ATPOINT, I=8, J=9").dataset;
    EXPECT_EQ(dataset.counts.built, 4);
    EXPECT_EQ(dataset.counts.ignored, 1);
    EXPECT_EQ(dataset.counts.errors, 2);
}

TEST(DatasetVocabulary, EveryStatementHasItsOwnShortestForm) {
    for (const StatementKind& rule : getStatementKinds()) {
        const WordMatch match = findWord(getStatementKinds(), rule.name.substr(0, rule.minimum));
        ASSERT_TRUE(match.found) << rule.name;
        EXPECT_EQ(getStatementKinds()[match.index].name, rule.name);
    }
}

TEST(DatasetReader, FileThatCannotBeReadIsOneError) {
    Diagnostics diagnostics;
    const Dataset dataset = readDatasetFile(JPRIM_SOURCE_DIR "/QQQ.adm", diagnostics);
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(formatDiagnostic("QQQ.adm", diagnostics[0]),
              "QQQ.adm: error: cannot read the file; check its name and permissions");
    EXPECT_TRUE(dataset.parts.empty());
    EXPECT_EQ((readDatasetFile(JPRIM_SOURCE_DIR, diagnostics), diagnostics.size()), 2u);  // a folder
}

}  // namespace
}  // namespace jprim
