#include "base/byte_size.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/lower_case.h"
#include "base/parse_number.h"

namespace rayscope::base {

namespace {

/// The factor of "k", "kb" or "kib"; 0 if the text is no unit.
double factorOf(std::string_view unit) {
    constexpr std::string_view kPrefixes = "kmgt";
    const std::size_t power = unit.empty() ? std::string_view::npos : kPrefixes.find(unit[0]);
    if (power == std::string_view::npos) return 0.0;
    const std::string_view rest = unit.substr(1);
    if (rest == "b") return std::pow(1000.0, static_cast<double>(power + 1));
    return rest.empty() || rest == "ib" ? std::exp2(10.0 * static_cast<double>(power + 1)) : 0.0;
}

}  // namespace

std::string byteSizeText(std::uint64_t bytes) {
    constexpr std::array<std::string_view, 6> kUnits{"kB", "MB", "GB", "TB", "PB", "EB"};
    if (bytes < 1000) return fmt::format("{} bytes", bytes);
    double value = static_cast<double>(bytes) * 1e-3;
    std::size_t unit = 0;
    for (; value >= 999.5; ++unit) value *= 1e-3;
    return value < 9.95 ? fmt::format("{:.1f} {}", value, kUnits[unit])
                        : fmt::format("{:.0f} {}", value, kUnits[unit]);
}

std::optional<std::uint64_t> parseByteSize(std::string_view text) {
    const std::size_t digits = std::min(text.find_first_not_of("0123456789."), text.size());
    const std::optional<double> number = parseReal<double>(text.substr(0, digits));
    std::string_view unit = text.substr(digits);
    if (unit.starts_with(' ')) unit.remove_prefix(1);
    const double factor = factorOf(lowerCase(std::string(unit)));
    if (!number || factor == 0.0) return std::nullopt;
    const double bytes = *number * factor;
    if (!(bytes >= 1.0 && bytes <= 0x1p63)) return std::nullopt;
    return static_cast<std::uint64_t>(bytes);
}

}  // namespace rayscope::base
