// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <climits>
#include <cstdio>
#include <map>

#include "base/format.h"
#include "jprim/base/units.h"
#include "jprim/simulation/simulate.h"
#include "jprim/version.h"
#include "tool/commands.h"

namespace {

using jprim::tool::CheckArguments;
using jprim::tool::ReduceArguments;
using jprim::tool::ReportArguments;
using jprim::tool::RunArguments;

// CLI11's own checks let NaN through.
CLI::Validator makeRange(double above, double upTo, const std::string& meaning) {
    return CLI::Validator(
        [=](const std::string& text) {
            double value = 0;
            const bool good = CLI::detail::lexical_cast(text, value) && value > above && value <= upTo;
            return good ? std::string() : text + " is not " + meaning;
        },
        "", "");
}

CLI::Validator makeUnitCheck(jprim::Quantity quantity) {
    return CLI::Validator(
        [=](const std::string& text) {
            if (jprim::findUnit(quantity, text)) return std::string();
            std::string names;
            for (const jprim::Unit& unit : jprim::getUnits(quantity))
                names += (names.empty() ? "" : ", ") + std::string(unit.name);
            return text +
                   " is none of the names that UNITS knows, or the beginning of more than one: " + names;
        },
        "", "");
}

// CLI11 gives the range of a double in all its digits.
CLI::Validator makeCountCheck(int least) {
    return CLI::Validator(
        [=](const std::string& text) {
            int value = 0;
            const bool good = CLI::detail::lexical_cast(text, value) && value >= least;
            return good ? std::string()
                        : fmt::format("{} is not a whole number from {} to {}", text, least, INT_MAX);
        },
        "", "");
}

const CLI::Validator PositiveTime = makeRange(0, 1e100, "a positive time");
const CLI::Validator Accuracy = makeRange(0, 0.1, "between 0 and 0.1");

void addFormulation(CLI::App& command, jprim::Formulation& formulation) {
    static const std::map<std::string, jprim::Formulation> names = {
        {"tree", jprim::Formulation::Tree}, {"constraints", jprim::Formulation::Constraints}};
    command
        .add_option("--formulation", formulation,
                    "How joints are solved: as coordinates of a tree where they can (tree), or all as "
                    "equations (constraints)")
        ->transform(CLI::CheckedTransformer(names).description("{tree,constraints}"))
        ->default_str("tree");
}

void addRunOptions(CLI::App& command, RunArguments& arguments) {
    command.add_option("MODEL", arguments.model, "Adams/Solver dataset (.adm) or command file (.acf)")
        ->required();
    command.add_option("--end", arguments.end, "End time, in the dataset's unit")->check(PositiveTime);
    command.add_flag("--statics", arguments.statics,
                     "Find the static equilibrium; with --end at each output time");
    command.add_option("--start", arguments.start, "Where to start: as given, or at the equilibrium near it")
        ->check(CLI::IsMember({"given", "equilibrium"}))
        ->capture_default_str();
    auto* steps = command.add_option("--steps", arguments.steps, "Number of output steps (100)");
    steps->check(makeCountCheck(1));
    command
        .add_option("--dtout", arguments.dtout,
                    "Length of an output step, in the dataset's unit; the end is written too")
        ->check(PositiveTime)
        ->excludes(steps);
    command
        .add_option("--redundant", arguments.redundant,
                    "Redundant equations: share their load with the others, or drop them as Adams does")
        ->check(CLI::IsMember({"share", "drop"}))
        ->capture_default_str();
    command.add_option("--accuracy", arguments.accuracy, "Relative accuracy of the integration")
        ->check(Accuracy)
        ->capture_default_str();
    command
        .add_option("--constraint-tolerance", arguments.constraintTolerance,
                    "Largest root mean square of constraint errors (a tenth of the accuracy)")
        ->check(Accuracy);
    command
        .add_option("--max-step", arguments.maximumStep,
                    "Longest step of the integration, in the dataset's unit of time")
        ->check(PositiveTime);
    command.add_option("--integrator", arguments.integrator, "Simbody's integrator")
        ->check(CLI::IsMember(jprim::getIntegratorNames()))
        ->capture_default_str();
    addFormulation(command, arguments.formulation);
    command.add_option("--out", arguments.out, "Folder for requests.csv, reactions.csv and parts.csv");
    command.add_option("--report", arguments.report,
                       "HTML file to write: the motion and all curves, to be opened in a browser");
    command.add_flag("--quiet", arguments.quiet, "Print errors and warnings only");
}

// The options of a run as they were given, but for where its results go.
std::vector<std::pair<std::string, std::string>> listOptions(const CLI::App& run) {
    std::vector<std::pair<std::string, std::string>> options;
    for (const CLI::Option* option : run.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || name.rfind("--", 0) != 0 || name == "--out" || name == "--report")
            continue;
        options.emplace_back(name, option->get_expected_max() == 0 ? "" : option->results().back());
    }
    return options;
}

void addReportOptions(CLI::App& command, ReportArguments& arguments) {
    command.add_option("RESULTS", arguments.results, "Folder that run --out has written")->required();
    command.add_option("--model", arguments.model, "The dataset, if it is not where it was");
    command.add_option("-o,--out", arguments.out, "HTML file to write")->required();
}

void addCheckOptions(CLI::App& command, CheckArguments& arguments) {
    command.add_option("MODEL", arguments.model, "Adams/Solver dataset (.adm)")->required();
    addFormulation(command, arguments.formulation);
    command.add_flag("--json", arguments.json, "Print the report as JSON");
}

void addReduceOptions(CLI::App& command, ReduceArguments& arguments) {
    command
        .add_option("MESH", arguments.mesh,
                    "CalculiX input (.inp) with its .sti, .mas and .dof files beside it")
        ->required();
    command
        .add_option("--abaqus", arguments.matrices,
                    "Stiffness and mass matrix of Abaqus; MESH is then Abaqus' input")
        ->expected(2);
    command.add_option("--interface", arguments.interfaces, "Set of nodes that moves as one rigid point")
        ->allow_extra_args(false);
    command.add_option("--length", arguments.lengthUnit, "The mesh's unit of length, as in UNITS")
        ->check(makeUnitCheck(jprim::Quantity::Length))
        ->default_str("METER");
    command
        .add_option("--mass", arguments.massUnit, "The mesh's unit of mass, as in UNITS; time is in seconds")
        ->check(makeUnitCheck(jprim::Quantity::Mass))
        ->capture_default_str();
    command
        .add_option("--modes", arguments.modes,
                    "Number of modes with all interfaces held, or of free modes without interfaces")
        ->required()
        ->check(makeCountCheck(0));
    command.add_option("-o,--out", arguments.out, "File of modes to write")->required();
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Runs Adams/Solver datasets on Simbody.", "jprim");
    app.set_version_flag("--version", "jprim " JPRIM_VERSION);
    app.require_subcommand(1);

    RunArguments runArguments;
    CheckArguments checkArguments;
    ReduceArguments reduceArguments;
    CLI::App* run = app.add_subcommand("run", "Simulate a model");
    CLI::App* check = app.add_subcommand("check", "Read, assemble and count without simulating");
    addRunOptions(*run, runArguments);
    addCheckOptions(*check, checkArguments);
    CLI::App* reduce = app.add_subcommand("reduce", "Reduce a finite-element mesh to modes");
    addReduceOptions(*reduce, reduceArguments);
    ReportArguments reportArguments;
    CLI::App* report = app.add_subcommand("report", "Show the results of an earlier run in a browser");
    addReportOptions(*report, reportArguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        // --help and --version arrive here too, as successes.
        return app.exit(error) == 0 ? jprim::tool::Done : jprim::tool::WrongUsage;
    }
    const std::string& model = run->parsed()      ? runArguments.model
                               : check->parsed()  ? checkArguments.model
                               : reduce->parsed() ? reduceArguments.mesh
                                                  : reportArguments.results;
    runArguments.options = listOptions(*run);
    try {
        const int code = run->parsed()      ? jprim::tool::run(runArguments)
                         : check->parsed()  ? jprim::tool::check(checkArguments)
                         : reduce->parsed() ? jprim::tool::reduce(reduceArguments)
                                            : jprim::tool::report(reportArguments);
        if (std::fflush(stdout) == 0) return code;
        jprim::tool::printError(model, "standard output cannot be written");
    } catch (const std::exception& error) {
        jprim::tool::printError(model, error.what());
    }
    return jprim::tool::SimulationFailed;
}
