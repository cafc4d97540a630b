// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_REPORTER_H_
#define JPRIM_SRC_MECHANISM_REPORTER_H_

#include <functional>
#include <string>

#include "jprim/base/diagnostic.h"

namespace jprim {

/// Collects what is found wrong while a dataset is built. A mistake is noted and what it concerns is built in some way or
/// left out, so that all mistakes are found.
class Reporter {
public:
    explicit Reporter(Diagnostics& diagnostics) : m_diagnostics(diagnostics) {}

    void addWarning(const SourcePosition& where, const std::string& message) {
        m_diagnostics.push_back({Severity::Warning, where, message});
    }
    void addError(const SourcePosition& where, const std::string& message) {
        m_hasErrors = true;
        m_diagnostics.push_back({Severity::Error, where, message});
    }
    [[nodiscard]] bool hasErrors() const { return m_hasErrors; }

    /// Does what may throw; a mistake is reported at the function or the statement it is in.
    /// @returns false if it has thrown
    bool attempt(const std::string& element, const SourcePosition& where, const std::function<void()>& build);

private:
    Diagnostics& m_diagnostics;
    bool m_hasErrors = false;
};

}  // namespace jprim

#endif
