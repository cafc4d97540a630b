// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "jprim/base/error.h"
#include "jprim/simulation/simulate.h"
#include "tool/commands.h"
#include "tool/progress_bar.h"

namespace jprim::tool {

namespace {

void printSummary(const Model& model, const SimulationOutcome& outcome) {
    const SimulationSummary& s = outcome.summary;
    const UnitSystem& units = model.mechanism->getUnits();
    const double energy = units.getEnergy();
    fmt::print("degrees of freedom       {}\n", s.degreesOfFreedom);
    if (s.redundantEquations > 0) fmt::print("redundant equations      {}\n", s.redundantEquations);
    fmt::print("worst constraint error   {:.3g} {}, {:.3g} rad{}\n", s.worstViolation.length / units.length,
               getLengthName(model.dataset), s.worstViolation.angle,
               s.worstViolation.element.empty() ? "" : fmt::format(" (at {})", s.worstViolation.element));
    fmt::print("energy                   {:.9g} at the start, changed by at most {:.3g}",
               s.energyAtStart / energy, s.largestEnergyChange / energy);
    if (s.energyScale > 0)
        fmt::print(" ({:.2g} of the kinetic energy's range)", s.largestEnergyChange / s.energyScale);
    fmt::print("\nintegration steps        {}\n", s.stepsTaken);
    fmt::print("wall time                {:.3f} s\n", s.wallSeconds);
}

// An output step that does not divide the run leaves its end out; better to say so before a long run.
std::optional<int> chooseSteps(const RunArguments& arguments) {
    if (arguments.dtout == 0) return arguments.steps > 0 ? arguments.steps : SimulationOptions().steps;
    const double steps = std::round(arguments.end / arguments.dtout);
    if (!(steps >= 1 && steps <= 1e9) ||
        std::abs(steps * arguments.dtout - arguments.end) > 1e-9 * arguments.end)
        return std::nullopt;
    return int(steps);
}

// Without damping a changed energy is an error of the integration.
void warnOfEnergyError(const RunArguments& arguments, const Mechanism& mechanism,
                       const SimulationSummary& summary) {
    constexpr double Tolerable = 1e-3;
    if (!mechanism.isConservative()) return;
    if (summary.largestEnergyChange <= Tolerable * summary.energyScale) return;
    const std::string message = fmt::format(
        "the energy of this conservative mechanism changed by {:.2g} of the range of its kinetic energy; "
        "do not trust the results, and try a smaller --accuracy",
        summary.largestEnergyChange / summary.energyScale);
    fmt::print(stderr, "{}\n", formatDiagnostic(arguments.model, {Severity::Warning, {}, message}));
}

SimulationOutcome simulateModel(const RunArguments& arguments, const Mechanism& mechanism, int steps) {
    const AssembledState initial = assemble(mechanism);
    ProgressBar bar(!arguments.quiet);
    SimulationOptions options;
    options.end = arguments.end;
    options.steps = steps;
    options.accuracy = arguments.accuracy;
    options.integrator = arguments.integrator;
    options.reportProgress = [&bar](double fraction) { bar.update(fraction); };
    return simulate(mechanism, initial, options);
}

}  // namespace

ExitCode run(const RunArguments& arguments) {
    const std::optional<int> steps = chooseSteps(arguments);
    if (!steps) {
        fmt::print(stderr,
                   "--end {} is not a multiple of --dtout {}\nRun with --help for more information.\n",
                   arguments.end, arguments.dtout);
        return WrongUsage;
    }
    const Model model = loadModel(arguments.model);
    if (!model.mechanism) return DatasetHasErrors;

    SimulationOutcome outcome;
    try {
        // Before the simulation, not after it, is the time to learn that nothing can be written.
        if (!arguments.out.empty()) writeResults(outcome.results, arguments.out);
        outcome = simulateModel(arguments, *model.mechanism, *steps);
        if (!outcome.failure.empty()) printError(arguments.model, outcome.failure);
        if (!arguments.out.empty()) writeResults(outcome.results, arguments.out);
    } catch (const std::exception& error) {
        printError(arguments.model, error.what());
        return SimulationFailed;
    }
    if (!arguments.quiet) printSummary(model, outcome);
    if (!arguments.quiet && !arguments.out.empty())
        fmt::print("results                  requests.csv, reactions.csv and parts.csv in {}\n",
                   arguments.out);
    warnOfEnergyError(arguments, *model.mechanism, outcome.summary);
    return outcome.failure.empty() ? Done : SimulationFailed;
}

}  // namespace jprim::tool
