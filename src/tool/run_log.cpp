// SPDX-License-Identifier: Apache-2.0
#include "tool/run_log.h"

#include <cstdio>

#include "base/format.h"

namespace jprim::tool {

void RunLog::addLine(std::string line) {
    if (!m_isQuiet) fmt::print("{}\n", line);
    summary.push_back(std::move(line));
}

void RunLog::addMessage(const std::string& file, const Diagnostic& diagnostic) {
    fmt::print(stderr, "{}\n", formatDiagnostic(file, diagnostic));
    messages.emplace_back(file, diagnostic);
}

void RunLog::keep(const std::string& file, const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) messages.emplace_back(file, diagnostic);
}

}  // namespace jprim::tool
