// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_SPELLING_TABLE_H_
#define JPRIM_SRC_DATASET_SPELLING_TABLE_H_

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "dataset/language/words.h"

namespace jprim {

/// Adams' words for the values of an enumeration, or of a bool.
template <class Enum>
class SpellingTable {
public:
    struct Entry {
        Enum value;
        std::string_view name;
        std::size_t minimum = 1;  ///< letters that an abbreviation needs
    };

    SpellingTable(std::initializer_list<Entry> entries) {
        for (const Entry& entry : entries) {
            m_words.push_back({entry.name, entry.minimum});
            m_values.push_back(entry.value);
        }
    }

    const std::vector<Word>& getWords() const { return m_words; }
    Enum getValue(std::size_t word) const { return m_values[word]; }
    /// The word in full; empty for a value that is said by no word.
    std::string_view getName(Enum value) const {
        const auto found = std::find(m_values.begin(), m_values.end(), value);
        return found == m_values.end() ? ""
                                       : m_words[static_cast<std::size_t>(found - m_values.begin())].name;
    }

private:
    std::vector<Word> m_words;
    std::vector<Enum> m_values;
};

}  // namespace jprim

#endif
