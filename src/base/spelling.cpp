// SPDX-License-Identifier: Apache-2.0
#include "base/spelling.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/text.h"

namespace jprim {

std::size_t countSlips(std::string_view a, std::string_view b) {
    constexpr std::size_t longest = 24;
    if (std::max(a.size(), b.size()) > longest) return longest;
    // slips[j]: between the letters of a so far and the first j of b.
    std::size_t slips[longest + 1];
    std::iota(slips, slips + b.size() + 1, std::size_t(0));
    for (const char letter : a) {
        std::size_t before = slips[0]++;  // of a without this letter and b without letter j
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = before + (toUpper(letter) != toUpper(b[j - 1]));
            before = slips[j];
            slips[j] = std::min({changed, slips[j] + 1, slips[j - 1] + 1});
        }
    }
    return slips[b.size()];
}

namespace {

// "F" and 9 of F9; 0 if no number ends it.
std::pair<std::string, int> splitNumber(std::string_view word) {
    std::size_t end = word.size();
    while (end > 0 && isDigit(word[end - 1])) --end;
    int number = 0;
    for (std::size_t k = end; k < std::min(word.size(), end + 3); ++k) number = 10 * number + (word[k] - '0');
    return {toUpperCase(word.substr(0, end)), number};
}

// "; there are F1 to F8" for a word that differs from such names by its number only: none of them is nearer.
std::string suggestNumbers(const std::vector<std::string>& names, std::string_view word) {
    const auto [stem, own] = splitNumber(word);
    int least = 0, most = 0;
    for (const std::string& name : names) {
        const auto [other, number] = splitNumber(name);
        if (other != stem || number == 0) continue;
        least = least == 0 ? number : std::min(least, number);
        most = std::max(most, number);
    }
    return own == 0 || least == most
               ? ""
               : "; there are " + stem + std::to_string(least) + " to " + stem + std::to_string(most);
}

}  // namespace

std::string suggestNearest(const std::vector<std::string>& names, std::string_view word) {
    std::string numbers = suggestNumbers(names, word);
    if (!numbers.empty()) return numbers;
    // One slip in a short word, two in a longer one; never so many that nothing of the word is left.
    std::size_t least = std::min<std::size_t>(word.size(), word.size() < 6 ? 2 : 3);
    const std::string* nearest = nullptr;
    for (const std::string& name : names) {
        const std::size_t slips = countSlips(name, word);
        if (slips >= least) continue;
        least = slips;
        nearest = &name;
    }
    return nearest ? "; did you mean " + *nearest + "?" : "";
}

}  // namespace jprim
