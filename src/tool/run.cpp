// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <memory>

#include "base/format.h"
#include "jprim/base/error.h"
#include "jprim/results/csv_files.h"
#include "jprim/simulation/equilibrium.h"
#include "jprim/simulation/run_commands.h"
#include "tool/commands.h"
#include "tool/progress_bar.h"

namespace jprim::tool {

namespace {

void printSummary(const Model& model, const SimulationSummary& s) {
    const UnitSystem& units = model.mechanism->getUnits();
    const double energy = units.getEnergy();
    fmt::print("degrees of freedom       {}\n", s.degreesOfFreedom);
    if (s.redundantEquations > 0) fmt::print("redundant equations      {}\n", s.redundantEquations);
    for (const std::string& equation : s.droppedEquations)
        fmt::print("dropped                  {}\n", equation);
    for (const DroppedAnew& anew : s.droppedAnew)
        fmt::print("dropped from {:<11.6g} {}\n", anew.time, join(anew.equations, "; "));
    fmt::print("worst constraint error   {:.3g} {}, {:.3g} rad{}\n", s.worstViolation.length / units.length,
               getLengthName(model.dataset), s.worstViolation.angle,
               s.worstViolation.element.empty() ? "" : fmt::format(" (at {})", s.worstViolation.element));
    const auto ofRange = [&s](double change) {
        return s.energyScale > 0
                   ? fmt::format(" ({:.2g} of the kinetic energy's range)", change / s.energyScale)
                   : "";
    };
    fmt::print("energy                   {:.9g} at the start, changed by at most {:.3g}{}\n",
               s.energyAtStart / energy, s.largestEnergyChange / energy, ofRange(s.largestEnergyChange));
    if (!model.mechanism->isConservative() && s.largestImbalance > 0)
        fmt::print("energy balance           off by at most {:.3g}{}\n", s.largestImbalance / energy,
                   ofRange(s.largestImbalance));
    fmt::print("{:<25}{}\n", s.isKinematic ? "kinematic steps" : "integration steps", s.stepsTaken);
    if (!s.endedBy.empty()) fmt::print("ended by                 {}\n", s.endedBy);
    fmt::print("wall time                {:.3f} s\n", s.wallSeconds);
}

// Energy that nothing explains is an error of the integration.
void warnOfEnergyError(const RunArguments& arguments, const Mechanism& mechanism,
                       const SimulationSummary& summary) {
    if (summary.largestImbalance <= summary.tolerableImbalance) return;
    const std::string message = fmt::format(
        "{} by {:.2g} of the range of its kinetic energy; do not trust the results, and try a smaller --accuracy",
        mechanism.isConservative()
            ? "the energy of this conservative mechanism changed"
            : "the energy of this mechanism is not what the work of its loads makes it: it is off",
        summary.largestImbalance / summary.energyScale);
    fmt::print(stderr, "{}\n", formatDiagnostic(arguments.model, {Severity::Warning, {}, message}));
}

void warnOfNotFinite(const RunArguments& arguments, const SimulationSummary& summary) {
    for (const NotFinite& first : summary.notFinite) {
        const std::string message =
            fmt::format("{}: {} is {} at time {}, and perhaps later", first.request, first.column,
                        std::isnan(first.value) ? "not a number" : "infinite", first.time);
        fmt::print(stderr, "{}\n", formatDiagnostic(arguments.model, {Severity::Warning, {}, message}));
    }
}

SimulationOptions makeOptions(const RunArguments& arguments, ProgressBar& bar) {
    SimulationOptions options;
    options.kind = arguments.statics ? SimulationKind::Statics : SimulationKind::Automatic;
    if (arguments.redundant == "drop") options.redundancy = Redundancy::Drop;
    options.end = arguments.end;
    if (arguments.end == 0)
        options.steps = 0;
    else if (arguments.steps > 0)
        options.steps = arguments.steps;
    if (arguments.dtout > 0) options.outputStep = arguments.dtout;
    options.accuracy = arguments.accuracy;
    options.constraintTolerance = arguments.constraintTolerance;
    if (arguments.maximumStep) options.maximumStep = *arguments.maximumStep;
    options.integrator = arguments.integrator;
    options.reportProgress = [&bar](double fraction) { bar.update(fraction); };
    return options;
}

/// For a run without --out.
class NoResults final : public ResultSink {
public:
    void begin(const ResultColumns&) override {}
    void add(const ResultRow&) override {}
};

// Before the simulation, not after it, is the time to learn that nothing can be written.
std::unique_ptr<ResultSink> makeSink(const std::string& folder) {
    if (folder.empty()) return std::make_unique<NoResults>();
    return std::make_unique<CsvFiles>(folder);
}

SimulationOutcome simulateModel(const RunArguments& arguments, const Mechanism& mechanism, ResultSink& sink) {
    AssembledState initial = assemble(mechanism);
    warnOfYielded(arguments.model, mechanism, initial.yielded);
    if (arguments.start == "equilibrium") initial.state = findEquilibrium(mechanism, initial.state);
    ProgressBar bar(!arguments.quiet);
    return simulate(mechanism, initial, makeOptions(arguments, bar), sink);
}

// What the arguments lack or have too much of, or empty.
std::string findMisuse(const RunArguments& arguments) {
    if (isCommandFile(arguments.model)) {
        const bool given = arguments.end > 0 || arguments.steps > 0 || arguments.dtout > 0 ||
                           arguments.statics || arguments.start != "given";
        return given
                   ? "a command file says itself what to simulate; --end, --steps, --dtout, --statics and --start "
                     "are for datasets"
                   : "";
    }
    return arguments.end == 0 && !arguments.statics ? "--end is required" : "";
}

void printResultsLine(const RunArguments& arguments) {
    if (!arguments.quiet && !arguments.out.empty())
        fmt::print("results                  requests.csv, reactions.csv and parts.csv in {}\n",
                   arguments.out);
}

ExitCode runDataset(const RunArguments& arguments) {
    const Model model = loadModel(arguments.model, arguments.formulation);
    if (!model.mechanism) return DatasetHasErrors;
    SimulationOutcome outcome;
    try {
        const std::unique_ptr<ResultSink> sink = makeSink(arguments.out);
        outcome = simulateModel(arguments, *model.mechanism, *sink);
        if (!outcome.failure.empty()) printError(arguments.model, outcome.failure);
    } catch (const std::exception& error) {
        printError(arguments.model, error.what());
        return SimulationFailed;
    }
    if (!arguments.quiet) printSummary(model, outcome.summary);
    printResultsLine(arguments);
    warnOfEnergyError(arguments, *model.mechanism, outcome.summary);
    warnOfNotFinite(arguments, outcome.summary);
    return outcome.failure.empty() ? Done : SimulationFailed;
}

ExitCode runCommandFile(const RunArguments& arguments) {
    const LoadedCommands loaded = loadCommands(arguments.model, arguments.formulation);
    if (!loaded.isUsable) return DatasetHasErrors;
    RunArguments used = arguments;
    if (used.out.empty()) used.out = loaded.file.output;
    CommandsOutcome outcome;
    try {
        const std::unique_ptr<ResultSink> sink = makeSink(used.out);
        ProgressBar bar(!used.quiet);
        outcome = runCommands(*loaded.model.mechanism, loaded.file.commands, makeOptions(used, bar), *sink);
        warnOfYielded(used.model, *loaded.model.mechanism, outcome.yielded);
        if (!outcome.failure.empty())
            fmt::print(stderr, "{}\n",
                       formatDiagnostic(used.model, {Severity::Error, outcome.where, outcome.failure}));
    } catch (const std::exception& error) {
        printError(used.model, error.what());
        return SimulationFailed;
    }
    for (const CommandSummary& summary : outcome.summaries) {
        if (!used.quiet) {
            fmt::print("{} from {} to {}\n", summary.command, summary.start, summary.end);
            printSummary(loaded.model, summary.simulation);
        }
        warnOfEnergyError(used, *loaded.model.mechanism, summary.simulation);
        warnOfNotFinite(used, summary.simulation);
    }
    printResultsLine(used);
    return outcome.failure.empty() ? Done : SimulationFailed;
}

}  // namespace

ExitCode run(const RunArguments& arguments) {
    const std::string misuse = findMisuse(arguments);
    if (!misuse.empty()) {
        fmt::print(stderr, "{}\nRun with --help for more information.\n", misuse);
        return WrongUsage;
    }
    return isCommandFile(arguments.model) ? runCommandFile(arguments) : runDataset(arguments);
}

}  // namespace jprim::tool
