// SPDX-License-Identifier: Apache-2.0
#include "dataset/vocabulary.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace jprim {

std::size_t calcEditDistance(std::string_view a, std::string_view b) {
    constexpr std::size_t longest = 24;
    if (a.size() > longest || b.size() > longest) return longest;
    // row[j]: distance between the part of a seen so far and the first j letters of b.
    std::array<std::size_t, longest + 1> row;
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (toUpper(a[i]) == toUpper(b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace jprim
