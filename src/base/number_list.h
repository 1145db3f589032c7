#pragma once
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace rayscope::base {

/// `count` finite numbers with the separator between them and nothing else, like "1,2.5,-3"; none if the text
/// has another form.
template <class Number>
std::optional<std::vector<Number>> parseNumbers(std::string_view text, char separator, std::size_t count) {
    std::vector<Number> numbers;
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (;;) {
        Number value{};
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
        numbers.push_back(value);
        at = next;
        if (at == end) break;
        if (*at++ != separator) return std::nullopt;
    }
    if (numbers.size() != count) return std::nullopt;
    return numbers;
}

}  // namespace rayscope::base
