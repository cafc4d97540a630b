// SPDX-License-Identifier: Apache-2.0
#include "jprim/base/diagnostic.h"

#include <algorithm>

#include "base/format.h"

namespace jprim {

bool hasErrors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

std::string formatDiagnostic(const std::string& file, const Diagnostic& diagnostic) {
    const char* word = diagnostic.severity == Severity::Error ? "error" : "warning";
    if (diagnostic.where.line == 0) return fmt::format("{}: {}: {}", file, word, diagnostic.message);
    return fmt::format("{}:{}:{}: {}: {}", file, diagnostic.where.line, diagnostic.where.column, word,
                       diagnostic.message);
}

}  // namespace jprim
