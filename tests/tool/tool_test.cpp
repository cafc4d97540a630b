// SPDX-License-Identifier: Apache-2.0
// The command as its users meet it: exit codes, files, messages, and what it prints where.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tool/tool_fixture.h"

namespace {

namespace fs = std::filesystem;
using jprim::testing::Outcome;
using jprim::testing::readFile;
using jprim::testing::Tool;

const std::string Pendulum =
    "pendulum\nUNITS/FORCE=NEWTON,MASS=KILOGRAM,LENGTH=MILLIMETER,TIME=SECOND\nACCGRAV/KGRAV=-9806.65\n"
    "PART/1,GROUND\nMARKER/10,REULER=180D,90D,180D\n"
    "PART/2,MASS=1,CM=20,IP=4E4,1E5,1E5\nMARKER/20,QP=2000,0,0\nMARKER/21,REULER=180D,90D,180D\n"
    "JOINT/1,REVOLUTE,I=10,J=21\nREQUEST/7,DISPLACEMENT,I=20\nEND\n";

TEST_F(Tool, RunWritesThreeFilesAndASummary) {
    const Outcome r = run("run " + write("p.adm", Pendulum) + " --end 1 --steps 10 --out " +
                          (m_folder / "results").string());
    EXPECT_EQ(r.exitCode, 0) << r.err;
    EXPECT_EQ(r.err, "");
    for (const char* line : {"degrees of freedom       1\n", "worst constraint error", "energy  ",
                             "integration steps", "wall time"})
        EXPECT_NE(r.out.find(line), std::string::npos) << line << "\n" << r.out;

    const std::string requests = readFile(m_folder / "results/requests.csv");
    EXPECT_EQ(requests.substr(0, requests.find('\n')), "time,R7.MAG,R7.X,R7.Y,R7.Z,R7.PSI,R7.THETA,R7.PHI");
    EXPECT_EQ(std::count(requests.begin(), requests.end(), '\n'), 12);
    EXPECT_EQ(requests.substr(requests.find('\n') + 1, 12), "0,2000,2000,");
    // At least fifteen digits: the last time and one coordinate.
    const std::string last = requests.substr(requests.rfind('\n', requests.size() - 2) + 1);
    EXPECT_EQ(last.substr(0, 2), "1,");
    const size_t x = last.find(',', 2) + 1;  // of the magnitude all digits may be zeros
    EXPECT_GE(last.substr(x, last.find(',', x) - x).size(), 15u) << last;
    const std::string reactions = readFile(m_folder / "results/reactions.csv");
    EXPECT_EQ(
        reactions.substr(0, reactions.find('\n')),
        "time,JOINT/1.I.FX,JOINT/1.I.FY,JOINT/1.I.FZ,JOINT/1.I.TX,JOINT/1.I.TY,JOINT/1.I.TZ,JOINT/1.J.FX,JOINT/1.J.FY,JOINT/1.J.FZ,JOINT/1.J.TX,JOINT/1.J.TY,JOINT/1.J.TZ");
    const std::string parts = readFile(m_folder / "results/parts.csv");
    EXPECT_EQ(
        parts.substr(0, parts.find('\n')),
        "time,PART/2.X,PART/2.Y,PART/2.Z,PART/2.E0,PART/2.E1,PART/2.E2,PART/2.E3,PART/2.VX,PART/2.VY,PART/2.VZ,PART/2.WX,PART/2.WY,PART/2.WZ,energy.kinetic,energy.potential,energy.total,error.length,error.angle");
}

TEST_F(Tool, QuietPrintsNothing) {
    const Outcome r = run("run " + write("p.adm", Pendulum) + " --end 1 --dtout 0.1 --quiet");
    EXPECT_EQ(r.exitCode, 0);
    EXPECT_EQ(r.out + r.err, "");
}

// A coarse integration loses energy; a mechanism at rest has none to lose.
TEST_F(Tool, WarnsOfEnergyErrors) {
    const std::string model =
        std::string(JPRIM_SOURCE_DIR) + "/tests/data/adams/RevSpherical_Case01_joint.adm";
    const std::string warning = "warning: the energy of this conservative mechanism changed by";
    EXPECT_EQ(run("run " + model + " --end 5 --quiet").err.find(warning), std::string::npos);
    const Outcome coarse = run("run " + model + " --end 5 --steps 5 --accuracy 0.05 --quiet");
    EXPECT_EQ(coarse.exitCode, 0);
    EXPECT_NE(coarse.err.find(warning), std::string::npos) << coarse.err;

    std::string still = Pendulum;
    still.replace(still.find("REVOLUTE"), 8, "FIXED");
    EXPECT_EQ(run("run " + write("f.adm", still) + " --end 10 --quiet").err, "");
}

// With a brake, what the energy is held against is the work of loads.
TEST_F(Tool, WarnsWhereEnergyComesFromNowhere) {
    std::string braked = Pendulum;
    braked.insert(braked.find("JOINT/1"), "SFORCE/1,ROTATION,I=21,J=10,FUNCTION=-10*WZ(21,10,10)\n");
    const std::string model = write("b.adm", braked);
    const Outcome fine = run("run " + model + " --end 10");
    EXPECT_EQ(fine.err, "");
    EXPECT_NE(fine.out.find("\nenergy balance           off by at most "), std::string::npos) << fine.out;
    const Outcome coarse = run("run " + model + " --end 10 --steps 5 --accuracy 0.05 --quiet");
    EXPECT_EQ(coarse.exitCode, 0);
    EXPECT_EQ(coarse.err.find(
                  model + ": warning: the energy of this mechanism is not what the work of its loads makes "
                          "it: it is off by "),
              0u)
        << coarse.err;
    EXPECT_EQ(run("run " + write("p.adm", Pendulum) + " --end 1").out.find("energy balance"),
              std::string::npos);
}

TEST_F(Tool, ProgressBarOnATerminalOnly) {
    const std::string model = write("p.adm", Pendulum);
    EXPECT_NE(runOnTerminal({"run", model, "--end", "1"}).find("[##########"), std::string::npos);
    EXPECT_EQ(runOnTerminal({"run", model, "--end", "1", "--quiet"}), "");
    EXPECT_EQ(run("run " + model + " --end 1").err, "");
}

TEST_F(Tool, AllErrorsOfADatasetAreListedAndItExitsWith3) {
    const std::string model = write("bad.adm",
                                    "bad\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=1,CM=20,IP=1,1,1\n"
                                    "MARKER/20,QQQ=1,2,3\nBEAM/1,I=10,J=20\nEND\n");
    for (const std::string& command : {"run " + model + " --end 1", "check " + model}) {
        const Outcome r = run(command);
        EXPECT_EQ(r.exitCode, 3);
        EXPECT_NE(r.err.find(model + ":5:11: error: "), std::string::npos) << r.err;
        EXPECT_NE(r.err.find(model + ":6:1: error: BEAM"), std::string::npos) << r.err;
        EXPECT_EQ(r.out, "");
    }
}

TEST_F(Tool, MotionOnAJprimSaysToUseAJoint) {
    const std::string model =
        write("m.adm", Pendulum.substr(0, Pendulum.size() - 4) + "MOTION/1,JPRIM=1,FUNCTION=TIME\nEND\n");
    const Outcome r = run("check " + model);
    EXPECT_EQ(r.exitCode, 3);
    EXPECT_NE(r.err.find("JPRIM"), std::string::npos);
    EXPECT_NE(r.err.find("use a JOINT"), std::string::npos) << r.err;
}

TEST_F(Tool, AFileThatIsNotThereExitsWith3) {
    const Outcome r = run("check " + (m_folder / "none.adm").string());
    EXPECT_EQ(r.exitCode, 3);
    EXPECT_NE(r.err.find("none.adm: error: "), std::string::npos) << r.err;
}

TEST_F(Tool, WrongUsageExitsWith2) {
    const std::string model = write("p.adm", Pendulum);
    const std::string ok = "run " + model + " --end 1";
    const std::vector<std::string> wrong = {"",
                                            "walk " + model,
                                            "check",
                                            "run --end 1",
                                            "run " + model,
                                            "run " + model + " --end -1",
                                            ok + " --steps 5 --dtout 0.1",
                                            ok + " --steps 0",
                                            ok + " --integrator Euler",
                                            ok + " --accuracy 7",
                                            ok + " --constraint-tolerance 1",
                                            ok + " --max-step 0",
                                            ok + " --max-step nan",
                                            ok + " --dtout nan",
                                            ok + " --accuracy nan",
                                            "run " + model + " --end nan",
                                            "run " + model + " --end 1e300"};
    for (const std::string& arguments : wrong) {
        const Outcome r = run(arguments);
        EXPECT_EQ(r.exitCode, 2) << arguments;
        EXPECT_EQ(r.out, "") << arguments;
        EXPECT_NE(r.err.find("--help"), std::string::npos) << arguments << "\n" << r.err;
    }
}

TEST_F(Tool, HelpAndVersion) {
    EXPECT_EQ(run("--version").out, "jprim 0.1.0\n");
    const Outcome help = run("--help");
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_NE(help.out.find("run"), std::string::npos);
    EXPECT_NE(run("run --help").out.find("--dtout"), std::string::npos);
}

TEST_F(Tool, WhatCannotBeAssembledFailsWith1OrIsUnusable) {
    const std::string model =
        write("apart.adm",
              "apart\nPART/1,GROUND\nMARKER/10\nMARKER/11,QP=3,0,0\nPART/2,MASS=1,CM=20,IP=1,1,1\n"
              "MARKER/20\nMARKER/21,QP=1,0,0\nJPRIM/1,ATPOINT,I=20,J=10\nJPRIM/2,ATPOINT,I=21,J=11\nEND\n");
    const Outcome r = run("run " + model + " --end 1");
    EXPECT_EQ(r.exitCode, 1);
    EXPECT_NE(r.err.find("cannot be assembled"), std::string::npos);
    const Outcome checked = run("check --json " + model);
    EXPECT_EQ(checked.exitCode, 3);
    const nlohmann::json json = nlohmann::json::parse(checked.out);
    EXPECT_EQ(json["usable"], false);
    EXPECT_NE(std::string(json["messages"][0]["message"]).find("cannot be assembled"), std::string::npos);
}

TEST_F(Tool, CheckListsErrorsForMachinesToo) {
    const std::string model = write("bad.adm", "bad\nPART/1,GROUND\nMARKER/10\n  GCON/1,FUNCTION=1\nEND\n");
    const nlohmann::json json = nlohmann::json::parse(run("check --json " + model).out);
    EXPECT_EQ(json["usable"], false);
    ASSERT_EQ(json["messages"].size(), 1u);
    EXPECT_EQ(json["messages"][0]["severity"], "error");
    EXPECT_EQ(json["messages"][0]["line"], 4);
    EXPECT_EQ(json["messages"][0]["column"], 19);
}

TEST_F(Tool, AFailedSimulationExitsWith1AndStillWritesItsFiles) {
    std::string heavy = Pendulum;
    heavy.replace(heavy.find("-9806.65"), 8, "-1E300");
    const Outcome r =
        run("run " + write("h.adm", heavy) + " --end 1 --out " + (m_folder / "results").string());
    EXPECT_EQ(r.exitCode, 1);
    EXPECT_NE(r.err.find("h.adm: error: at time 0: the simulation cannot go on"), std::string::npos) << r.err;
    EXPECT_TRUE(fs::exists(m_folder / "results/parts.csv"));
}

TEST_F(Tool, ResultsThatCannotBeWrittenFailWith1) {
    write("taken", "a file where the folder should be");
    const Outcome r =
        run("run " + write("p.adm", Pendulum) + " --end 1 --out " + (m_folder / "taken").string());
    EXPECT_EQ(r.exitCode, 1);
    EXPECT_NE(r.err.find("taken"), std::string::npos);
}

TEST_F(Tool, OutputThatIsLostFailsWith1) {
    const std::string model = write("p.adm", Pendulum);
    const int status =
        std::system((std::string(JPRIM_TOOL) + " check " + model + " >/dev/full 2>/dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1);
}

// The same reactions to the digits that both integrations share.
TEST_F(Tool, RunOffersBothFormulations) {
    const std::string model = write(
        "p.adm",
        "t\nACCGRAV/KGRAV=-9.81\nPART/1,GROUND\nMARKER/10,REULER=180D,90D,180D\nPART/2,MASS=1,CM=20,IP=1,2,3\n"
        "MARKER/20,QP=2,0,0\nMARKER/21,REULER=180D,90D,180D\nJOINT/1,REVOLUTE,I=10,J=21\nEND\n");
    std::vector<std::vector<double>> rows;
    for (const std::string formulation : {"tree", "constraints"}) {
        const fs::path out = m_folder / formulation;
        ASSERT_EQ(run("run " + model + " --end 1 --steps 1 --accuracy 1e-9 --quiet --formulation " +
                      formulation + " --out " + out.string())
                      .exitCode,
                  0);
        std::string text = readFile(out / "reactions.csv");
        text.erase(0, text.rfind('\n', text.size() - 2));
        std::replace(text.begin(), text.end(), ',', ' ');
        std::istringstream numbers(text);
        rows.emplace_back(std::istream_iterator<double>(numbers), std::istream_iterator<double>());
    }
    ASSERT_EQ(rows[0].size(), 13u);  // time, and six on either marker
    ASSERT_EQ(rows[1].size(), 13u);
    for (size_t k = 0; k < rows[0].size(); ++k) EXPECT_NEAR(rows[0][k], rows[1][k], 1e-6) << k;
    EXPECT_GT(std::abs(rows[0][1]), 1);
}

}  // namespace
