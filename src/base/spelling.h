// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BASE_SPELLING_H_
#define JPRIM_SRC_BASE_SPELLING_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace jprim {

/// How many single letters must be changed, added or left out to turn one word into the other; case does not
/// matter. Long words are not compared: more than 24 letters count as 24 slips.
std::size_t countSlips(std::string_view a, std::string_view b);

/// "; did you mean NAME?" for the name nearest to a misspelt word, the first of equals; empty if none is near. Of names
/// that differ by their number only, "; there are F1 to F8".
std::string suggestNearest(const std::vector<std::string>& names, std::string_view word);

}  // namespace jprim

#endif
