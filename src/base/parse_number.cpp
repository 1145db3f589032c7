#include "base/parse_number.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace rayscope::base {

namespace {

constexpr std::string_view kDigits = "0123456789";

/// Whether the value of a decimal number without sign is below 1.
bool isBelowOne(std::string_view number) {
    const std::size_t mark = number.find_first_of("eE");
    std::int64_t exponent = 0;
    if (mark != std::string_view::npos) {
        const std::string_view digits = number.substr(mark + 1);
        // Beyond the range of the integer only its sign matters.
        exponent = parseInteger<std::int64_t>(digits).value_or(
            digits.starts_with('-') ? std::numeric_limits<std::int64_t>::min() / 2
                                    : std::numeric_limits<std::int64_t>::max() / 2);
    }
    const std::string_view mantissa = number.substr(0, mark);
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    const std::size_t first = mantissa.find_first_of("123456789");
    if (first == std::string_view::npos) return true;
    const auto magnitude = first < point ? static_cast<std::int64_t>(point - first)
                                         : -static_cast<std::int64_t>(first - point - 1);
    return magnitude + exponent <= 0;
}

}  // namespace

template <class Real>
std::optional<Real> parseReal(std::string_view text) {
    const bool isNegative = text.starts_with('-');
    if (isNegative || text.starts_with('+')) text.remove_prefix(1);
    // Excludes a second sign and the words of NaN and infinity.
    const std::string_view digits = text.starts_with('.') ? text.substr(1) : text;
    if (digits.empty() || kDigits.find(digits[0]) == std::string_view::npos) return std::nullopt;
    Real value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size()) return std::nullopt;
    if (error == std::errc::result_out_of_range)
        value = isBelowOne(text) ? Real(0) : std::numeric_limits<Real>::infinity();
    else if (error != std::errc{})
        return std::nullopt;
    return isNegative ? -value : value;
}

template std::optional<float> parseReal(std::string_view text);
template std::optional<double> parseReal(std::string_view text);

}  // namespace rayscope::base
