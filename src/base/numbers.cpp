// SPDX-License-Identifier: Apache-2.0
#include "base/numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/format.h"
#include "base/text.h"

namespace jprim {
namespace {

constexpr double RadiansPerDegree = 3.14159265358979323846 / 180;

// What is wrong with a text whose first characters are a number and whose `rest` is not.
std::string explainRest(std::string_view text, std::string_view rest, bool angle) {
    const std::string quoted = quote(text);
    if (toUpper(rest.front()) != 'D') return quoted + " is not a number; write it like 1.5 or 1.5E3";
    if (rest.size() > 1) return quoted + " has a D exponent; write E instead, for example 1.0E+3";
    if (!angle) return quoted + " is in degrees (suffix D), but this is not an angle";
    return quoted + " is out of range";
}

}  // namespace

Number<double> parseReal(std::string_view text, bool angle) {
    Number<double> number;
    std::string_view digits = text;
    // from_chars knows no plus sign, but does know "inf" and "nan", which are no numbers here.
    const bool sign = !digits.empty() && (digits.front() == '+' || digits.front() == '-');
    if (sign) digits.remove_prefix(1);
    if (digits.empty() || !(isDigit(digits.front()) || digits.front() == '.')) {
        number.fault = quote(text) + " is not a number; write it like 1.5 or 1.5E3";
        return number;
    }
    const char* const end = digits.data() + digits.size();
    const auto [stop, code] = std::from_chars(digits.data(), end, number.value);
    const std::string_view rest(stop, static_cast<std::size_t>(end - stop));
    const bool degrees = angle && rest.size() == 1 && toUpper(rest.front()) == 'D';
    if (code == std::errc::result_out_of_range || !std::isfinite(number.value))
        number.fault = quote(text) + " is out of range; a number's size is 1E-307 to 1E+308";
    else if (code != std::errc())
        number.fault = quote(text) + " is not a number; write it like 1.5 or 1.5E3";
    else if (!rest.empty() && !degrees)
        number.fault = explainRest(text, rest, angle);
    if (sign && text.front() == '-') number.value = -number.value;
    if (degrees) number.value *= RadiansPerDegree;
    return number;
}

Number<int> parseId(std::string_view text, int least) {
    Number<int> number;
    const bool digits = !text.empty() && std::all_of(text.begin(), text.end(), isDigit);
    const auto code = std::from_chars(text.data(), text.data() + text.size(), number.value).ec;
    if (!digits || (code == std::errc() && number.value < least))
        number.fault = fmt::format("{} is not an id; ids are whole numbers from {}", quote(text), least);
    else if (code != std::errc())
        number.fault =
            fmt::format("{} is out of range; ids go up to {}", quote(text), std::numeric_limits<int>::max());
    return number;
}

}  // namespace jprim
