// SPDX-License-Identifier: Apache-2.0
// What `jprim check` says, to people and to machines.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tool/tool_fixture.h"

namespace {

using jprim::testing::Outcome;
using jprim::testing::Tool;
using Json = nlohmann::json;

const std::string Pendulum =
    "pendulum\nUNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=SECOND\nACCGRAV/KGRAV=-9806.65\n"
    "PART/1,GROUND\nMARKER/10,REULER=180D,90D,180D\n"
    "PART/2,MASS=1,CM=20,IP=4E4,1E5,1E5\nMARKER/20,QP=2000,0,0\nMARKER/21,REULER=180D,90D,180D\n"
    "JOINT/1,REVOLUTE,I=10,J=21\nREQUEST/7,DISPLACEMENT,I=20\nEND\n";

// Links of 1, 2 and 1 m, lying flat along a base; the coupler is drawn too high by some mm.
std::string makeFourBar(double base, double tooHigh) {
    return "four-bar\nUNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=SECOND\n"
           "PART/1,GROUND\nMARKER/10\nMARKER/11,QP=" +
           std::to_string(base) +
           ",0,0\n"
           "PART/2,MASS=1,CM=20,IP=4E4,1E5,1E5\nMARKER/20,QP=500,0,0\nMARKER/21\nMARKER/22,QP=1000,0,0\n"
           "PART/3,MASS=1,CM=30,IP=4E4,1E5,1E5,QG=1000," +
           std::to_string(tooHigh) +
           ",0\n"
           "MARKER/30,QP=1000,0,0\nMARKER/31\nMARKER/32,QP=2000,0,0\n"
           "PART/4,MASS=1,CM=40,IP=4E4,1E5,1E5,QG=2000,0,0\n"
           "MARKER/40,QP=500,0,0\nMARKER/41\nMARKER/42,QP=1000,0,0\n"
           "JPRIM/1,ATPOINT,I=21,J=10\nJPRIM/2,PARALLEL_AXES,I=21,J=10\nJOINT/2,REVOLUTE,I=31,J=22\n"
           "JOINT/3,REVOLUTE,I=42,J=32\nJOINT/4,REVOLUTE,I=41,J=11\nEND\n";
}

void expectLines(const std::string& text, const std::vector<std::string>& lines) {
    for (const std::string& line : lines)
        EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
}

TEST_F(Tool, CheckCounts) {
    const Outcome text = run("check " + write("p.adm", Pendulum));
    EXPECT_EQ(text.exitCode, 0);
    EXPECT_NE(text.out.find("degrees of freedom      1\n"), std::string::npos) << text.out;
    const nlohmann::json json = nlohmann::json::parse(run("check --json " + write("p.adm", Pendulum)).out);
    EXPECT_EQ(json["usable"], true);
    EXPECT_EQ(json["gruebler_count"], 1);
    EXPECT_EQ(json["degrees_of_freedom"], 1);
    EXPECT_EQ(json["redundant_equations"], 0);
    EXPECT_EQ(json["statements"]["built"], 9);
    EXPECT_EQ(json["moved"].size(), 0u);
}

// The second hinge's place is rounded to six decimals, 3e-7 m off the first one's axis: no conflict.
TEST_F(Tool, CheckTakesRoundedDoublesForRedundant) {
    const std::string lid =
        "lid\nPART/1,GROUND\nMARKER/1,REULER=0.4,0.7,0.3\nMARKER/2,QP=0.250870,-0.593364,0.764842,"
        "REULER=0.4,0.7,0.3\nPART/2,MASS=10,CM=20,IP=1,2,3,REULER=0.4,0.7,0.3\nMARKER/20,QP=0.3,-0.2,0.5\n"
        "MARKER/21\nMARKER/22,QP=0,0,1\nJOINT/1,REVOLUTE,I=21,J=1\nJOINT/2,REVOLUTE,I=22,J=2\nEND\n";
    const Outcome text = run("check " + write("lid.adm", lid));
    EXPECT_EQ(text.exitCode, 0);
    EXPECT_EQ(text.err, "");
    expectLines(text.out, {"degrees of freedom      1\n", "redundant equations     5\n",
                           "follows from        JOINT/1 REVOLUTE: translation of I along Zj\n",
                           "constraint error after   3.07e-07 ", " rad (at JOINT/2)\n"});
}

TEST_F(Tool, CheckCountsRedundantEquations) {
    // A second hinge on the same axis repeats all five equations.
    const std::string twice = Pendulum.substr(0, Pendulum.size() - 4) + "JOINT/2,REVOLUTE,I=10,J=21\nEND\n";
    const nlohmann::json json = nlohmann::json::parse(run("check --json " + write("p.adm", twice)).out);
    EXPECT_EQ(json["gruebler_count"], -4);
    EXPECT_EQ(json["degrees_of_freedom"], 1);
    EXPECT_EQ(json["redundant_equations"], 5);
}

TEST_F(Tool, CheckNamesRedundantEquations) {
    const Outcome text = run("check " + write("fb.adm", makeFourBar(2000, 10)));
    EXPECT_EQ(text.exitCode, 0) << text.err;
    expectLines(
        text.out,
        {"JOINT                   3 (3 REVOLUTE)\n",
         "JPRIM                   2 (1 ATPOINT, 1 PARALLEL_AXES)\n", "equations               20\n",
         "Gruebler count          -2\n", "degrees of freedom      1\n", "redundant equations     3\n",
         "rank decided between    ", "redundant               JOINT/4 REVOLUTE: translation of I along Zj\n",
         "redundant               JOINT/4 REVOLUTE: rotation between Zi and Xj\n"
         "    follows from        JPRIM/2 PARALLEL_AXES: rotation between Zi and Xj\n"
         "                        JOINT/2 REVOLUTE: ",
         "constraint error given   10 MILLIMETER, 0 rad (at JOINT/2)\n", "constraint error after   ",
         "moved by assembly       PART/3 by "});
    EXPECT_EQ(text.out.find("singular"), std::string::npos);
    EXPECT_EQ(text.out.find("only here"), std::string::npos);

    const Json json = Json::parse(run("check --json " + write("fb.adm", makeFourBar(2000, 10))).out);
    EXPECT_EQ(json["elements"]["JPRIM"]["ATPOINT"], 1);
    EXPECT_EQ(json["elements"]["JOINT"]["REVOLUTE"], 3);
    EXPECT_EQ(json["singular_position"], false);
    ASSERT_EQ(json["redundant"].size(), 3u);
    const Json& first = json["redundant"][0];
    EXPECT_EQ(first["element"], "JOINT/4 REVOLUTE");
    EXPECT_EQ(first["equation"], "translation of I along Zj");
    EXPECT_EQ(first["level"], "holonomic");
    EXPECT_EQ(first["only_here"], false);
    EXPECT_EQ(first["follows_from"][0]["element"], "JPRIM/1 ATPOINT");
    EXPECT_EQ(json["moved"].size(), 3u);
}

// The counts are those of all joints, whichever of them are in the tree.
TEST_F(Tool, CheckPrintsTheTree) {
    const std::string model = write("fb.adm", makeFourBar(2000, 10));
    expectLines(run("check " + model).out,
                {"tree                    PART/2 on PART/1 by Pin: JPRIM/1, JPRIM/2\n"
                 "                        PART/3 on PART/2 by Pin: JOINT/2\n"
                 "                        PART/4 on PART/1 by Pin: JOINT/4\n"
                 "loops and other joints  JOINT/3 REVOLUTE\n"});
    const Json json = Json::parse(run("check --json " + model).out);
    EXPECT_EQ(
        json["tree"][1],
        Json({{"part", "PART/3"}, {"parent", "PART/2"}, {"mobilizer", "Pin"}, {"elements", {"JOINT/2"}}}));
    EXPECT_EQ(json["solved_as_equations"], Json({"JOINT/3 REVOLUTE"}));
    EXPECT_EQ(json["redundant_equations"], 3);

    const Json constraints = Json::parse(run("check --json --formulation constraints " + model).out);
    EXPECT_FALSE(constraints.contains("tree"));
    EXPECT_EQ(constraints["equations"], json["equations"]);
    EXPECT_EQ(run("check --formulation both " + model).exitCode, 2);
}

TEST_F(Tool, CheckTellsASingularPosition) {
    const std::string model = write("flat.adm", makeFourBar(2000, 0));
    const Outcome text = run("check " + model);
    EXPECT_EQ(text.exitCode, 0);
    expectLines(text.out, {"degrees of freedom      2\n", "redundant equations     4\n",
                           "singular position       degrees of freedom nearby: 1\n",
                           "redundant only here     JOINT/4 REVOLUTE: translation of I along Xj\n"});
    const Json json = Json::parse(run("check --json " + model).out);
    EXPECT_EQ(json["singular_position"], true);
    EXPECT_EQ(json["degrees_of_freedom_nearby"], 1);
    EXPECT_EQ(json["redundant"][3]["only_here"], true);
}

// A base of 5 m leaves links of 4 m a gap of 1 m.
TEST_F(Tool, CheckNamesWhatIsInConflict) {
    const std::string model = write("long.adm", makeFourBar(5000, 0));
    const Outcome text = run("check " + model);
    EXPECT_EQ(text.exitCode, 3);
    EXPECT_NE(text.err.find("the parts cannot be assembled"), std::string::npos) << text.err;
    expectLines(
        text.out,
        {"Gruebler count          -2\n", "constraint error given   3e+03 MILLIMETER, 0 rad (at JOINT/4)\n",
         "constraint error least   ", "conflict                4 equations cannot be met together",
         "JOINT/2 REVOLUTE: translation of I along Xj: "});
    EXPECT_EQ(text.out.find("degrees of freedom"), std::string::npos);

    const Json json = Json::parse(run("check --json " + model).out);
    EXPECT_EQ(json["usable"], false);
    ASSERT_EQ(json["conflicts"].size(), 1u);
    double gap = 0;
    std::string elements;
    for (const Json& equation : json["conflicts"][0]) {
        gap += std::abs(double(equation["error"]));
        elements += std::string(equation["element"]) + ";";
        EXPECT_EQ(equation["unit"], "length");
    }
    constexpr double Converged = 1e-3;  // mm
    EXPECT_NEAR(gap, 1000, Converged);
    EXPECT_EQ(elements, "JPRIM/1 ATPOINT;JOINT/2 REVOLUTE;JOINT/3 REVOLUTE;JOINT/4 REVOLUTE;");
    EXPECT_EQ(json["flipped"].size(), 0u);
}

// What EXACT holds is not a conflict of equations, but with them.
TEST_F(Tool, CheckSaysWhenOnlyExactIsInTheWay) {
    std::string held = makeFourBar(2000, 10);
    for (const char* part : {"QG=1000,10.000000,0", "QG=2000,0,0"})
        held.insert(held.find(part) + std::string(part).size(), ",EXACT=X:Y:Z:PSI:THETA:PHI");
    const Outcome text = run("check " + write("held.adm", held));
    EXPECT_EQ(text.exitCode, 3);
    EXPECT_NE(text.err.find("the EXACT coordinates of PART/3"), std::string::npos) << text.err;
    expectLines(text.out,
                {"conflict                given coordinates contradict the constraints or each other; "
                 "missed are\n",
                 "PART/"});
    EXPECT_NE(text.out.find(" EXACT "), std::string::npos) << text.out;
    EXPECT_EQ(text.out.find("no conflict"), std::string::npos);
}

// EXACT yields to a MOTION, with a warning from both commands.
TEST_F(Tool, WarnsOfExactThatYields) {
    const std::string model =
        write("exact.adm",
              "arm\nPART/1,GROUND\nMARKER/1\nPART/2,MASS=4,CM=20,IP=1,1,1,EXACT=X:Y:Z:PSI\n"
              "MARKER/20,QP=0.7,0,0\nMARKER/21\nJOINT/1,REVOLUTE,I=21,J=1\n"
              "MOTION/1,JOINT=1,FUNCTION=30D\nEND\n");
    for (const std::string& command : {"check " + model, "run " + model + " --end 0.1 --steps 1 --quiet"}) {
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_NE(
            outcome.err.find("warning: PART/2: EXACT PSI contradicts a MOTION, an initial value or a joint "
                             "and yields to it: it starts 0.524 rad away from its given value"),
            std::string::npos)
            << outcome.err;
    }
}

// What check says is what run does.
TEST_F(Tool, CheckNamesAnInitialValueThatIsMissed) {
    const std::string model = write("ic.adm",
                                    "arm\nPART/1,GROUND\nMARKER/1\nPART/2,MASS=4,CM=20,IP=1,1,1\n"
                                    "MARKER/20,QP=0.7,0,0\nMARKER/21\nJOINT/1,REVOLUTE,I=21,J=1,IC=0.1\n"
                                    "MOTION/1,JOINT=1,FUNCTION=0.4\nEND\n");
    const Outcome outcome = run("check " + model);
    EXPECT_EQ(outcome.exitCode, 3);
    expectLines(outcome.out, {"JOINT/1 initial value: 0.3 rad\n"});
    EXPECT_EQ(run("run " + model + " --end 1").exitCode, 1);
    const Json json = Json::parse(run("check --json " + model).out);
    EXPECT_EQ(json["missed"][0]["element"], "JOINT/1");
    EXPECT_NEAR(double(json["missed"][0]["amount"]), 0.3, 1e-6);
}

}  // namespace
