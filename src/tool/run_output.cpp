// SPDX-License-Identifier: Apache-2.0
#include "tool/run_output.h"

#include <cstdio>
#include <filesystem>

#include "base/format.h"
#include "base/read_file.h"
#include "tool/report.h"

namespace jprim::tool {

namespace fs = std::filesystem;

RunOutput::RunOutput(const RunArguments& arguments, const std::string& modelFile, RunLog& log)
    : m_arguments(arguments), m_modelFile(modelFile), m_log(log) {
    if (!arguments.out.empty()) {
        m_files = std::make_unique<CsvFiles>(arguments.out);
        saveRunRecord(makeRecord(arguments.formulation), arguments.out);
    }
    if (!arguments.report.empty()) m_memory = std::make_unique<ResultMemory>(m_results);
}

void RunOutput::begin(const ResultColumns& columns) {
    if (m_files) m_files->begin(columns);
    if (m_memory) m_memory->begin(columns);
}

void RunOutput::add(const ResultRow& row) {
    if (m_files) m_files->add(row);
    if (m_memory) m_memory->add(row);
}

RunRecord RunOutput::makeRecord(Formulation formulation) const {
    RunRecord record;
    if (m_files)
        record.model =
            fs::proximate(fs::absolute(m_modelFile), fs::absolute(m_arguments.out)).generic_string();
    record.fingerprint = makeFingerprint(readFile(m_modelFile).value_or(""));
    record.formulation = formulation;
    record.options = m_arguments.options;
    record.log = m_log;
    return record;
}

void RunOutput::finish(const Model& model, Formulation formulation) {
    const RunRecord record = makeRecord(formulation);
    if (m_files) {
        saveRunRecord(record, m_arguments.out);
        if (!m_arguments.quiet)
            fmt::print("results                  requests.csv, reactions.csv and parts.csv in {}\n",
                       m_arguments.out);
    }
    if (!m_memory) return;
    writeModelReport(model, m_modelFile, m_results, record, m_arguments.report);
    if (!m_arguments.quiet) fmt::print("report                   {}\n", m_arguments.report);
}

}  // namespace jprim::tool
