// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "base/format.h"
#include "jprim/simulation/equilibrium.h"
#include "jprim/simulation/run_commands.h"
#include "tool/commands.h"
#include "tool/progress_bar.h"
#include "tool/report.h"
#include "tool/run_log.h"
#include "tool/run_output.h"

namespace jprim::tool {

namespace {

std::vector<std::string> formatSummary(const Model& model, const SimulationSummary& s) {
    const UnitSystem& units = model.mechanism->getUnits();
    const double energy = units.getEnergy();
    std::vector<std::string> lines;
    const auto add = [&lines](const std::string& label, const std::string& value) {
        lines.push_back(fmt::format("{:<25}{}", label, value));
    };
    add("degrees of freedom", std::to_string(s.degreesOfFreedom));
    if (s.redundantEquations > 0) add("redundant equations", std::to_string(s.redundantEquations));
    for (const std::string& equation : s.droppedEquations) add("dropped", equation);
    for (const DroppedAnew& anew : s.droppedAnew)
        add(fmt::format("dropped from {:<11.6g}", anew.time), join(anew.equations, "; "));
    add("worst constraint error",
        fmt::format(
            "{:.3g} {}, {:.3g} rad{}", s.worstViolation.length / units.length, getLengthName(model.dataset),
            s.worstViolation.angle,
            s.worstViolation.element.empty() ? "" : fmt::format(" (at {})", s.worstViolation.element)));
    const auto ofRange = [&s](double change) {
        return s.energyScale > 0
                   ? fmt::format(" ({:.2g} of the kinetic energy's range)", change / s.energyScale)
                   : "";
    };
    add("energy", fmt::format("{:.9g} at the start, changed by at most {:.3g}{}", s.energyAtStart / energy,
                              s.largestEnergyChange / energy, ofRange(s.largestEnergyChange)));
    if (!model.mechanism->isConservative() && s.largestImbalance > 0)
        add("energy balance",
            fmt::format("off by at most {:.3g}{}", s.largestImbalance / energy, ofRange(s.largestImbalance)));
    add(s.isKinematic ? "kinematic steps" : "integration steps", std::to_string(s.stepsTaken));
    if (!s.endedBy.empty()) add("ended by", s.endedBy);
    add("wall time", fmt::format("{:.3f} s", s.wallSeconds));
    return lines;
}

// Energy that nothing explains is an error of the integration.
void warnOfEnergyError(const std::string& file, const Mechanism& mechanism, const SimulationSummary& summary,
                       RunLog& log) {
    if (summary.largestImbalance <= summary.tolerableImbalance) return;
    log.addMessage(
        file,
        {Severity::Warning,
         {},
         fmt::format(
             "{} by {:.2g} of the range of its kinetic energy; do not trust the results, and try a smaller "
             "--accuracy",
             mechanism.isConservative() ? "the energy of this conservative mechanism changed"
                                        : "the energy of this mechanism is not what the work of its loads "
                                          "makes it: it is off",
             summary.largestImbalance / summary.energyScale)});
}

void warnOfNotFinite(const std::string& file, const SimulationSummary& summary, RunLog& log) {
    for (const NotFinite& first : summary.notFinite)
        log.addMessage(file,
                       {Severity::Warning,
                        {},
                        fmt::format("{}: {} is {} at time {}, and perhaps later", first.request, first.column,
                                    std::isnan(first.value) ? "not a number" : "infinite", first.time)});
}

void addOutcome(const Model& model, const SimulationSummary& summary, RunLog& log) {
    for (const std::string& line : formatSummary(model, summary)) log.addLine(line);
    if (!log.freedoms) log.freedoms = summary.degreesOfFreedom;
}

void warn(const std::string& file, const Model& model, const SimulationSummary& summary, RunLog& log) {
    warnOfEnergyError(file, *model.mechanism, summary, log);
    warnOfNotFinite(file, summary, log);
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

SimulationOutcome simulateModel(const RunArguments& arguments, const Mechanism& mechanism, ResultSink& sink,
                                RunLog& log) {
    AssembledState initial = assemble(mechanism);
    for (const Diagnostic& yielded : listYielded(mechanism, initial.yielded))
        log.addMessage(arguments.model, yielded);
    if (arguments.start == "equilibrium") initial.state = findEquilibrium(mechanism, initial.state);
    ProgressBar bar(!arguments.quiet);
    return simulate(mechanism, initial, makeOptions(arguments, bar), sink);
}

// What the arguments lack or have too much of, or empty.
std::string findMisuse(const RunArguments& arguments) {
    if (isCommandFile(arguments.model)) {
        const bool given = arguments.end > 0 || arguments.steps > 0 || arguments.dtout > 0 ||
                           arguments.statics || arguments.start != "given";
        if (given)
            return "a command file says itself what to simulate; --end, --steps, --dtout, --statics and --start are for "
                   "datasets";
    } else if (arguments.end == 0 && !arguments.statics) {
        return "--end is required";
    }
    return "";
}

ExitCode runDataset(const RunArguments& arguments) {
    const Model model = loadModel(arguments.model, arguments.formulation);
    if (!model.mechanism) return DatasetHasErrors;
    RunLog log(arguments.quiet);
    log.keep(arguments.model, model.diagnostics);
    try {
        RunOutput output(arguments, arguments.model, log);
        const SimulationOutcome outcome = simulateModel(arguments, *model.mechanism, output, log);
        if (!outcome.failure.empty()) log.addMessage(arguments.model, {Severity::Error, {}, outcome.failure});
        addOutcome(model, outcome.summary, log);
        warn(arguments.model, model, outcome.summary, log);
        output.finish(model, arguments.formulation);
        return outcome.failure.empty() ? Done : SimulationFailed;
    } catch (const std::exception& error) {
        printError(arguments.model, error.what());
        return SimulationFailed;
    }
}

void addOutcomes(const RunArguments& arguments, const Model& model, const CommandsOutcome& outcome,
                 RunLog& log) {
    for (const Diagnostic& yielded : listYielded(*model.mechanism, outcome.yielded))
        log.addMessage(arguments.model, yielded);
    if (!outcome.failure.empty())
        log.addMessage(arguments.model, {Severity::Error, outcome.where, outcome.failure});
    for (const CommandSummary& summary : outcome.summaries) {
        log.addLine(fmt::format("{} from {} to {}", summary.command, summary.start, summary.end));
        addOutcome(model, summary.simulation, log);
        warn(arguments.model, model, summary.simulation, log);
    }
}

ExitCode runCommandFile(const RunArguments& arguments) {
    const LoadedCommands loaded = loadCommands(arguments.model, arguments.formulation);
    if (!loaded.isUsable) return DatasetHasErrors;
    RunArguments used = arguments;
    if (used.out.empty()) used.out = loaded.file.output;
    RunLog log(used.quiet);
    log.keep(used.model, loaded.diagnostics);
    log.keep(loaded.modelFile, loaded.model.diagnostics);
    try {
        RunOutput output(used, loaded.modelFile, log);
        ProgressBar bar(!used.quiet);
        const CommandsOutcome outcome =
            runCommands(*loaded.model.mechanism, loaded.file.commands, makeOptions(used, bar), output);
        bar.clear();
        addOutcomes(used, loaded.model, outcome, log);
        output.finish(loaded.model, loaded.formulation);
        return outcome.failure.empty() ? Done : SimulationFailed;
    } catch (const std::exception& error) {
        printError(used.model, error.what());
        return SimulationFailed;
    }
}

}  // namespace

ExitCode run(const RunArguments& arguments) {
    const std::string misuse = findMisuse(arguments);
    if (!misuse.empty()) {
        fmt::print(stderr, "{}\nRun with --help for more information.\n", misuse);
        return WrongUsage;
    }
    if (!canReport(arguments.report)) return WrongUsage;
    return isCommandFile(arguments.model) ? runCommandFile(arguments) : runDataset(arguments);
}

}  // namespace jprim::tool
