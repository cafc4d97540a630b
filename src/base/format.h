// SPDX-License-Identifier: Apache-2.0
// fmt, compiled once, in format.cpp: this header parses in a tenth of a second where fmt/format.h, header-only, takes
// three. It is in a namespace of its own, so that nothing of it meets the fmt of a program that uses jprim.
#ifndef JPRIM_SRC_BASE_FORMAT_H_
#define JPRIM_SRC_BASE_FORMAT_H_

#define FMT_BEGIN_NAMESPACE \
    namespace fmt {         \
    inline namespace in_jprim {
#define FMT_END_NAMESPACE \
    }                     \
    }
#include <fmt/core.h>

#include <string>
#include <string_view>

namespace jprim {

void appendFormatted(std::string& text, fmt::string_view format, fmt::format_args arguments);

/// Appends what fmt::format() makes of the arguments.
template <class... Arguments>
void appendText(std::string& text, fmt::format_string<Arguments...> format, const Arguments&... arguments) {
    appendFormatted(text, format, fmt::make_format_args(arguments...));
}

/// The elements as text, with the separator between each two.
template <class Range>
std::string join(const Range& elements, std::string_view separator) {
    std::string text;
    bool isFirst = true;
    for (const auto& element : elements) {
        if (!isFirst) text += separator;
        isFirst = false;
        appendText(text, "{}", element);
    }
    return text;
}

}  // namespace jprim

#endif
