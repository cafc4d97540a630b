// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BASE_NUMBERS_H_
#define JPRIM_SRC_BASE_NUMBERS_H_

#include <string>
#include <string_view>

namespace jprim {

/// A number read from a text, or why it could not be read.
template <class T>
struct Number {
    T value{};
    std::string fault;  ///< empty if the number was read; else it begins with the text in quotes
};

/// A real: `5`, `.5`, `-2.07E+005`. An angle may carry the suffix D, which turns degrees into radians.
Number<double> parseReal(std::string_view text, bool angle);

/// An id: digits, leading zeros allowed, from `least` (0 or 1) up to the largest int.
Number<int> parseId(std::string_view text, int least);

}  // namespace jprim

#endif
