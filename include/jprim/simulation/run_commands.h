// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SIMULATION_RUN_COMMANDS_H_
#define JPRIM_SIMULATION_RUN_COMMANDS_H_

#include <string>
#include <vector>

#include "jprim/dataset/commands.h"
#include "jprim/simulation/simulate.h"

namespace jprim {

/// What one SIMULATE did.
struct CommandSummary {
    std::string command;  ///< "SIMULATE/DYNAMICS"
    double start = 0;     ///< [dataset's unit]
    double end = 0;       ///< where it ended, by itself or by a SENSOR
    SimulationSummary simulation;
};

/// What a command file leaves behind. If a command failed, `failure` names it and why, and the results end
/// there; it is empty otherwise.
struct CommandsOutcome {
    Results results;
    std::vector<CommandSummary> summaries;
    std::vector<MissedCoordinate> yielded;  ///< of the assembly at the start
    std::string failure;
    SourcePosition where;  ///< of the command that failed
};

/// Checks commands against the mechanism they are for. Errors: an element to be switched that there is not, and no
/// SIMULATE at all. A RANGE in which there is none is a warning.
/// @param[out] diagnostics  findings are appended in the order of the commands
void checkCommands(const Mechanism& mechanism, const std::vector<Command>& commands,
                   Diagnostics& diagnostics);

/// Carries out the commands of an Adams command file, one State going through all of them.
/// - DYNAMICS integrates, KINEMATICS needs a mechanism without freedoms, TRANSIENT takes whichever fits
/// - STATICS goes to equilibrium; with an end, at each output time
/// - INITIAL_CONDITIONS assembles and writes one row
/// - ACTIVATE and DEACTIVATE switch constraints, and with the next SIMULATE the mechanism is assembled again
///   close to where it is; and sensors, which ACTIVATE arms
///
/// A sensor that has fired fires again only after it has been false, also in later commands.
///
/// Results run on through all commands. A command that starts where another ended repeats its last row only if
/// constraints were switched in between.
/// @param options  accuracy, integrator and progress, for all commands; times and steps are the commands'
CommandsOutcome runCommands(const Mechanism& mechanism, const std::vector<Command>& commands,
                            const SimulationOptions& options);
/// The same with results that go elsewhere: CommandsOutcome::results stay empty.
CommandsOutcome runCommands(const Mechanism& mechanism, const std::vector<Command>& commands,
                            const SimulationOptions& options, ResultSink& sink);

}  // namespace jprim

#endif
