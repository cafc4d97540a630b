// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_TOOL_PROGRESS_BAR_H_
#define JPRIM_SRC_TOOL_PROGRESS_BAR_H_

#include <unistd.h>

#include <cstdio>
#include <string>

#include "base/format.h"

namespace jprim::tool {

/// A bar on standard error that redraws itself in place; silent unless that is a terminal.
class ProgressBar {
public:
    explicit ProgressBar(bool wanted) : m_shown(wanted && isatty(STDERR_FILENO) != 0) {}
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void update(double fraction) {
        const int percent = int(100 * fraction);
        if (!m_shown || percent == m_percent) return;
        m_percent = percent;
        const int filled = percent * Width / 100;
        fmt::print(stderr, "\r[{}{}] {:3d} %", std::string(filled, '#'), std::string(Width - filled, ' '),
                   percent);
        std::fflush(stderr);
    }

    /// Leaves an empty line for what comes next.
    void clear() {
        if (m_shown && m_percent >= 0) fmt::print(stderr, "\r{}\r", std::string(Width + 9, ' '));
        m_percent = -1;
    }

private:
    static constexpr int Width = 50;
    bool m_shown;
    int m_percent = -1;
};

}  // namespace jprim::tool

#endif
