// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_TOOL_REPORT_H_
#define JPRIM_SRC_TOOL_REPORT_H_

#include <string>

#include "jprim/results/results.h"
#include "tool/commands.h"
#include "tool/run_record.h"

namespace jprim::tool {

/// Whether a report can be written to this file, or to none; if not, says why. To be asked before anything takes time.
bool canReport(const std::string& path);

/// Writes what happened to a model that was read from a file.
void writeModelReport(const Model& model, const std::string& modelFile, const Results& results,
                      const RunRecord& record, const std::string& path);

}  // namespace jprim::tool

#endif
