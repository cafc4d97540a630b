// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_DATASET_COMMANDS_H_
#define JPRIM_DATASET_COMMANDS_H_

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "jprim/base/diagnostic.h"
#include "jprim/dataset/dataset.h"
#include "jprim/dataset/element_id.h"

/// @file
/// A command file of Adams/Solver (.acf) as plain values: which model to load, and what to do with it.
/// Times are in the model's own unit.
namespace jprim {

enum class Analysis {
    Dynamics,
    Kinematics,
    Statics,
    Transient,  ///< Kinematics of a model without freedoms, Dynamics of any other
    InitialConditions
};

/// SIMULATE. Statics has either neither times nor steps, which asks for the equilibrium now, or both, as
/// Dynamics, Kinematics and Transient always have: exactly one of `end` and `duration`, and exactly one of
/// `steps` and `dtout`. InitialConditions has none of them.
struct SimulateCommand {
    SourcePosition where;
    Analysis analysis = Analysis::Dynamics;
    std::optional<double> end;       ///< END: the time at the end, positive, from the beginning of all
    std::optional<double> duration;  ///< DURATION: the time from here to the end, positive
    std::optional<int> steps;        ///< STEPS: how many equal output steps, at least 1
    /// DTOUT: the size of an output step, positive. The end is written too, after a shorter step if need be.
    std::optional<double> dtout;
    /// How far InitialConditions go: to displacements, also to velocities, also to accelerations.
    KinematicLevel level = KinematicLevel::Acceleration;
};

/// The ids from `first` to `last`, both included. One id if they are equal; else those of them that exist.
struct IdRange {
    int first = 0;
    int last = 0;
};

/// ACTIVATE or DEACTIVATE. It takes effect with the next SIMULATE.
struct ActivateCommand {
    SourcePosition where;
    bool active = true;  ///< false for DEACTIVATE
    ElementKind kind = ElementKind::Jprim;
    std::vector<IdRange> ids;  ///< as ID and RANGE name them; at least one
};

using Command = std::variant<SimulateCommand, ActivateCommand>;

/// A whole command file, up to STOP, EXIT or the end of the text.
struct CommandFile {
    std::string folder;  ///< of the file that was read by readCommandFile(), else empty
    std::string model;   ///< as written; Adams starts from the folder and adds .adm to a bare name
    std::string output;  ///< first part of the names of result files; that of the model if none is given
    std::vector<Command> commands;
    std::vector<IgnoredStatement> ignored;  ///< INTEGRATOR and the like, which only tune the solver
};

/// Reads the text of a command file. It names its model and output in one of two ways: as its first two
/// lines, or by FILE/MODEL=name, OUTPUT_PREFIX=name as its first command. The rules of the language are those of
/// a dataset; like readDataset() it never stops at the first mistake and never throws on account of the text.
///
/// @param      text         the whole file
/// @param[out] diagnostics  findings are appended in the order of the file
/// @returns what could be read; use it only if there is no error among the diagnostics
CommandFile readCommands(std::string_view text, Diagnostics& diagnostics);

/// Reads commands from a file and notes the file's folder. A file that cannot be read is one error without
/// position.
CommandFile readCommandFile(const std::string& path, Diagnostics& diagnostics);

/// Adams' word for an analysis, in full: "INITIAL_CONDITIONS".
const char* getAdamsName(Analysis analysis);

}  // namespace jprim

#endif
