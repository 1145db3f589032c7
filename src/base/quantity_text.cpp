#include "base/quantity_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rayscope::base {

std::string durationText(double seconds) {
    constexpr double kLongest = 1e15;
    if (!(seconds > 0.0)) seconds = 0.0;
    if (seconds < 9.995) return fmt::format("{:.2f} s", seconds);
    if (seconds < 59.5) return fmt::format("{:.0f} s", seconds);
    const std::int64_t whole = std::llround(std::min(seconds, kLongest)), minutes = whole / 60;
    if (minutes < 60) return fmt::format("{} min {:02} s", minutes, whole % 60);
    if (minutes < 48 * 60) return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
    return fmt::format("{} d {:02} h", minutes / (24 * 60), minutes / 60 % 24);
}

std::string byteText(std::uint64_t bytes) {
    if (bytes < 1024) return fmt::format("{} bytes", bytes);
    constexpr std::array kUnits{"KiB", "MiB", "GiB"};
    double value = static_cast<double>(bytes) / 1024.0;
    std::size_t unit = 0;
    for (; value >= 1023.95 && unit + 1 < kUnits.size(); ++unit) value /= 1024.0;
    return fmt::format("{:.1f} {}", value, kUnits[unit]);
}

}  // namespace rayscope::base
