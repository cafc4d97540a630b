// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_TOOL_RUN_RECORD_H_
#define JPRIM_SRC_TOOL_RUN_RECORD_H_

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jprim/mechanism/build_mechanism.h"
#include "tool/run_log.h"

namespace jprim::tool {

/// run.json beside the results of a run: which model they are of, and what was said.
struct RunRecord {
    std::string model;        ///< the dataset, relative to the folder of the results
    std::string fingerprint;  ///< of its text
    Formulation formulation = Formulation::Tree;
    std::vector<std::pair<std::string, std::string>> options;
    RunLog log{true};
};

/// Tells one text from another.
std::string makeFingerprint(const std::string& text);

/// @throws Error if it cannot be written
void saveRunRecord(const RunRecord& record, const std::string& folder);
/// @throws Error if there is none or it cannot be understood
RunRecord loadRunRecord(const std::string& folder);

}  // namespace jprim::tool

#endif
