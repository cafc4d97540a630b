// SPDX-License-Identifier: Apache-2.0
#include "tool/report.h"

#include <filesystem>
#include <fstream>

#include "base/format.h"
#include "base/read_file.h"
#include "jprim/base/error.h"
#include "jprim/report/write_report.h"
#include "jprim/results/read_results.h"
#include "tool/check_report.h"

namespace jprim::tool {

namespace {

// Ranks take time that is cubic in the number of speeds; beyond this many seconds.
constexpr int MostSpeeds = 600;

void analyze(const Dataset& dataset, ReportNotes& notes) {
    Diagnostics known;  // those of the run's mechanism are the same
    Model model{dataset, {}, buildMechanism(dataset, known, {Formulation::Constraints})};
    if (!model.mechanism) return;
    if (model.mechanism->makeGivenState().getNU() > MostSpeeds) {
        notes.analysis = {"too large to be analysed in passing; `jprim check` does it"};
        return;
    }
    const CheckReport report = makeCheckReport(std::move(model), Formulation::Tree);
    notes.analysis = formatText(report);
    if (report.isUsable()) notes.freedoms = report.constraints.getDegreesOfFreedom();
}

std::string getFileName(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

}  // namespace

bool canReport(const std::string& path) {
    if (path.empty()) return true;
    if (!canWriteReports()) {
        fmt::print(
            stderr,
            "this jprim was built without reports; to build it with them, install node and npm (Debian: "
            "nodejs, npm)\n");
        return false;
    }
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code problem;  // shows when the file is opened
    if (!folder.empty()) std::filesystem::create_directories(folder, problem);
    const bool existed = std::filesystem::exists(path);
    const bool good = std::ofstream(path, std::ios::binary | std::ios::app).good();
    if (!good) printError(path, "cannot be written");
    if (good && !existed) std::filesystem::remove(path);
    return good;
}

void writeModelReport(const Model& model, const std::string& modelFile, const Results& results,
                      const RunRecord& record, const std::string& path) {
    ReportNotes notes;
    notes.file = getFileName(modelFile);
    notes.datasetText = readFile(modelFile).value_or("");
    notes.options = record.options;
    notes.summary = record.log.summary;
    notes.warnings = record.log.messages;
    notes.freedoms = record.log.freedoms;
    analyze(model.dataset, notes);
    writeReport(model.dataset, *model.mechanism, results, path, notes);
}

ExitCode report(const ReportArguments& arguments) {
    if (!canReport(arguments.out)) return WrongUsage;
    const RunRecord record = loadRunRecord(arguments.results);
    const std::string modelFile =
        arguments.model.empty()
            ? (std::filesystem::path(arguments.results) / record.model).lexically_normal().string()
            : arguments.model;
    const Model model = loadModel(modelFile, record.formulation);
    if (!model.mechanism) return DatasetHasErrors;
    if (makeFingerprint(readFile(modelFile).value_or("")) != record.fingerprint)
        fmt::print(stderr, "{}\n",
                   formatDiagnostic(modelFile,
                                    {Severity::Warning, {}, "has changed since the results were written"}));
    writeModelReport(model, modelFile, readResults(arguments.results), record, arguments.out);
    return Done;
}

}  // namespace jprim::tool
