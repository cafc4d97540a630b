// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_LANGUAGE_WORDS_H_
#define JPRIM_SRC_DATASET_LANGUAGE_WORDS_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/spelling.h"
#include "base/text.h"

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

/// "; did you mean NAME?" for the entry nearest to a misspelt word; empty if none is near.
template <class List>
std::string suggestWord(const List& list, std::string_view word) {
    std::vector<std::string> names;
    for (const auto& entry : list) names.emplace_back(entry.name);
    return suggestNearest(names, word);
}

}  // namespace jprim

#endif
