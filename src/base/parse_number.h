#pragma once
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace rayscope::base {

/// The number nearest to the decimal number that the whole text spells, with an optional sign, point and
/// exponent; infinite beyond the range of the type, zero or subnormal below it. Nothing if the text is
/// anything else: NaN and infinity in words, hexadecimal digits, blanks and separators are not numbers.
/// `Real` is float or double.
template <class Real>
std::optional<Real> parseReal(std::string_view text);

/// The integer that the whole text spells in decimal digits with an optional sign. Nothing if it is anything
/// else or beyond the range of the type.
template <class Integer>
std::optional<Integer> parseInteger(std::string_view text) {
    if (text.starts_with('+') && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
    Integer value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

}  // namespace rayscope::base
