// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <variant>

#include "base/format.h"
#include "jprim/dataset/read_dataset.h"
#include "jprim/mechanism/find_mistakes.h"
#include "jprim/simulation/run_commands.h"
#include "tool/commands.h"

namespace jprim::tool {

namespace {

void print(const std::string& file, const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics)
        fmt::print(stderr, "{}\n", formatDiagnostic(file, diagnostic));
}

}  // namespace

void printError(const std::string& file, const std::string& message) {
    fmt::print(stderr, "{}\n", formatDiagnostic(file, {Severity::Error, {}, message}));
}

Diagnostics listYielded(const Mechanism& mechanism, const std::vector<MissedCoordinate>& yielded) {
    Diagnostics warnings;
    for (const MissedCoordinate& missed : yielded)
        warnings.push_back(
            {Severity::Warning,
             {},
             fmt::format(
                 "{}: {} contradicts a MOTION, an initial value or a joint and yields to it: it starts {} away "
                 "from its given value",
                 missed.element, missed.coordinate, formatAmount(missed, mechanism.getUnits()))});
    return warnings;
}

std::string getLengthName(const Dataset& dataset) {
    const std::string unnamed = "length units";
    if (!dataset.units) return unnamed;
    const UnitsStatement& units = *dataset.units;
    if (!units.names[2].empty()) return units.names[2];
    if (units.system.empty() || units.system == "NONE") return unnamed;
    for (const Unit& unit : getUnits(Quantity::Length))
        if (unit.inSI == units.toSI.length) return std::string(unit.name);
    return unnamed;
}

Model loadModel(const std::string& path, Formulation formulation) {
    Model model;
    model.dataset = readDatasetFile(path, model.diagnostics);
    if (hasErrors(model.diagnostics))
        findMistakes(model.dataset, model.diagnostics);
    else
        model.mechanism = buildMechanism(model.dataset, model.diagnostics, {formulation});
    print(path, model.diagnostics);
    return model;
}

bool isCommandFile(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return ending == ".acf";
}

LoadedCommands loadCommands(const std::string& path, Formulation formulation) {
    LoadedCommands loaded;
    loaded.file = readCommandFile(path, loaded.diagnostics);
    print(path, loaded.diagnostics);
    if (hasErrors(loaded.diagnostics)) return loaded;
    std::filesystem::path model = std::filesystem::path(loaded.file.folder) / loaded.file.model;
    if (!model.has_extension()) model += ".adm";
    const auto switchesConstraints = [](const Command& command) {
        const auto* const activate = std::get_if<ActivateCommand>(&command);
        return activate && isConstraint(activate->kind);
    };
    if (std::any_of(loaded.file.commands.begin(), loaded.file.commands.end(), switchesConstraints))
        formulation = Formulation::Constraints;
    loaded.formulation = formulation;
    loaded.modelFile = model.string();
    loaded.model = loadModel(loaded.modelFile, formulation);
    if (loaded.model.mechanism) {
        Diagnostics found;
        checkCommands(*loaded.model.mechanism, loaded.file.commands, found);
        print(path, found);
        loaded.diagnostics.insert(loaded.diagnostics.end(), found.begin(), found.end());
        loaded.isUsable = !hasErrors(found);
    }
    return loaded;
}

}  // namespace jprim::tool
