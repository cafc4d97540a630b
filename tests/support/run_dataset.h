// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_RUN_DATASET_H_
#define JPRIM_TESTS_SUPPORT_RUN_DATASET_H_

#include <gtest/gtest.h>

#include <cstdlib>

#include "jprim/dataset/read_dataset.h"
#include "jprim/mechanism/build_mechanism.h"
#include "jprim/simulation/simulate.h"

namespace jprim::testing {

/// The folder with the tests' datasets and reference figures.
inline std::string getDataFolder() {
    return std::string(JPRIM_SOURCE_DIR) + "/tests/data/";
}

/// How the tests' datasets are solved: by a tree, or as the environment wants it, so that the tests can be run for
/// both.
inline BuildOptions getBuildOptions() {
    const char* wanted = std::getenv("JPRIM_TEST_FORMULATION");
    const bool constraints = wanted && std::string(wanted) == "constraints";
    return {constraints ? Formulation::Constraints : Formulation::Tree};
}

/// The diagnostics as lines of text: "12:3: error: message".
inline std::string formatAll(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& d : diagnostics) text += formatDiagnostic("", d).substr(1) + "\n";
    return text;
}

/// Builds a mechanism from the text of a dataset; the test fails if that gives an error.
inline std::optional<Mechanism> buildFromText(const std::string& text, Diagnostics& diagnostics,
                                              const BuildOptions& options = getBuildOptions()) {
    const Dataset dataset = readDataset(text, diagnostics);
    if (hasErrors(diagnostics)) return std::nullopt;
    return buildMechanism(dataset, diagnostics, options);
}

inline Mechanism buildOrFail(const std::string& text, const BuildOptions& options = getBuildOptions()) {
    Diagnostics diagnostics;
    std::optional<Mechanism> mechanism = buildFromText(text, diagnostics, options);
    if (!mechanism) throw std::runtime_error(formatAll(diagnostics));
    return std::move(*mechanism);
}

inline Mechanism buildFileOrFail(const std::string& path, const BuildOptions& options = getBuildOptions()) {
    Diagnostics diagnostics;
    const Dataset dataset = readDatasetFile(path, diagnostics);
    std::optional<Mechanism> mechanism;
    if (!hasErrors(diagnostics)) mechanism = buildMechanism(dataset, diagnostics, options);
    if (!mechanism) throw std::runtime_error(path + "\n" + formatAll(diagnostics));
    return std::move(*mechanism);
}

/// Assembles and simulates; the test fails if the simulation does.
inline SimulationOutcome run(const Mechanism& mechanism, double end, int steps, double accuracy) {
    SimulationOptions options;
    options.end = end;
    options.steps = steps;
    options.accuracy = accuracy;
    SimulationOutcome outcome = simulate(mechanism, assemble(mechanism), options);
    EXPECT_EQ(outcome.failure, "");
    return outcome;
}

}  // namespace jprim::testing

#endif
