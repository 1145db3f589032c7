#include "base/parse_float.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace rayscope::base {

namespace {

/// 1.#QNAN, 1.#SNAN00, 1.#IND and 1.#INF00, without their sign.
std::optional<float> parseMicrosoftSpecial(std::string_view word) {
    constexpr std::string_view kPrefix = "1.#";
    if (!word.starts_with(kPrefix)) return {};
    word.remove_prefix(kPrefix.size());
    while (word.ends_with('0')) word.remove_suffix(1);
    if (word == "INF" || word == "inf") return std::numeric_limits<float>::infinity();
    for (const std::string_view name : {"QNAN", "qnan", "SNAN", "snan", "IND", "ind"})
        if (word == name) return std::numeric_limits<float>::quiet_NaN();
    return {};
}

/// The result of an out-of-range conversion: the double tells overflow from underflow, except beyond its own
/// range.
float outOfRange(std::string_view word) {
    double value = 0.0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc{}) return static_cast<float>(value);
    const std::size_t exponent = word.find_first_of("eE");
    const bool isTiny = exponent != std::string_view::npos && word.substr(exponent + 1).starts_with('-');
    return isTiny ? 0.0f : std::numeric_limits<float>::infinity();
}

}  // namespace

std::optional<float> parseFloat(std::string_view word) {
    const bool isNegative = word.starts_with('-');
    if (isNegative || word.starts_with('+')) word.remove_prefix(1);
    if (word.empty() || word.front() == '-' || word.front() == '+') return {};
    float value = 0.0f;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (stop != end) {
        const std::optional<float> special = parseMicrosoftSpecial(word);
        if (!special) return {};
        value = *special;
    } else if (error == std::errc::result_out_of_range) {
        value = outOfRange(word);
    } else if (error != std::errc{}) {
        return {};
    }
    return isNegative ? -value : value;
}

}  // namespace rayscope::base
