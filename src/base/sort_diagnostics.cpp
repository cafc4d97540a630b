// SPDX-License-Identifier: Apache-2.0
#include "base/sort_diagnostics.h"

#include <algorithm>
#include <tuple>

namespace jprim {

void sortByPosition(std::size_t first, Diagnostics& diagnostics) {
    std::stable_sort(diagnostics.begin() + static_cast<std::ptrdiff_t>(first), diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) {
                         return std::tie(a.where.line, a.where.column) <
                                std::tie(b.where.line, b.where.column);
                     });
}

}  // namespace jprim
