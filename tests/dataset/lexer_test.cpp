// SPDX-License-Identifier: Apache-2.0
// The rules for lines, comments, continuations and expressions.
#include "dataset/reading.h"

namespace jprim {
namespace {

// Each text says MARKER/3 on PART/1 at (1, 2, 3) in another layout.
TEST(DatasetLexer, LayoutDoesNotMatter) {
    const std::string texts[] = {
        "MARKER/3, PART=1, QP=1,2,3",
        "marker/0003,part=01,qp=1.,2.0E0,+3",
        "  MARKER / 3 , PART = 1 , QP = 1 , 2 , 3  ",
        "MARKER/3\n, PART=1\n, QP=1,2,3",
        "MARKER/3\n   , PART=1\n\t, QP=1\n, 2\n, 3",
        "MARKER/3, PART=1,\nQP=1,\n2,3",
        "MARKER/3,\n, PART=1, QP=1,\n, 2,3",
        "MARKER/3, PART=1 &\n, QP=1,2, &\n3",
        "MARKER/3, PART=1, QP=1,2&\n,3",
        "MARKER/3, PART=1, QP=1,&\n2,3",
        "MARKER/3 ! first\n! between\n\n  ! and more\n, PART=1 ! owner, QP=9,9,9\n!, USEXP\n, QP=1,2,3",
        "MARKER/3, ! first\n! between\nPART=1, QP=1,2,3 ! last",
        "MARKER/3, PART=1, QP=1,2,3;",
        ";; MARKER/3, PART=1, QP=1,2,3 ; ;",
        "MARKER/3, PART=1\n, QP=1,2,3\n;",
        "MARKER/3, PART=1\r\n, QP=1,2,3\r\n\r\n",
        "\tMARKER/3,\tPART\t=\t1\t,QP=1,2,\t3",
        "M/3, P=1, Q=1,2,3",
    };
    for (const std::string& text : texts) {
        const Dataset dataset = readGood(text);
        ASSERT_EQ(dataset.markers.size(), 3u) << text;
        const MarkerStatement& marker = dataset.markers.back();
        EXPECT_EQ(marker.id, 3) << text;
        EXPECT_EQ(marker.part, 1) << text;
        EXPECT_EQ(marker.qp, (Triple{1, 2, 3})) << text;
    }
}

TEST(DatasetLexer, FirstLineIsTheTitleWhateverItSays) {
    const Dataset dataset =
        read("ADAMS/View model name: rod ! not a comment  \r\nPART/1,GROUND\nEND").dataset;
    EXPECT_EQ(dataset.title, "ADAMS/View model name: rod ! not a comment");
    EXPECT_EQ(dataset.parts.size(), 1u);
    EXPECT_EQ(read("M/S rod\nPART/1, GROUND\nEND").findings, "");
    EXPECT_EQ(read("PART/1, GROUND\nEND\n").findings,
              "1:1: warning: the first line is the title, so 'PART/1, GROUND' is not read as a statement\n"
              "2:1: error: there is no ground part; add PART/1, GROUND");
}

TEST(DatasetLexer, NothingIsReadAfterEnd) {
    const char* const ends[] = {"END", "end", "END/", "End / ", "MARKER/1;END", "END ! of all", "END;QQQ"};
    for (const std::string end : ends)
        EXPECT_EQ(read("t\nPART/1, GROUND\n" + end + "\nQQQ/\n,,,").findings, "") << end;
    EXPECT_EQ(read("t\nPART/1, GROUND\nEND/5\nEND").findings,
              "3:1: error: END stands alone; it takes no id and no arguments");
}

TEST(DatasetLexer, MissingEndIsAWarningAtTheEndOfTheText) {
    EXPECT_EQ(read("t\nPART/1, GROUND").findings, "2:15: warning: the END statement is missing");
    EXPECT_EQ(read("t\nPART/1, GROUND\n").findings, "3:1: warning: the END statement is missing");
    EXPECT_EQ(read("").findings,
              "1:1: error: there is no ground part; add PART/1, GROUND\n"
              "1:1: warning: the END statement is missing");
}

TEST(DatasetLexer, CommaBeforeEndDoesNotSwallowIt) {
    EXPECT_EQ(read("t\nPART/1, GROUND,\nEND\nQQQ").findings,
              "2:15: error: PART/1 ends in a comma; an argument is missing");
}

TEST(DatasetLexer, SemicolonSeparatesStatementsOnALine) {
    const Dataset dataset = readGood("MARKER/3;MARKER/4, QP=1,2,3; MARKER/5\n, QP=4,5,6");
    ASSERT_EQ(dataset.markers.size(), 5u);
    EXPECT_EQ(dataset.markers[3].where.line, 3);
    EXPECT_EQ(dataset.markers[3].where.column, 10);
    EXPECT_EQ(dataset.markers[4].where.column, 30);
    EXPECT_EQ(dataset.markers[4].qp, (Triple{4, 5, 6}));
    EXPECT_EQ(readInModel("MARKER/3;\n, QP=1,2,3").findings,
              "4:1: error: a line that begins with a comma continues a statement, but none is open here");
}

TEST(DatasetLexer, ColumnsCountBytes) {
    EXPECT_EQ(readInModel("\tMARKER/3,\tQQQ").findings, "3:12: error: unknown argument 'QQQ' of MARKER/3");
    EXPECT_EQ(readInModel("REQUEST/1, D, I=1, C=\xc3\xa4, QQQ").findings,
              "3:26: error: unknown argument 'QQQ' of REQUEST/1");
}

TEST(DatasetLexer, PositionsSurviveContinuationLines) {
    EXPECT_EQ(readInModel("MARKER/3 ! one\n\n! two\n  , QP=1,\n,2,x,QQQ").findings,
              "7:4: error: QP of MARKER/3: 'x' is not a number; write it like 1.5 or 1.5E3\n"
              "7:6: error: unknown argument 'QQQ' of MARKER/3");
}

struct ExpressionCase {
    const char* name;
    const char* text;
    const char* f2;
};

TEST(DatasetLexer, ExpressionsAreKeptAsText) {
    const ExpressionCase cases[] = {
        {"one line", "F2=JOINT(1,0,2,0)", "JOINT(1,0,2,0)"},
        {"blanks become one space", "F2 =  DX(1,2)\t +   1 ", "DX(1,2) + 1"},
        {"line break with comma vanishes", "F2=-1.0*AZ(1,2)\n, - 5.0*WZ(1,2,2)",
         "-1.0*AZ(1,2) - 5.0*WZ(1,2,2)"},
        {"comma at the line's end stays", "F2=MAX(DX(1),\n, DY(1))", "MAX(DX(1), DY(1))"},
        {"ampersand", "F2=MAX(DX(1) &\n, DY(1))", "MAX(DX(1), DY(1))"},
        {"comment inside", "F2=1 ! one\n! and\n, + 2", "1 + 2"},
        {"backslash", "F2=A\\F3=B", "A"},
        {"backslash and comma", "F2=A\\, F3=B", "A"},
        {"backslash, line break, comma", "F2=A\\\n, F3=B", "A"},
        {"backslash at the end", "F2=A\\", "A"},
        {"comment follows without backslash", "F2=JOINT(1,0,2,0),C=a b", "JOINT(1,0,2,0)"},
        {"the same on the next line", "F2=JOINT(1,0,2,0)\n, C = a b", "JOINT(1,0,2,0)"},
        {"vector", "F2=[1,2,3]*[4,5,6]", "[1,2,3]*[4,5,6]"},
    };
    for (const ExpressionCase& c : cases) {
        const Dataset dataset = readGood(std::string("REQUEST/1, ") + c.text);
        ASSERT_EQ(dataset.requests.size(), 1u) << c.name;
        EXPECT_EQ(dataset.requests[0].expressions[0].first, 2) << c.name;
        EXPECT_EQ(dataset.requests[0].expressions[0].second.text, c.f2) << c.name;
    }
}

// Where the file says each character, whatever was left out before it.
TEST(DatasetLexer, ExpressionsRememberTheirPlaces) {
    const Dataset dataset = readGood(
        "REQUEST/1, F2=DX(1,2)  *\t 3 ! comment\n"
        "! comment, and a blank line\n\n"
        "  , + MAX(DY(1), &\n"
        "     DZ(2))\\  F3 =  7");
    const ExpressionText& f2 = dataset.requests.at(0).expressions.at(0).second;
    ASSERT_EQ(f2.text, "DX(1,2) * 3 + MAX(DY(1), DZ(2))");
    const auto getPlace = [](const ExpressionText& e, std::size_t offset) {
        const SourcePosition where = e.getPosition(offset);
        return std::make_pair(where.line, where.column);
    };
    EXPECT_EQ(getPlace(f2, f2.text.find("DX")), std::make_pair(3, 15));
    EXPECT_EQ(getPlace(f2, f2.text.find("2)")), std::make_pair(3, 20));
    EXPECT_EQ(getPlace(f2, f2.text.find('*')), std::make_pair(3, 24));
    EXPECT_EQ(getPlace(f2, f2.text.find('3')), std::make_pair(3, 27));
    EXPECT_EQ(getPlace(f2, f2.text.find('+')), std::make_pair(6, 5));
    EXPECT_EQ(getPlace(f2, f2.text.find("DY")), std::make_pair(6, 11));
    EXPECT_EQ(getPlace(f2, f2.text.find("DZ") + 3), std::make_pair(7, 9));
    EXPECT_EQ(getPlace(f2, f2.text.size()), std::make_pair(7, 12));
    const ExpressionText& f3 = dataset.requests.at(0).expressions.at(1).second;
    EXPECT_EQ(getPlace(f3, 0), std::make_pair(7, 21));
    EXPECT_EQ(getPlace(ExpressionText{"TIME", {}}, 2), std::make_pair(0, 0));
}

TEST(DatasetLexer, ArgumentsAfterAnExpression) {
    const Dataset dataset =
        readGood("REQUEST/05, F2=JOINT(1,0,2,0)\\F3=DX(1)\n, +1\\\n, F8=JOINT(1,0,8,0),C=load: X (N)");
    ASSERT_EQ(dataset.requests.size(), 1u);
    const RequestStatement& request = dataset.requests[0];
    EXPECT_EQ(request.comment, "load: X (N)");
    ASSERT_EQ(request.expressions.size(), 3u);
    EXPECT_EQ(request.expressions[1].first, 3);
    EXPECT_EQ(request.expressions[1].second.text, "DX(1) +1");
    EXPECT_EQ(request.expressions[2].first, 8);
    EXPECT_EQ(request.expressions[2].second.text, "JOINT(1,0,8,0)");
}

TEST(DatasetLexer, NumbersInAllForms) {
    const Dataset dataset = readGood(
        "MARKER/3, QP=2.07E+005,.5,5\nMARKER/4, QP=1e4,-.5,+5.\nMARKER/5, REULER=180D, -90d, 1.5\n"
        "MARKER/6, QP=1E-3, -0, 00012");
    const double pi = 3.14159265358979323846;
    EXPECT_EQ(dataset.markers[2].qp, (Triple{207000, 0.5, 5}));
    EXPECT_EQ(dataset.markers[3].qp, (Triple{1e4, -0.5, 5}));
    EXPECT_EQ(dataset.markers[4].reuler, (Triple{pi, -pi / 2, 1.5}));
    EXPECT_EQ(dataset.markers[5].qp, (Triple{1e-3, 0, 12}));
}

TEST(DatasetLexer, StrangeBytesAreReportedNotObeyed) {
    EXPECT_EQ(readInModel(std::string("MARKER/3, QP=1,\0,2", 18)).findings,
              "3:16: error: QP of MARKER/3: '?' is not a number; write it like 1.5 or 1.5E3");
    EXPECT_EQ(readInModel("MARKER/3, \xe4").findings, "3:11: error: '?' is not an argument of MARKER/3");
    EXPECT_EQ(readInModel(std::string(50, 'Q')).findings,
              "3:51: error: a slash is missing after 'QQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQ...'");
}

}  // namespace
}  // namespace jprim
