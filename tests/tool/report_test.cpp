// SPDX-License-Identifier: Apache-2.0
// Reports by the command: of a run at hand, of one before, and why there is none.
#include "report/report_reader.h"
#include "tool/tool_fixture.h"

namespace jprim {
namespace {

using testing::Outcome;
using testing::ReportReader;

const char* const Pendulum =
    "pendulum\nACCGRAV/JGRAV=-9.81\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\nMARKER/20,QP=0.5,0,0\n"
    "MARKER/21\nJOINT/1,REVOLUTE,I=21,J=10\nREQUEST/1,F2=SQRT(-TIME)\nEND\n";

class ReportTool : public testing::Tool {
protected:
    void SetUp() override {
        m_model = write("model.adm", Pendulum);
        m_report = (m_folder / "report.html").string();
        const Outcome outcome = run("run " + m_model + " --end 1 --steps 4 --report " + m_report);
        if (outcome.exitCode == 2) GTEST_SKIP() << outcome.err;
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        m_output = outcome.out;
    }

    std::string m_model, m_report, m_output;
};

TEST_F(ReportTool, SaysWhatTheRunSaid) {
    EXPECT_NE(m_output.find("report                   " + m_report + "\n"), std::string::npos) << m_output;
    const nlohmann::json text = ReportReader(m_report).json["text"];
    EXPECT_EQ(text["file"], "model.adm");
    EXPECT_EQ(text["dataset"], Pendulum);
    EXPECT_EQ(text["options"].dump(), R"([["--end","1"],["--steps","4"]])");
    EXPECT_EQ(text["summary"][0], "degrees of freedom       1");
    EXPECT_EQ(text["freedoms"], 1);
    EXPECT_EQ(text["warnings"][0]["severity"], "warning");
    EXPECT_EQ(text["warnings"][0]["where"], m_model);
    EXPECT_EQ(text["warnings"][0]["message"],
              "REQUEST/1: R1.F2 is not a number at time 0.25, and perhaps later");
    EXPECT_NE(text["analysis"].dump().find("redundant equations     0"), std::string::npos);
}

TEST_F(ReportTool, AnEarlierRunIsReportedAlike) {
    const std::string results = (m_folder / "results").string(), later = (m_folder / "later.html").string();
    ASSERT_EQ(
        run("run " + m_model + " --end 1 --steps 4 --out " + results + " --report " + m_report).exitCode, 0);
    const Outcome outcome = run("report " + results + " -o " + later);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(testing::readFile(later) == testing::readFile(m_report));

    write("model.adm", std::string(Pendulum) + "! more\n");
    EXPECT_NE(run("report " + results + " -o " + later)
                  .err.find("warning: has changed since the results were written"),
              std::string::npos);
    std::filesystem::rename(m_model, m_folder / "moved.adm");
    EXPECT_EQ(run("report " + results + " -o " + later).exitCode, 3);
    EXPECT_EQ(
        run("report " + results + " -o " + later + " --model " + (m_folder / "moved.adm").string()).exitCode,
        0);
}

TEST_F(ReportTool, WhatCannotBeReported) {
    const Outcome folder =
        run("run " + m_model + " --end 1 --report " + (m_folder / "model.adm/such.html").string());
    EXPECT_EQ(folder.exitCode, 2);
    EXPECT_NE(folder.err.find("model.adm/such.html: error: cannot be written"), std::string::npos)
        << folder.err;
    EXPECT_EQ(folder.out, "");
    const Outcome nothing = run("report " + m_folder.string() + " -o " + m_report);
    EXPECT_EQ(nothing.exitCode, 1);
    EXPECT_NE(nothing.err.find("run.json: cannot be read; a folder of results has it from `jprim run --out`"),
              std::string::npos)
        << nothing.err;
    write("run.json", "{\"format\": 1}");
    EXPECT_NE(
        run("report " + m_folder.string() + " -o " + m_report).err.find("run.json: is not what a run writes"),
        std::string::npos);
    write("run.json", "{\"format\": 99}");
    EXPECT_NE(run("report " + m_folder.string() + " -o " + m_report)
                  .err.find("run.json: is of another version of jprim"),
              std::string::npos);
}

// Up to where it came.
TEST_F(ReportTool, ARunThatFailedIsReported) {
    const std::string model =
        write("fails.adm",
              "fails\nPART/1,GROUND\nMARKER/10\nPART/2,MASS=2,CM=20,IP=0.1,0.1,0.2\nMARKER/20\n"
              "JOINT/1,REVOLUTE,I=20,J=10\nMOTION/1,JOINT=1,FUNCTION=IF(TIME-0.5:0,0,1)\nEND\n");
    const Outcome outcome = run("run " + model + " --end 1 --steps 10 --report " + m_report);
    EXPECT_EQ(outcome.exitCode, 1);
    const ReportReader report(m_report);
    EXPECT_EQ(report.json["text"]["warnings"][0]["severity"], "error");
    EXPECT_LT(report.read(report.json["frames"]["time"]).size(), 11u);
}

// A run writes into the results' folder what its report will need.
TEST_F(ReportTool, CommandFilesAreReported) {
    const std::string commands = write("model.acf", "model\n\nSIMULATE/DYNAMICS, END=1, STEPS=4\nSTOP\n");
    const Outcome outcome = run("run " + commands + " --report " + m_report);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const ReportReader report(m_report);
    EXPECT_EQ(report.json["text"]["summary"][0], "SIMULATE/DYNAMICS from 0 to 1");
    EXPECT_EQ(report.read(report.json["frames"]["time"]).size(), 5u);
}

}  // namespace
}  // namespace jprim
