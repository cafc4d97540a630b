// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>

#include "jprim/build/build_mechanism.h"
#include "jprim/dataset/read_dataset.h"
#include "tool/commands.h"

namespace jprim::tool {

void printError(const std::string& file, const std::string& message) {
    fmt::print(stderr, "{}\n", formatDiagnostic(file, {Severity::Error, {}, message}));
}

std::string getLengthName(const Dataset& dataset) {
    if (dataset.units && !dataset.units->names[2].empty()) return dataset.units->names[2];
    if (dataset.units && dataset.units->system == "MKS") return "METER";
    if (dataset.units && dataset.units->system == "CGS") return "CENTIMETER";
    if (dataset.units && dataset.units->system == "FPS") return "FOOT";
    if (dataset.units && dataset.units->system == "IPS") return "INCH";
    return "length units";
}

Model loadModel(const std::string& path) {
    Model model;
    model.dataset = readDatasetFile(path, model.diagnostics);
    if (!hasErrors(model.diagnostics)) model.mechanism = buildMechanism(model.dataset, model.diagnostics);
    for (const Diagnostic& diagnostic : model.diagnostics)
        fmt::print(stderr, "{}\n", formatDiagnostic(path, diagnostic));
    return model;
}

}  // namespace jprim::tool
