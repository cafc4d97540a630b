// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_TOOL_RUN_OUTPUT_H_
#define JPRIM_SRC_TOOL_RUN_OUTPUT_H_

#include <memory>
#include <string>

#include "jprim/results/csv_files.h"
#include "jprim/results/results.h"
#include "tool/commands.h"
#include "tool/run_record.h"

namespace jprim::tool {

/// Where a run's rows go and what is written of it: files of numbers, a report, both or nothing.
class RunOutput final : public ResultSink {
public:
    /// Before the simulation, not after it, is the time to learn that nothing can be written.
    /// @param modelFile  the dataset; lives as long as this, as arguments and log do
    /// @throws Error if a file cannot be written
    RunOutput(const RunArguments& arguments, const std::string& modelFile, RunLog& log);

    void begin(const ResultColumns& columns) override;
    void add(const ResultRow& row) override;

    /// Writes what can be written only now, and says where. @throws Error if a file cannot be written
    void finish(const Model& model, Formulation formulation);

private:
    RunRecord makeRecord(Formulation formulation) const;

    const RunArguments& m_arguments;
    const std::string& m_modelFile;
    RunLog& m_log;
    std::unique_ptr<CsvFiles> m_files;
    Results m_results;
    std::unique_ptr<ResultMemory> m_memory;  // of a run with a report
};

}  // namespace jprim::tool

#endif
