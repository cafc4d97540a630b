// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_TOOL_RUN_LOG_H_
#define JPRIM_SRC_TOOL_RUN_LOG_H_

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jprim/base/diagnostic.h"

namespace jprim::tool {

/// What a run says, while it says it: kept for its report.
class RunLog {
public:
    explicit RunLog(bool quiet) : m_isQuiet(quiet) {}

    /// Prints a line, unless it is to be quiet.
    void addLine(std::string line);
    /// Prints a warning or an error.
    void addMessage(const std::string& file, const Diagnostic& diagnostic);
    /// Of messages that were printed already.
    void keep(const std::string& file, const Diagnostics& diagnostics);

    std::vector<std::string> summary;
    std::vector<std::pair<std::string, Diagnostic>> messages;  ///< with the file that each is about
    std::optional<int> freedoms;                               ///< at the start

private:
    bool m_isQuiet;
};

}  // namespace jprim::tool

#endif
