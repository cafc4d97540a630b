// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_VOCABULARY_H_
#define JPRIM_SRC_DATASET_VOCABULARY_H_

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "dataset/text.h"

/// @file
/// Looking up words in a closed list. An entry of a list has a `name` in upper case and a `minimum`: how
/// many letters of it an abbreviation needs. A word written in full always wins.
namespace jprim {

/// For an entry that cannot be abbreviated.
constexpr std::size_t ExactOnly = 99;

/// The plainest entry of a list.
struct Word {
    std::string_view name;
    std::size_t minimum = 1;
};

/// The answer of findWord(): the entry's place in the list, or why there is none.
struct WordMatch {
    std::size_t index = 0;
    bool found = false;
    std::string_view rival;  ///< if the word is ambiguous: the name of a second entry it may stand for
};

template <class List>
WordMatch findWord(const List& list, std::string_view word) {
    WordMatch match;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (!startsWith(list[i].name, word)) continue;
        if (list[i].name.size() == word.size()) return {i, true, {}};
        if (word.size() < list[i].minimum) continue;
        if (match.found)
            match.rival = list[i].name;
        else
            match = {i, true, {}};
    }
    if (!match.rival.empty()) match.found = false;
    return match;
}

/// How many single letters must be changed, added or left out to turn one word into the other; case does
/// not matter. Words longer than any in the language are not compared, so the time is bounded.
std::size_t calcEditDistance(std::string_view a, std::string_view b);

/// "; did you mean NAME?" for the entry nearest to a misspelt word; empty if none is near.
template <class List>
std::string suggestWord(const List& list, std::string_view word) {
    // One slip in a short word, two in a longer one; never so many that nothing of the word is left.
    std::size_t best = std::min<std::size_t>(word.size(), word.size() < 6 ? 2 : 3);
    std::string_view name;
    for (const auto& entry : list) {
        const std::size_t distance = calcEditDistance(entry.name, word);
        if (distance >= best) continue;
        best = distance;
        name = entry.name;
    }
    return name.empty() ? std::string() : "; did you mean " + std::string(name) + "?";
}

}  // namespace jprim

#endif
