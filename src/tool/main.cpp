// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "jprim/simulation/simulate.h"
#include "jprim/version.h"
#include "tool/commands.h"

namespace {

using jprim::tool::CheckArguments;
using jprim::tool::RunArguments;

void addRunOptions(CLI::App& command, RunArguments& arguments) {
    command.add_option("MODEL", arguments.model, "Adams/Solver dataset (.adm)")->required();
    command.add_option("--end", arguments.end, "End time, in the dataset's unit")
        ->required()
        ->check(CLI::PositiveNumber);
    auto* steps = command.add_option("--steps", arguments.steps, "Number of output steps (100)");
    steps->check(CLI::PositiveNumber);
    command.add_option("--dtout", arguments.dtout, "Length of an output step, in the dataset's unit")
        ->check(CLI::PositiveNumber)
        ->excludes(steps);
    command.add_option("--accuracy", arguments.accuracy, "Relative accuracy of the integration")
        ->check(CLI::Range(1e-14, 0.1))
        ->capture_default_str();
    command.add_option("--integrator", arguments.integrator, "Simbody's integrator")
        ->check(CLI::IsMember(jprim::getIntegratorNames()))
        ->capture_default_str();
    command.add_option("--out", arguments.out, "Folder for requests.csv, reactions.csv and parts.csv");
    command.add_flag("--quiet", arguments.quiet, "Print errors and warnings only");
}

void addCheckOptions(CLI::App& command, CheckArguments& arguments) {
    command.add_option("MODEL", arguments.model, "Adams/Solver dataset (.adm)")->required();
    command.add_flag("--json", arguments.json, "Print the report as JSON");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Runs Adams/Solver datasets on Simbody.", "jprim");
    app.set_version_flag("--version", "jprim " JPRIM_VERSION);
    app.require_subcommand(1);

    RunArguments runArguments;
    CheckArguments checkArguments;
    CLI::App* run = app.add_subcommand("run", "Simulate a model");
    CLI::App* check = app.add_subcommand("check", "Read, assemble and count without simulating");
    addRunOptions(*run, runArguments);
    addCheckOptions(*check, checkArguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        // --help and --version arrive here too, as successes.
        return app.exit(error) == 0 ? jprim::tool::Done : jprim::tool::WrongUsage;
    }
    return run->parsed() ? jprim::tool::run(runArguments) : jprim::tool::check(checkArguments);
}
