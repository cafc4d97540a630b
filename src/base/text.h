// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BASE_TEXT_H_
#define JPRIM_SRC_BASE_TEXT_H_

#include <string>
#include <string_view>

namespace jprim {

// Own tests instead of <cctype>: the same in every locale, and defined for bytes above 127.
inline bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}
inline bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
inline bool isLetter(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
inline bool isWordCharacter(char c) {
    return isLetter(c) || isDigit(c) || c == '_';
}
inline char toUpper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string toUpperCase(std::string_view text);

/// The text without the blanks at both ends.
std::string_view trim(std::string_view text);

/// The text with every run of blanks and line marks as one space, and none at the ends.
std::string collapseBlanks(std::string_view text);

/// True if `prefix` begins `word`; case does not matter.
bool startsWith(std::string_view word, std::string_view prefix);

/// The text in quotes for a message: cut when long, bytes outside printable ASCII shown as `?`.
std::string quote(std::string_view text);

}  // namespace jprim

#endif
