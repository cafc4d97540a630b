// SPDX-License-Identifier: Apache-2.0
#include "base/format.h"

#include <fmt/format-inl.h>

// What fmt declares to be compiled elsewhere.
FMT_BEGIN_NAMESPACE
namespace detail {
template auto thousands_sep_impl<char>(locale_ref) -> thousands_sep_result<char>;
template auto decimal_point_impl<char>(locale_ref) -> char;
}  // namespace detail
FMT_END_NAMESPACE

namespace jprim {

void appendFormatted(std::string& text, fmt::string_view format, fmt::format_args arguments) {
    fmt::vformat_to(std::back_inserter(text), format, arguments);
}

}  // namespace jprim
