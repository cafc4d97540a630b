// SPDX-License-Identifier: Apache-2.0
// FLEX_BODY, and markers on it: what is read, and what is refused.
#include "dataset/reading.h"

namespace jprim {
namespace {

constexpr const char* ClosedFormat =
    ": modes in a format of Adams cannot be read, because it is closed; let 'jprim reduce' make a file of "
    "modes from a finite-element mesh and name it: MODES_FILE=";

// What is wrong in the one statement; it stands in line 3.
std::string find(const std::string& statement) {
    return readInModel(statement).findings;
}

FlexBodyStatement readBody(const std::string& arguments) {
    return readGood("FLEX_BODY/3, MODES_FILE=rod" + arguments).flexBodies.at(0);
}

TEST(DatasetFlexBody, EveryArgument) {
    const Dataset dataset = readGood(
        "FL/003, MODES_FILE=Rods/beam-2_b.modes, QG=1,2,3, ZG=1,2,4, XG=2,2,3, VX=7, VZ=-8, WX=180D, WY=0\n"
        ", VM=1, WM=30, EXACT=X:psi:TH, CRATIO=0.02, CHAR_LEN=100, INV=t:TRU:f:F:fal:T:T:FALSE:F\n"
        "MARKER/30");
    const FlexBodyStatement& f = dataset.flexBodies.at(0);
    EXPECT_EQ(f.id, 3);
    EXPECT_EQ(f.where.line, 3);
    EXPECT_EQ(f.modesFile, "Rods/beam-2_b.modes");
    EXPECT_EQ(f.qg, (Triple{1, 2, 3}));
    EXPECT_EQ(f.zg, (Triple{1, 2, 4}));
    EXPECT_EQ(f.xg, (Triple{2, 2, 3}));
    EXPECT_EQ(f.v, (std::array<std::optional<double>, 3>{7.0, std::nullopt, -8.0}));
    EXPECT_EQ(f.w, (std::array<std::optional<double>, 3>{3.14159265358979323846, 0.0, std::nullopt}));
    EXPECT_EQ(f.vm, 1);
    EXPECT_EQ(f.wm, 30);
    EXPECT_EQ(f.exact, (std::array<bool, 6>{true, false, false, true, true, false}));
    EXPECT_EQ(f.cratio, 0.02);
    EXPECT_TRUE(f.constantCoupling);
    EXPECT_EQ(dataset.counts.built, 6);
}

TEST(DatasetFlexBody, Defaults) {
    const FlexBodyStatement f = readBody(", REULER=90D,0,1");
    EXPECT_EQ((*f.reuler)[2], 1);
    EXPECT_FALSE(f.qg || f.zg || f.xg || f.cratio || f.constantCoupling);
    EXPECT_EQ(f.vm, 0);
    EXPECT_EQ(f.wm, 0);
    EXPECT_EQ(f.exact, (std::array<bool, 6>{}));
}

TEST(DatasetFlexBody, FileNamesMayBeQuoted) {
    const std::pair<const char*, const char*> names[] = {{"\"my rod.modes\"", "my rod.modes"},
                                                         {"'Rod'", "Rod"},
                                                         {"'6\" rod'", "6\" rod"},
                                                         {"\"it's\"", "it's"},
                                                         {" ../Rod_1 ", "../Rod_1"},
                                                         {"C:\\rods\\a", "C:\\rods\\a"}};
    for (const auto& [written, name] : names)
        EXPECT_EQ(readGood("FLEX_BODY/3, MODES_FILE=" + std::string(written) + ", QG=1,2,3")
                      .flexBodies.at(0)
                      .modesFile,
                  name);
}

TEST(DatasetFlexBody, FileNamesThatAreNone) {
    const std::string rule =
        " is not a file name; one with blanks stands in quotes, one with a comma, semicolon, & or ! in double "
        "ones";
    for (const std::string name : {"", "''", "\"", "'a", "a'", "'a\"", "'a'b'", "'it's'", "a b", "a\tb"}) {
        std::string shown = name;
        std::replace(shown.begin(), shown.end(), '\t', '?');
        const std::string where = name.empty() ? "3:13" : "3:24";  // the argument, if there is no value
        EXPECT_EQ(find("FLEX_BODY/3,MODES_FILE=" + name),
                  where + ": error: MODES_FILE of FLEX_BODY/3: '" + shown + "'" + rule);
    }
    EXPECT_EQ(find("FLEX_BODY/3,MODES_FILE='a,b'"),
              "3:24: error: MODES_FILE of FLEX_BODY/3: ''a'" + rule +
                  "\n3:28: error: a comma or '=' is missing after 'b' in FLEX_BODY/3");
}

TEST(DatasetFlexBody, DampingIsANumber) {
    EXPECT_EQ(readBody(", CRATIO = 0, QG=1,2,3").cratio, 0.0);
    EXPECT_EQ(readBody(", CRATIO=1E-2\\").cratio, 0.01);
    EXPECT_EQ(readBody(", CRATIO=.5\\QG=1,2,3").qg, (Triple{1, 2, 3}));
    const std::string begin = "FLEX_BODY/3, MODES_FILE=rod, CRATIO=";
    EXPECT_EQ(
        find(begin + "STEP(FXFREQ,100,0.01,1000,0.1)\\QG=1,2,3"),
        "3:37: error: CRATIO of FLEX_BODY/3: 'STEP(FXFREQ,100,0.01,1000,0.1)' is not a number; write it "
        "like 1.5 or 1.5E3; only a number is supported here");
    EXPECT_EQ(
        find(begin + "0.01*2"),
        "3:37: error: CRATIO of FLEX_BODY/3: '0.01*2' is not a number; write it like 1.5 or 1.5E3; only "
        "a number is supported here");
    EXPECT_EQ(find(begin + "-.25"),
              "3:37: error: CRATIO of FLEX_BODY/3 is -0.25; damping cannot be negative");
    EXPECT_EQ(find(begin), "3:30: error: CRATIO of FLEX_BODY/3 is empty");
    EXPECT_EQ(
        find(begin + "0.1,0.2"),
        "3:40: error: ',' cannot stand in CRATIO of FLEX_BODY/3; a '\\' or ')' may be missing before it");
}

TEST(DatasetFlexBody, TwoPatternsOfInvariants) {
    EXPECT_FALSE(readBody(", INVARIANTS=T:T:T:T:F:T:T:T:F").constantCoupling);
    EXPECT_FALSE(readBody(", INVA=TRUE:TRUE:TRUE:TRUE:FALSE:TRUE:TRUE:TRUE:FALSE").constantCoupling);
    EXPECT_TRUE(readBody(", INVARIANTS = T : T:F:F:F:T:T:F: F ").constantCoupling);
    for (const std::string pattern :
         {"T:T:T:T:T:T:T:T:T", "F:F:F:F:F:F:F:F:F", "T:T:F:F:F:T:T:F", "T:T:F:F:F:T:T:F:F:F", "TTFFFTTFF",
          "T", "T:T:F:F:F:T:T:F:", "T:T:F:F:F:T:T:F:QQQ", "T:T:F:F:F:T:T:F:TRUEE"})
        EXPECT_EQ(find("FLEX_BODY/3, MODES_FILE=rod, INVARIANTS=" + pattern),
                  "3:41: error: INVARIANTS of FLEX_BODY/3: '" + pattern +
                      "' is not supported; write T:T:T:T:F:T:T:T:F for partial coupling or T:T:F:F:F:T:T:F:F "
                      "for constant coupling");
}

TEST(DatasetFlexBody, ModesInFormatsOfAdams) {
    for (const std::string name :
         {"MNF_FILE", "DB_FILE", "BDF_FILE", "GENSTIFF", "INVAR1", "INVAR2", "INVAR3", "INVAR4", "INVAR5",
          "INVAR6", "INVAR7", "INVAR8", "INVAR9", "T_MODE", "R_MODE", "SELNOD", "SELMOD"})
        EXPECT_EQ(find("FLEX_BODY/3, " + name + "=1, QG=1,2,3"),
                  "3:14: error: " + name + " of FLEX_BODY/3" + ClosedFormat);
    EXPECT_EQ(find("FLEX_BODY/3, MODES_FILE=rod, MNF=a.mnf, INVAR1=4"),
              "3:30: error: MNF_FILE of FLEX_BODY/3" + std::string(ClosedFormat));  // once for all
}

TEST(DatasetFlexBody, OtherMistakes) {
    EXPECT_EQ(find("FLEX_BODY/3"), "3:1: error: FLEX_BODY/3 needs MODES_FILE: MODES_FILE=");
    EXPECT_EQ(find("FLEX_BODY/3, MODEFILE=a"),
              "3:14: error: unknown argument 'MODEFILE' of FLEX_BODY/3; did you mean MODES_FILE?");
    EXPECT_EQ(find("FLEX_BODY/3, MODES_FILE=a, DMODE=1,2,3"),
              "3:28: error: DMODE of FLEX_BODY/3 is not supported yet");
    EXPECT_EQ(find("FLEX_BODY/3, MODES_FILE=a, MASS=1"),
              "3:28: error: unknown argument 'MASS' of FLEX_BODY/3");
    EXPECT_EQ(find("FLEX_BODY/3, MODES_FILE=a, REULER=1,2,3, ZG=1,2,3"),
              "3:28: error: FLEX_BODY/3 takes REULER or ZG, not both");
    EXPECT_EQ(find("FLEX_BODY/3, MODES_FILE=a, VM=98, WM=99"),
              "3:31: error: VM of FLEX_BODY/3: there is no MARKER/98\n"
              "3:38: error: WM of FLEX_BODY/3: there is no MARKER/99");
    EXPECT_EQ(find("FLEX_BODY/3, MODES_FILE=a\nFLEX_BODY/3, MODES_FILE=b"),
              "4:1: error: FLEX_BODY/3 is already given in line 3; choose another id");
}

TEST(DatasetFlexBody, MarkersOnIt) {
    const Dataset dataset = readGood(
        "MARKER/3\nFLEX_BODY/2, MODES_FILE=rod\nMARKER/4, NODE_ID=017, QP=1,2,3\nMARKER/5, PART=2\nMARKER/6\n"
        "PART/5\nMARKER/7\nMARKER/8, FLE=2, NOD=3\nMARKER/9, NODE=4, FLEX_BODY=2\nMARKER/10, FLEX=11\n"
        "FLEX_BODY/11, MODES_FILE=rod");
    const int owners[][3] = {{2, 0, 0}, {0, 2, 17}, {2, 0, 0}, {0, 2, 0},
                             {5, 0, 0}, {0, 2, 3},  {0, 2, 4}, {0, 11, 0}};
    ASSERT_EQ(dataset.markers.size(), 10u);
    for (std::size_t i = 0; i < 8; ++i) {
        const MarkerStatement& marker = dataset.markers[i + 2];
        EXPECT_EQ(marker.part, owners[i][0]) << marker.id;
        EXPECT_EQ(marker.flexBody, owners[i][1]) << marker.id;
        EXPECT_EQ(marker.node, owners[i][2]) << marker.id;
    }
    EXPECT_EQ(dataset.markers[3].qp, (Triple{1, 2, 3}));
    EXPECT_EQ(read("t\nFLEX_BODY/1, MODES_FILE=a\nMARKER/1\nPART/1, GROUND\nEND").findings, "");
}

TEST(DatasetFlexBody, MarkersThatAreWrong) {
    const std::string body = "FLEX_BODY/3, MODES_FILE=a\n";
    EXPECT_EQ(find(body + "MARKER/3, FLEX_BODY=77"),
              "4:21: error: FLEX_BODY of MARKER/3: there is no FLEX_BODY/77");
    EXPECT_EQ(find(body + "MARKER/3, PART=3"), "4:16: error: PART of MARKER/3: there is no PART/3");
    EXPECT_EQ(find(body + "MARKER/3, PART=1, FLEX_BODY=3"),
              "4:19: error: MARKER/3 takes FLEX_BODY or PART, not both");
    EXPECT_EQ(find(body + "MARKER/3, NODE_ID=1, NODE=1"),
              "4:22: error: MARKER/3 takes NODE or NODE_ID, not both");
    EXPECT_EQ(find(body + "MARKER/3, NODE_ID=1,2,3, QP=1,2,3"),
              "4:11: error: NODE_ID of MARKER/3 takes 1 node, not 3; nodes cannot be averaged yet");
    EXPECT_EQ(find(body + "MARKER/3, NODE=0"),
              "4:16: error: NODE of MARKER/3: '0' is not an id; ids are whole numbers from 1");
}

TEST(DatasetFlexBody, NodeOfARigidPartIsAWarning) {
    const Reading reading = readInModel("MARKER/3, NODE_ID=7\nMARKER/4, PART=1, NODE=8");
    EXPECT_EQ(reading.findings,
              "3:11: warning: NODE_ID of MARKER/3 has no effect: PART/2 is rigid\n"
              "4:19: warning: NODE of MARKER/4 has no effect: PART/1 is rigid");
    EXPECT_EQ(reading.dataset.markers.at(2).node, 7);
}

TEST(DatasetFlexBody, ItsIdIsNotThatOfAPart) {
    const std::string body = "FLEX_BODY/2, MODES_FILE=a\nMARKER/3\nMARKER/4\n";
    readGood(body + "JPRIM/1, ATPOINT, I=3, J=2");
    readGood(body + "FLEX_BODY/3, MODES_FILE=a\nMARKER/5\nJOINT/1, FIXED, I=5, J=3");
    EXPECT_EQ(find(body + "JPRIM/1, ATPOINT, I=3, J=4"),
              "6:26: error: JPRIM/1 connects FLEX_BODY/2 with itself; I and J must be markers of different "
              "parts");
    EXPECT_EQ(find(body + "PART/3, CM=3"),
              "6:12: error: CM of PART/3: MARKER/3 is on FLEX_BODY/2; name a marker of PART/3");
    EXPECT_EQ(find("FLEX_BODY/3, MODES_FILE=a\nMARKER/3\nPART/3, CM=3"),
              "5:12: error: CM of PART/3: MARKER/3 is on FLEX_BODY/3; name a marker of PART/3");
}

// One mistake in a body is one message, whatever stands on it.
TEST(DatasetFlexBody, MistakesDoNotSpreadToMarkers) {
    const std::string rest = "MARKER/3, NODE_ID=1\nMARKER/4, FLEX_BODY=3\nJPRIM/1, ATPOINT, I=3, J=2";
    EXPECT_EQ(find("FLEX_BODY/3, MODES_FILE=a, DMODE=1\n" + rest),
              "3:28: error: DMODE of FLEX_BODY/3 is not supported yet");
    for (const std::string keyword : {"FLEX_BODY", "PART"})
        EXPECT_EQ(find(keyword + "/QQQ\nMARKER/3\nJPRIM/1, ATPOINT, I=3, J=2"),
                  "3:" + std::to_string(keyword.size() + 2) + ": error: id of " + keyword +
                      ": 'QQQ' is not an id; ids are whole numbers from 1");
}

TEST(DatasetFlexBody, Comparison) {
    const Dataset dataset = readGood("FLEX_BODY/3, MODES_FILE=a\nMARKER/3");
    for (const char* other :
         {"FLEX_BODY/3, MODES_FILE=A\nMARKER/3", "FLEX_BODY/3, MODES_FILE=a\nMARKER/3, NODE=1",
          "FLEX_BODY/3, MODES_FILE=a\nMARKER/3, PART=2", "FLEX_BODY/3, MODES_FILE=a, CRATIO=0\nMARKER/3",
          "FLEX_BODY/3, MODES_FILE=a, QG=0,0,0\nMARKER/3",
          "FLEX_BODY/3, MODES_FILE=a, INVARIANTS=T:T:F:F:F:T:T:F:F\nMARKER/3"})
        EXPECT_NE(readGood(other), dataset) << other;
}

TEST(DatasetFlexBody, TheFolderOfTheFileIsKept) {
    const std::string folder = JPRIM_SOURCE_DIR "/tests/fuzz/corpus/read_dataset";
    Diagnostics diagnostics;
    Dataset dataset = readDatasetFile(folder + "/every_statement.adm", diagnostics);
    EXPECT_EQ(dataset.folder, folder);
    const Dataset other = dataset;
    dataset.folder.clear();
    EXPECT_EQ(dataset, other);
    EXPECT_EQ(readGood("").folder, "");
}

}  // namespace
}  // namespace jprim
