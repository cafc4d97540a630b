// SPDX-License-Identifier: Apache-2.0
// Command files: what they become, and every mistake with its place and its words.
#include "jprim/dataset/commands.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "dataset/command_properties.h"

namespace jprim {
namespace {

std::string formatAll(const Diagnostics& diagnostics) {
    std::string findings;
    for (const Diagnostic& d : diagnostics)
        findings += (findings.empty() ? "" : "\n") + formatDiagnostic("", d).substr(1);
    return findings;
}

std::string findMistakes(const std::string& text) {
    EXPECT_EQ(findBrokenCommandProperty(text), "") << text;
    Diagnostics diagnostics;
    readCommands(text, diagnostics);
    return formatAll(diagnostics);
}

CommandFile readGood(const std::string& text) {
    EXPECT_EQ(findMistakes(text), "") << text;
    Diagnostics diagnostics;
    return readCommands(text, diagnostics);
}

/// The only command after the two names; it stands in line 3.
SimulateCommand simulate(const std::string& text) {
    const CommandFile file = readGood("model\n\n" + text);
    EXPECT_EQ(file.commands.size(), 1u) << text;
    return std::get<SimulateCommand>(file.commands.at(0));
}

// The order of a real file: names, a short run with everything locked, then the run that is wanted.
TEST(Commands, ClassicForm) {
    const CommandFile file = readGood(
        "turbine_ADAMS\n results/run 1  ! where to\nINTEGRATOR/GSTIFF, ERROR = 0.001, HMAX =  4.0E-03\n"
        "SIMULATE/DYNAMICS, END =  4.0E-03, DTOUT =  5.0E-02\n"
        "DEACTIVATE/JPRIM, ID = 1000\nDEACTIVATE/JOINT, RANGE = 1301, 1310\n"
        "simulate/dynamic, dur=20, steps=400\nSTOP\nQQQ\n");
    EXPECT_EQ(file.model, "turbine_ADAMS");
    EXPECT_EQ(file.output, "results/run 1");
    ASSERT_EQ(file.commands.size(), 4u);
    ASSERT_EQ(file.ignored.size(), 1u);
    EXPECT_EQ(file.ignored[0].keyword, "INTEGRATOR");
    const auto& first = std::get<SimulateCommand>(file.commands[0]);
    EXPECT_EQ(first.analysis, Analysis::Dynamics);
    EXPECT_EQ(first.end, 4e-3);
    EXPECT_EQ(first.dtout, 0.05);
    EXPECT_FALSE(first.duration || first.steps);
    EXPECT_EQ(first.where.line, 4);
    const auto& primitive = std::get<ActivateCommand>(file.commands[1]);
    EXPECT_FALSE(primitive.active);
    EXPECT_EQ(primitive.kind, ElementKind::Jprim);
    ASSERT_EQ(primitive.ids.size(), 1u);
    EXPECT_EQ(primitive.ids[0].first, 1000);
    EXPECT_EQ(primitive.ids[0].last, 1000);
    const auto& joints = std::get<ActivateCommand>(file.commands[2]);
    EXPECT_EQ(joints.kind, ElementKind::Joint);
    EXPECT_EQ(joints.ids.at(0).first, 1301);
    EXPECT_EQ(joints.ids.at(0).last, 1310);
    const auto& second = std::get<SimulateCommand>(file.commands[3]);
    EXPECT_EQ(second.duration, 20.0);
    EXPECT_EQ(second.steps, 400);
}

TEST(Commands, NamesAreGivenInTwoWays) {
    const std::pair<const char*, std::pair<const char*, const char*>> cases[] = {
        {"rod\nout\nSTOP", {"rod", "out"}},
        {"rod\n\nSTOP", {"rod", "rod"}},
        {"\n! comment\n\n  rod.adm \r\nout\r\n", {"rod.adm", "out"}},
        {"rod", {"rod", "rod"}},
        {"FILE/MODEL=rod\nSTOP", {"rod", "rod"}},
        {"\nfile/model=some folder/rod\n", {"some folder/rod", "some folder/rod"}},
        {"FILE/MODEL=rod, OUTPUT_PREFIX=out", {"rod", "out"}},
        {"! comment\nFILE/OUTPUT=out,\nMOD=rod; STOP", {"rod", "out"}},
    };
    for (const auto& [text, names] : cases) {
        const CommandFile file = readGood(text);
        EXPECT_EQ(file.model, names.first) << text;
        EXPECT_EQ(file.output, names.second) << text;
    }
}

TEST(Commands, EveryAnalysis) {
    const std::pair<const char*, Analysis> cases[] = {
        {"DY", Analysis::Dynamics},           {"dynamic", Analysis::Dynamics}, {"K", Analysis::Kinematics},
        {"KINEMATICS", Analysis::Kinematics}, {"STA", Analysis::Statics},      {"static", Analysis::Statics},
        {"TRANSIENT", Analysis::Transient}};
    for (const auto& [word, analysis] : cases)
        EXPECT_EQ(simulate("SI/END=2, " + std::string(word) + ", STEPS=3").analysis, analysis) << word;
    EXPECT_EQ(simulate("SIMULATE/STATICS").analysis, Analysis::Statics);
    EXPECT_FALSE(simulate("SIMULATE/STATICS").end);
    EXPECT_EQ(simulate("SIMULATE/INITIAL_CONDITIONS").level, KinematicLevel::Acceleration);
    EXPECT_EQ(simulate("SIM/I, VEL").level, KinematicLevel::Velocity);
    EXPECT_EQ(simulate("SIM/INITIAL, DISPLACEMENT").level, KinematicLevel::Position);
    EXPECT_EQ(simulate("SIM/INITIAL, DISPLACEMENT").analysis, Analysis::InitialConditions);
}

TEST(Commands, LayoutDoesNotMatter) {
    for (const char* text :
         {"SIMULATE/DYNAMICS, END=2, STEPS=30", "simulate / dynamics , end = 2 , steps = 30",
          "SIMULATE/DYNAMICS ! why\n! and\n\n, END=2.0\n, STEPS=3E1",
          "SIMULATE/DYNAMICS, &\nEND=2 &\n,STEPS=30", "SIMULATE/DYNAMICS,\nEND=2,\nSTEPS=30;EXIT; QQQ"}) {
        const SimulateCommand command = simulate(text);
        EXPECT_EQ(command.end, 2.0) << text;
        EXPECT_EQ(command.steps, 30) << text;
    }
}

TEST(Commands, EveryKindIsSwitched) {
    const CommandFile file = readGood(
        "m\no\nACTIVATE/JPRIM, ID=1,02\nDEACTIVATE/JOINT, ID=3\nACT/GCON, RANGE=4,6, ID=9\nDEA/MOTION, RANGE=7,7\n"
        "activate/sensor, id=1,5");
    const ElementKind kinds[] = {ElementKind::Jprim, ElementKind::Joint, ElementKind::Gcon,
                                 ElementKind::Motion, ElementKind::Sensor};
    ASSERT_EQ(file.commands.size(), 5u);
    for (std::size_t k = 0; k < 5; ++k) {
        const auto& command = std::get<ActivateCommand>(file.commands[k]);
        EXPECT_EQ(command.kind, kinds[k]);
        EXPECT_EQ(command.active, k % 2 == 0);
        EXPECT_EQ(command.ids.size(), k % 2 == 0 ? 2u : 1u);
    }
    EXPECT_EQ(std::get<ActivateCommand>(file.commands[0]).ids[1].first, 2);
    EXPECT_EQ(std::get<ActivateCommand>(file.commands[2]).ids[0].last, 6);
    EXPECT_STREQ(getAdamsName(ElementKind::Gcon), "GCON");
    EXPECT_STREQ(getAdamsName(ElementKind::Sensor), "SENSOR");
    EXPECT_STREQ(getAdamsName(Analysis::InitialConditions), "INITIAL_CONDITIONS");
}

struct MistakeCase {
    const char* name;
    const char* text;  ///< stands in line 3
    const char* findings;
};

void checkMistakes(const std::vector<MistakeCase>& cases) {
    for (const MistakeCase& c : cases)
        EXPECT_EQ(findMistakes("m\no\n" + std::string(c.text)), c.findings) << c.name;
}

const std::string Supported = "; supported are FILE, SIMULATE, ACTIVATE, DEACTIVATE, STOP and EXIT";

// Every command of Adams is told from a word that is none.
TEST(CommandMistakes, CommandsThatAreNotSupported) {
    for (const std::string word :
         {"PART",    "MARKER",  "FLEX_BODY",   "POINT_MASS",   "JOINT",   "MOTION",  "GCON",
          "COUPLER", "ACCGRAV", "BEAM",        "BUSHING",      "CONTACT", "FIELD",   "FRICTION",
          "GFORCE",  "NFORCE",  "SFORCE",      "SPRINGDAMPER", "VFORCE",  "VTORQUE", "ARRAY",
          "SPLINE",  "STRING",  "VARIABLE",    "DIFF",         "SENSOR",  "REQUEST", "CONTROL",
          "LINEAR",  "SAVE",    "ENVIRONMENT", "RELOAD"})
        EXPECT_EQ(findMistakes("m\no\n" + word + "/1, QQQ=(1,2"),
                  "3:1: error: " + word + " is not supported in a command file" + Supported);
    EXPECT_EQ(findMistakes("m\no\nlin/eigensol\nvar/3, FUNCTION=2"),
              "3:1: error: LINEAR is not supported in a command file" + Supported +
                  "\n4:1: error: VARIABLE is not supported in a command file" + Supported);
    for (const std::string word : {"HELP", "INFO", "LIST", "MENU", "SHOW", "TIME"})
        EXPECT_EQ(findMistakes("m\no\n" + word + "/QQQ\nSIMULATE/STATICS"),
                  "3:1: warning: " + word + " is not supported and is left out; it changes no motion");
    for (const char* word : {"INTEGRATOR", "OUTPUT", "RESULTS", "PREFERENCES", "EQUILIBRIUM", "KINEMATICS",
                             "IC", "DEBUG", "LSOLVER"})
        readGood("m\no\n" + std::string(word) + "/ERROR=1E-3");
}

TEST(CommandMistakes, Words) {
    EXPECT_EQ(findMistakes("m\no\nSIMULTE/DYN"),
              "3:1: error: 'SIMULTE' is not a command" + Supported + "; did you mean SIMULATE?");
    EXPECT_EQ(findMistakes("m\no\nQQQ/DYN"), "3:1: error: 'QQQ' is not a command" + Supported);
    EXPECT_EQ(findMistakes("m\no\nSTOP/1"), "3:1: error: STOP stands alone; it takes no arguments");
    EXPECT_EQ(findMistakes("m\no\nexit/1"), "3:1: error: EXIT stands alone; it takes no arguments");
    checkMistakes({
        {"no slash", "SIMULATE", "3:9: error: a slash is missing after 'SIMULATE'"},
        {"comma without a command", ", END=3",
         "3:1: error: a line that begins with a comma continues a statement, but none is open here"},
        {"ampersand", "SIM/DYN & , END=1", "3:9: error: '&' may only end a line, to continue it on the next"},
        {"argument", "SIMULATE/DYNAMICS, ENDE=1, STEPS=2",
         "3:20: error: unknown argument 'ENDE' of SIMULATE; did you mean END?"},
        {"ambiguous", "SIMULATE/D, END=1, STEPS=2", "3:10: error: unknown argument 'D' of SIMULATE"},
    });
}

TEST(CommandMistakes, Names) {
    EXPECT_EQ(findMistakes(""), "1:1: error: no model is named; the first line may do it, or FILE/MODEL=");
    EXPECT_EQ(findMistakes("\n! QQQ\n"),
              "1:1: error: no model is named; the first line may do it, or FILE/MODEL=");
    EXPECT_EQ(findMistakes("SIMULATE/STATICS\nSTOP\n"),
              "1:1: warning: this line names the model, so 'SIMULATE/STATICS' is not read as a command");
    EXPECT_EQ(findMistakes("m\nSIMULATE/STATICS\nSTOP\n"),
              "2:1: warning: this line names the output, so 'SIMULATE/STATICS' is not read as a command");
    EXPECT_EQ(findMistakes("FILE/OUTPUT=o"), "1:1: error: FILE needs MODEL: MODEL=");
    EXPECT_EQ(findMistakes("FILE/MODEL=,OUTPUT=o"), "1:6: error: MODEL of FILE is empty");
    EXPECT_EQ(findMistakes("FILE/COMMAND=QQQ, MODEL=m"), "1:6: error: COMMAND of FILE is not supported yet");
    checkMistakes({{"second model", "FILE/MODEL=QQQ",
                    "3:1: error: the model is already named in line 1; a command file has one"}});
}

TEST(CommandMistakes, Simulations) {
    checkMistakes({
        {"no analysis", "SIMULATE/END=1, STEPS=2",
         "3:1: error: SIMULATE needs a type: DYNAMICS, KINEMATICS, STATICS, TRANSIENT, INITIAL_CONDITIONS"},
        {"two analyses", "SIMULATE/DYN, KIN, END=1, STEPS=2",
         "3:15: error: SIMULATE cannot be both DYNAMICS and KINEMATICS"},
        {"no time, no steps", "SIMULATE/DYNAMICS",
         "3:1: error: SIMULATE needs END= or DURATION=\n3:1: error: SIMULATE needs STEPS= or DTOUT="},
        {"no steps of a slow load", "SIMULATE/STATICS, END=3", "3:1: error: SIMULATE needs STEPS= or DTOUT="},
        {"both", "SIMULATE/DYN, END=1, DUR=2, STEPS=3, DTOUT=4",
         "3:15: error: SIMULATE takes END or DURATION, not both\n"
         "3:29: error: SIMULATE takes STEPS or DTOUT, not both"},
        {"not positive", "SIMULATE/DYN, DUR=0, DTOUT=-0.5",
         "3:15: error: DURATION of SIMULATE is 0; it must be larger than 0\n"
         "3:22: error: DTOUT of SIMULATE is -0.5; it must be larger than 0"},
        {"negative end", "SIMULATE/DYN, END=-2, STEPS=1",
         "3:15: error: END of SIMULATE is -2; it must be larger than 0"},
        {"half a step", "SIMULATE/DYN, END=1, STEPS=2.5",
         "3:22: error: STEPS of SIMULATE is 2.5; write a whole number from 1 to 1000000000"},
        {"no step", "SIMULATE/DYN, END=1, STEPS=0",
         "3:22: error: STEPS of SIMULATE is 0; write a whole number from 1 to 1000000000"},
        {"too many steps", "SIMULATE/DYN, END=1, STEPS=1E300",
         "3:22: error: STEPS of SIMULATE is 1e+300; write a whole number from 1 to 1000000000"},
        {"level of a run", "SIMULATE/DYN, VEL, END=1, STEPS=2",
         "3:15: error: VELOCITY of SIMULATE is for INITIAL_CONDITIONS only"},
        {"two levels", "SIMULATE/INI, VEL, DISP",
         "3:20: error: SIMULATE cannot be both VELOCITY and DISPLACEMENT"},
        {"time of a state", "SIMULATE/INI, END=1",
         "3:15: error: END of SIMULATE is for DYNAMICS, KINEMATICS, STATICS and TRANSIENT only"},
    });
    // A sensor may end the first command early, which nobody knows here.
    readGood("m\no\nSIM/DYN, END=2, STEPS=3\nSIM/DYN, END=1, DTOUT=0.7");
}

TEST(CommandMistakes, Switches) {
    checkMistakes({
        {"no kind", "ACTIVATE/ID=1",
         "3:1: error: ACTIVATE needs a type: JPRIM, JOINT, GCON, MOTION, COUPLER, SFORCE, "
         "VFORCE, VTORQUE, GFORCE, SPRINGDAMPER, BUSHING, SENSOR"},
        {"no id", "DEACTIVATE/JPRIM", "3:1: error: DEACTIVATE needs ID= or RANGE="},
        {"two kinds", "DEACTIVATE/JPRIM, JOINT, ID=1",
         "3:19: error: DEACTIVATE cannot be both JPRIM and JOINT"},
        {"id of a kind", "DEACTIVATE/JPRIM=1, ID=1", "3:12: error: JPRIM of DEACTIVATE takes no value"},
        {"range of one", "DEACTIVATE/JPRIM, RANGE=1", "3:19: error: RANGE of DEACTIVATE takes 2 ids, not 1"},
        {"range backwards", "DEACTIVATE/JPRIM, RANGE=5,3",
         "3:19: error: RANGE of DEACTIVATE goes from 5 down to 3; write the smaller id first"},
        {"no number", "DEACTIVATE/JPRIM, ID=1,QQQ",
         "3:24: error: ID of DEACTIVATE: 'QQQ' is not an id; ids are whole numbers from 1"},
        {"kind without a switch", "DEACTIVATE/BEAM, ID=1",
         "3:12: error: BEAM of DEACTIVATE is not supported yet"},
    });
}

TEST(Commands, AreReadFromAFile) {
    const std::filesystem::path path = std::filesystem::temp_directory_path() / "jprim_commands_test.acf";
    std::ofstream(path) << "FILE/MODEL=rod\nSIMULATE/STATICS\n";
    Diagnostics diagnostics;
    const CommandFile file = readCommandFile(path.string(), diagnostics);
    std::filesystem::remove(path);
    EXPECT_EQ(formatAll(diagnostics), "");
    EXPECT_EQ(file.folder, path.parent_path().string());
    EXPECT_EQ(file.commands.size(), 1u);
    readCommandFile(path.string(), diagnostics);
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(formatDiagnostic("QQQ.acf", diagnostics[0]),
              "QQQ.acf: error: cannot read the file; check its name and permissions");
}

}  // namespace
}  // namespace jprim
