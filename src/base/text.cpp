// SPDX-License-Identifier: Apache-2.0
#include "base/text.h"

#include <algorithm>

namespace jprim {

std::string toUpperCase(std::string_view text) {
    std::string upper(text);
    for (char& c : upper) c = toUpper(c);
    return upper;
}

std::string_view trim(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

std::string collapseBlanks(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    bool gap = false;
    for (const char c : text) {
        if (isBlank(c) || c == '\n') {
            gap = !result.empty();
            continue;
        }
        if (gap) result += ' ';
        gap = false;
        result += c;
    }
    return result;
}

bool startsWith(std::string_view word, std::string_view prefix) {
    return prefix.size() <= word.size() &&
           std::equal(prefix.begin(), prefix.end(), word.begin(),
                      [](char a, char b) { return toUpper(a) == toUpper(b); });
}

std::string quote(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string result = "'";
    for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
    return result + (text.size() > longest ? "...'" : "'");
}

}  // namespace jprim
