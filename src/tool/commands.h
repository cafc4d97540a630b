// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_TOOL_COMMANDS_H_
#define JPRIM_SRC_TOOL_COMMANDS_H_

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jprim/base/diagnostic.h"
#include "jprim/dataset/commands.h"
#include "jprim/mechanism/build_mechanism.h"
#include "jprim/simulation/assemble.h"

namespace jprim::tool {

/// Exit codes of the command.
enum ExitCode { Done = 0, SimulationFailed = 1, WrongUsage = 2, DatasetHasErrors = 3 };

struct RunArguments {
    std::string model;  ///< dataset (.adm) or command file (.acf)
    bool statics = false;
    std::string start = "given";      ///< or "equilibrium"
    std::string redundant = "share";  ///< or "drop"
    double end = 0;                   ///< 0 if not given
    int steps = 0;
    double dtout = 0;
    double accuracy = 1e-6;
    std::optional<double> constraintTolerance;
    std::optional<double> maximumStep;
    std::string integrator = "RungeKuttaMerson";
    Formulation formulation = Formulation::Tree;
    std::string out;
    std::string report;
    std::vector<std::pair<std::string, std::string>> options;  ///< as they were given
    bool quiet = false;
};

struct ReportArguments {
    std::string results;  ///< folder that `run --out` wrote
    std::string model;    ///< dataset, where it is not where it was
    std::string out;
};

struct CheckArguments {
    std::string model;
    Formulation formulation = Formulation::Tree;
    bool json = false;
};

struct ReduceArguments {
    std::string mesh;
    std::vector<std::string> matrices;      ///< of Abaqus: stiffness, mass; else CalculiX'
    std::optional<std::string> lengthUnit;  ///< the mesh's, METER if not given; the file of modes is in SI
    std::string massUnit = "KILOGRAM";
    std::vector<std::string> interfaces;
    int modes = 0;
    std::string out;
};

ExitCode run(const RunArguments& arguments);
ExitCode report(const ReportArguments& arguments);
ExitCode check(const CheckArguments& arguments);
ExitCode reduce(const ReduceArguments& arguments);

/// A model as far as it could be loaded.
struct Model {
    Dataset dataset;
    Diagnostics diagnostics;
    std::optional<Mechanism> mechanism;  ///< empty if there are errors
};

/// Reads and builds a model, printing all its diagnostics to standard error.
Model loadModel(const std::string& path, Formulation formulation);

/// A command file and the model it names, as far as they could be loaded.
struct LoadedCommands {
    CommandFile file;
    Diagnostics diagnostics;  ///< of the command file
    std::string modelFile;
    Formulation formulation = Formulation::Tree;  ///< that it was built in
    Model model;
    bool isUsable = false;  ///< there are no errors in either, and the commands fit the model
};

/// True of a name that ends in .acf, in any case.
bool isCommandFile(const std::string& path);

/// Reads a command file, and reads and builds its model, printing all diagnostics to standard error. Commands
/// that switch elements need Formulation::Constraints and get it.
LoadedCommands loadCommands(const std::string& path, Formulation formulation);

/// What a length is called in the dataset: "MILLIMETER", or "length units" where it names none.
std::string getLengthName(const Dataset& dataset);

/// Warnings of EXACT coordinates that yielded.
Diagnostics listYielded(const Mechanism& mechanism, const std::vector<MissedCoordinate>& yielded);

/// Prints one `file: error: message` line to standard error.
void printError(const std::string& file, const std::string& message);

}  // namespace jprim::tool

#endif
