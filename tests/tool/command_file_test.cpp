// SPDX-License-Identifier: Apache-2.0
// Command files and equilibrium, as a user runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tool/tool_fixture.h"

namespace jprim::testing {
namespace {

const char* const Pendulum =
    "pendulum\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\n"
    "MARKER/20,QP=0.5,0,0\nMARKER/21\nJOINT/1,REVOLUTE,I=21,J=10\nREQUEST/1,F2=AZ(21,10)\nEND\n";

size_t countLines(const std::string& text) {
    return size_t(std::count(text.begin(), text.end(), '\n'));
}

TEST_F(Tool, CommandFilesRunAndWriteOneSetOfFiles) {
    write("model.adm", Pendulum);
    const std::string commands = write("model.acf",
                                       "model\nresults\nSIMULATE/DYNAMICS, END=0.2, STEPS=2\n"
                                       "SIMULATE/DYNAMICS, DURATION=0.2, DTOUT=0.1\nSTOP\n");
    const Outcome outcome = run("run " + commands + " --out " + (m_folder / "o").string());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("SIMULATE/DYNAMICS from 0.2 to 0.4"), std::string::npos) << outcome.out;
    EXPECT_EQ(countLines(readFile(m_folder / "o" / "requests.csv")), 1u + 5u);
}

std::vector<double> readTimes(const fs::path& table) {
    std::istringstream lines(readFile(table));
    std::vector<double> times;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) times.push_back(std::stod(line));
    return times;
}

// A first run that is shorter than its output step, as Adams/View writes it.
TEST_F(Tool, OutputStepsNeedNotDivideARun) {
    const std::string model = write("model.adm", Pendulum), out = (m_folder / "o").string();
    const std::string commands = write("model.acf",
                                       "model\nresults\nSIMULATE/DYNAMICS, END=4.0E-03, DTOUT=5.0E-02\n"
                                       "SIMULATE/DYNAMICS, END=0.13, DTOUT=5.0E-02\nSTOP\n");
    EXPECT_EQ(run("run " + commands + " --quiet --out " + out).exitCode, 0);
    const std::vector<double> expected = {0, 0.004, 0.054, 0.104, 0.13};
    const std::vector<double> written = readTimes(m_folder / "o" / "requests.csv");
    ASSERT_EQ(written.size(), expected.size());
    for (size_t k = 0; k < written.size(); ++k) EXPECT_DOUBLE_EQ(written[k], expected[k]);
    EXPECT_EQ(run("run " + model + " --end 1 --dtout 0.3 --quiet --out " + out).exitCode, 0);
    const std::vector<double> times = readTimes(m_folder / "o" / "requests.csv");
    ASSERT_EQ(times.size(), 5u);
    EXPECT_DOUBLE_EQ(times[3], 0.9);
    EXPECT_EQ(times[4], 1);
}

TEST_F(Tool, RequestsAreCalledByTheirNames) {
    std::string named = Pendulum;
    named.replace(named.find("REQUEST/1,"), 10,
                  "REQUEST/1\n, CNAMES = \"\", \"swing, or turn\"\n, RESULTS_NAME = arm\n, ");
    const Outcome outcome = run("run " + write("named.adm", named) + " --end 0.1 --steps 1 --quiet --out " +
                                (m_folder / "o").string());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string text = readFile(m_folder / "o" / "requests.csv");
    EXPECT_EQ(text.substr(0, text.find('\n')), "time,\"arm.swing, or turn\"");
}

// A SENSOR is switched without giving up the tree.
TEST_F(Tool, ASensorReturnsAndTheNextCommandGoesOn) {
    std::string watched = Pendulum;
    watched.insert(watched.find("REQUEST/1"), "SENSOR/1,LE,VALUE=-30D,RETURN,FUNCTION=AZ(21,10)\n");
    write("model.adm", watched);
    const std::string commands = write("model.acf",
                                       "model\nresults\nINFO/LIST\nSIMULATE/DYNAMICS, END=2, STEPS=2\n"
                                       "SIMULATE/DYNAMICS, END=1, STEPS=1\nDEACTIVATE/SENSOR, ID=1\n"
                                       "SIMULATE/DYNAMICS, END=3, STEPS=1\nSTOP\n");
    const Outcome outcome = run("run " + commands + " --out " + (m_folder / "o").string());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("model.acf:3:1: warning: INFO is not supported and is left out"),
              std::string::npos);
    EXPECT_NE(outcome.out.find("ended by                 SENSOR/1"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(" to 1\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("SIMULATE/DYNAMICS from 1 to 3\n"), std::string::npos) << outcome.out;
}

TEST_F(Tool, CommandsThatAreNotSupportedAreSaidToBeThat) {
    write("model.adm", Pendulum);
    const Outcome outcome =
        run("run " + write("model.acf", "model\n\nLINEAR/EIGENSOL\nMOTION/1, FUNCTION=0\nSIMLATE/STA\n"));
    EXPECT_EQ(outcome.exitCode, 3);
    for (const char* message : {":3:1: error: LINEAR is not supported in a command file",
                                ":4:1: error: MOTION is not supported in a command file",
                                ":5:1: error: 'SIMLATE' is not a command"})
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
}

TEST_F(Tool, AFailingCommandIsNamedByItsLine) {
    write("model.adm", Pendulum);
    const std::string commands = write(
        "model.acf", "model\n\nSIMULATE/DYNAMICS, END=0.2, STEPS=2\nSIMULATE/KINEMATICS, END=1, STEPS=2\n");
    const std::string out = (m_folder / "o").string();
    const Outcome outcome = run("run " + commands + " --quiet --out " + out);
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("model.acf:4:1: error: kinematics: needs a mechanism without freedoms"),
              std::string::npos)
        << outcome.err;
    EXPECT_EQ(countLines(readFile(m_folder / "o" / "requests.csv")), 1u + 3u) << "what was simulated is kept";
}

// Before anything is simulated or written.
TEST_F(Tool, CommandsThatDoNotFitTheModelExitWith3) {
    write("model.adm", Pendulum);
    const std::string out = (m_folder / "o").string();
    const Outcome lost = run("run " +
                             write("lost.acf",
                                   "model\n\nSIMULATE/DYNAMICS, END=0.2, STEPS=2\nDEACTIVATE/JOINT, ID=7, 8\n"
                                   "ACTIVATE/SENSOR, ID=3\n") +
                             " --out " + out);
    EXPECT_EQ(lost.exitCode, 3);
    for (const char* message : {"lost.acf:4:1: error: JOINT/7 does not exist in this model",
                                "lost.acf:4:1: error: JOINT/8 does not exist in this model",
                                "lost.acf:5:1: error: SENSOR/3 does not exist in this model"})
        EXPECT_NE(lost.err.find(message), std::string::npos) << lost.err;
    EXPECT_FALSE(fs::exists(m_folder / "o"));
    const Outcome idle = run("run " + write("idle.acf", "model\n\nDEACTIVATE/JOINT, ID=1\n"));
    EXPECT_EQ(idle.exitCode, 3);
    EXPECT_NE(idle.err.find("idle.acf: error: there is no SIMULATE command"), std::string::npos) << idle.err;
}

TEST_F(Tool, MistakesOfAllKindsAreListedTogether) {
    const Outcome outcome = run("run " +
                                write("bad.adm",
                                      "t\nPART/1,GROUND\nMARKER/1\nREQUEST/1,F2=SINN(1)\nMARKER/2,QQQ=1\n"
                                      "FLEX_BODY/3,MODES_FILE=QQQ.modes\nEND\n") +
                                " --end 1");
    EXPECT_EQ(outcome.exitCode, 3);
    const std::size_t function = outcome.err.find("bad.adm:4:14: error: REQUEST/1: unknown function 'SINN'"),
                      statement = outcome.err.find("bad.adm:5:10: error: unknown argument 'QQQ' of MARKER/2"),
                      modes = outcome.err.find("bad.adm:6:1: error: FLEX_BODY/3: ");
    EXPECT_LT(function, statement) << outcome.err;
    EXPECT_LT(statement, modes) << outcome.err;
    EXPECT_NE(modes, std::string::npos) << outcome.err;
}

TEST_F(Tool, WarnsOfRequestsThatAreNoNumbers) {
    std::string model = Pendulum;
    model.insert(model.find("REQUEST/1"), "REQUEST/2,F2=LOG(-1-TIME)\n");
    const Outcome outcome = run("run " + write("model.adm", model) + " --end 0.1 --steps 2 --quiet");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("warning: REQUEST/2: R2.F2 is not a number at time 0"), std::string::npos)
        << outcome.err;
}

TEST_F(Tool, RefusesMoreRowsThanAnyoneReads) {
    const Outcome outcome = run("run " + write("model.adm", Pendulum) + " --end 1 --dtout 1e-9 --quiet");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find(
                  "output step: 1e-09 is too short for a run from 0 to 1: there would be 1000000001 rows"),
              std::string::npos)
        << outcome.err;
}

TEST_F(Tool, CommandFilesWithErrorsExitWith3) {
    const std::string bad = write("bad.acf", "model\n\nSIMULATE/DYNAMICS\n");
    EXPECT_EQ(run("run " + bad).exitCode, 3);
    const Outcome missing = run("run " + write("lost.acf", "nowhere\n\nSIMULATE/STATICS\n"));
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_NE(missing.err.find("nowhere.adm: error: cannot read the file"), std::string::npos) << missing.err;
}

TEST_F(Tool, OptionsThatACommandFileDecidesAreWrongUsage) {
    const std::string commands = write("model.acf", "model\n\nSIMULATE/STATICS\n");
    for (const char* option : {"--end 1", "--statics", "--start equilibrium"}) {
        const Outcome outcome = run("run " + commands + " " + option);
        EXPECT_EQ(outcome.exitCode, 2) << option;
        EXPECT_NE(outcome.err.find("a command file says itself what to simulate"), std::string::npos);
    }
    const Outcome without = run("run " + write("model.adm", Pendulum));
    EXPECT_EQ(without.exitCode, 2);
    EXPECT_NE(without.err.find("--end is required"), std::string::npos);
}

TEST_F(Tool, StaticsAndStartFromEquilibrium) {
    const std::string model = write("model.adm", Pendulum), out = (m_folder / "o").string();
    EXPECT_EQ(run("run " + model + " --statics --out " + out).exitCode, 0);
    const std::string rows = readFile(m_folder / "o" / "requests.csv");
    EXPECT_EQ(countLines(rows), 2u);
    constexpr double Hanging = -1.5707963267948966, Exact = 1e-8;
    EXPECT_NEAR(std::stod(rows.substr(rows.rfind(',') + 1)), Hanging, Exact);

    EXPECT_EQ(run("run " + model + " --end 1 --steps 3 --start equilibrium --out " + out).exitCode, 0);
    const std::string moved = readFile(m_folder / "o" / "requests.csv");
    EXPECT_NEAR(std::stod(moved.substr(moved.rfind(',') + 1)), Hanging, Exact);

    const Outcome falling = run("run " +
                                write("fall.adm",
                                      "fall\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\n"
                                      "PART/2,MASS=1,CM=2,IP=1,1,1\nMARKER/2\nEND\n") +
                                " --statics");
    EXPECT_EQ(falling.exitCode, 1);
    EXPECT_NE(falling.err.find("equilibrium: none was found from here; PART/2 still moves"),
              std::string::npos);
}

}  // namespace
}  // namespace jprim::testing
