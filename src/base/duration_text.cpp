#include "base/duration_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

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

}  // namespace rayscope::base
