// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_BASE_DIAGNOSTIC_H_
#define JPRIM_BASE_DIAGNOSTIC_H_

#include <string>
#include <vector>

namespace jprim {

/// Where something stands in a text. Both count from 1; 0 means "no position".
struct SourcePosition {
    int line = 0;
    int column = 0;
};

/// How serious a diagnostic is. Only errors keep a dataset from being used.
enum class Severity { Warning, Error };

/// One finding about an input, as data: nothing in the library prints.
struct Diagnostic {
    Severity severity = Severity::Error;
    SourcePosition where;
    std::string message;
};

/// All findings about one input, in the order they were made.
using Diagnostics = std::vector<Diagnostic>;

/// True if at least one of the findings is an error.
bool hasErrors(const Diagnostics& diagnostics);

/// One line in the form compilers use: `file:line:column: error: message`. A diagnostic without a
/// position gives `file: error: message`.
std::string formatDiagnostic(const std::string& file, const Diagnostic& diagnostic);

}  // namespace jprim

#endif
